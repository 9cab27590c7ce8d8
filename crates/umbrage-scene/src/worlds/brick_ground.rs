//! Still and turning things over 200 m of brick: the fine repeated pattern shows every fault of a shadow's edge.

use glam::{Vec2, Vec3};
use noise_functions::{Noise as _, Value};

use super::picture::picture;
use super::stage::{Room, Stage, View, standing};
use crate::actors::craft;
use crate::shape::Ground;
use crate::{Scene, Texture};

const VIEW: View = View { fov_degrees: 45.0, near: 0.5, far: 200.0 };
const SIDE: f32 = 200.0;
/// How often the picture of bricks repeats along a side: each is 2 m.
const REPEATS: f32 = 100.0;

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::new("brick-ground", seed, VIEW, Vec3::new(0.62, -0.5, -0.45));
    let brick = stage.textured(bricks());
    stage.ground(&Ground::new(SIDE, 4608, |_| 0.0).primitives(brick, REPEATS));
    let mut room = Room::default();
    craft_in_the_air(&mut stage, &mut room);
    things_on_the_ground(&mut stage, &mut room);
    cameras(&mut stage);
    stage.scene
}

/// A fighter that circles, a helicopter that hovers with a turning rotor, three spinning saucers.
fn craft_in_the_air(stage: &mut Stage, room: &mut Room) {
    let fighter = stage.mesh("fighter", &craft::fighter());
    stage.place_marching(fighter, Vec3::new(0.0, 11.0, -6.0), 17.0, 2.6, 1.0, 9.0);
    let (body, rotor) =
        (stage.mesh("helicopter", &craft::helicopter()), stage.mesh("rotor", &craft::rotor()));
    let hover = Vec3::new(9.0, 4.2, 2.0);
    let hub = hover + Vec3::Y * craft::MAST;
    stage.place(body, standing(hover, -2.2, 1.0));
    stage.place_rotating(rotor, standing(hub, 0.3, 1.0), hub, Vec3::Y, 9.0);
    let ufo = stage.mesh("ufo", &craft::ufo());
    for (x, y, z, size) in [(-9.0, 5.0, -4.0, 0.9), (-26.0, 9.0, -32.0, 1.6), (22.0, 7.0, -38.0, 1.2)] {
        let at = Vec3::new(x, y, z);
        let spin = stage.dice.between(0.6, 1.4);
        stage.place_rotating(ufo, standing(at, 0.0, size), at, Vec3::Y, spin);
        room.take(x, z, 4.0);
    }
}

/// Soldiers, crates in stacks, road cones.
fn things_on_the_ground(stage: &mut Stage, room: &mut Room) {
    let soldier = stage.mesh("soldier", &craft::soldier());
    let guard = Vec3::new(-1.5, 0.0, 7.0);
    stage.place_rotating(soldier, standing(guard, -0.4, 1.4), guard, Vec3::Y, 0.5);
    room.take(guard.x, guard.z, 2.5);
    // The low cameras see far along these lines.
    room.take(-4.0, 14.0, 3.0);
    room.take(-14.0, 5.0, 3.0);
    let (crates, pylon) = (stage.mesh("crate", &craft::crate_box()), stage.mesh("pylon", &craft::pylon()));
    for i in 0..46 {
        let dice = &mut stage.dice;
        let spread = if i < 24 { 18.0 } else { 70.0 };
        let place =
            room.find(1.6, || Vec2::new(dice.between(-spread, spread), dice.between(-spread, spread * 0.6)));
        let (yaw, size) = (dice.angle(), dice.between(0.8, 1.7));
        let at = Vec3::new(place.x, 0.0, place.y);
        match i % 4 {
            0 | 1 => stage.place(crates, standing(at, yaw, size)),
            2 => {
                stage.place(crates, standing(at, yaw, size));
                stage.place(crates, standing(at + Vec3::Y * size, yaw + 0.5, size * 0.75));
            }
            _ if i % 8 == 3 => stage.place(soldier, standing(at, yaw, 1.25)),
            _ => stage.place(pylon, standing(at, yaw, 1.4)),
        }
    }
}

/// 2 m of running bond, which tiles: eight courses of four bricks, with mortar.
fn bricks() -> Texture {
    const SIZE_PX: u32 = 256;
    let mortar = Vec3::new(0.40, 0.37, 0.33);
    picture("bricks", SIZE_PX, 2.0, |p| {
        let course = (p.y + 1.0) * 4.0;
        let along = (p.x + 1.0) * 2.0 + 0.5 * (course as i32 % 2) as f32;
        let (u, w) = (along.fract(), course.fract());
        // Distances to the joints, metres.
        let joint = (u.min(1.0 - u) * 0.5).min(w.min(1.0 - w) * 0.25);
        let tone = Value.seed(course as i32).sample2([(along as i32 % 4) as f32, 0.0]) * 0.5 + 0.5;
        let grain = Value.frequency(40.0).sample2(p.to_array()) * 0.04;
        let clay = Vec3::new(0.36, 0.13, 0.08).lerp(Vec3::new(0.52, 0.24, 0.14), tone) + grain;
        mortar.lerp(clay, ((joint - 0.008) / 0.008).clamp(0.0, 1.0))
    })
}

fn cameras(stage: &mut Stage) {
    let v = Vec3::new;
    stage.look("main", v(-8.0, 6.0, 25.0), v(1.0, 3.0, 0.0));
    stage.look_far(v(-50.0, 60.0, 95.0), v(0.0, 0.0, -8.0));
    stage.look("close", v(-4.0, 1.9, 14.0), v(0.2, 0.2, 5.5));
    stage.look("split", v(-14.0, 1.2, 5.0), v(12.0, 1.6, -12.0));
    stage.look_into_light(v(14.0, 1.2, -8.0), 11.0);
    stage.fly(&[
        (v(-8.0, 6.0, 25.0), v(1.0, 3.0, 0.0)),
        (v(2.0, 2.5, 20.0), v(3.0, 3.0, 0.0)),
        (v(20.0, 3.0, 12.0), v(3.0, 3.0, -4.0)),
        (v(26.0, 8.0, -12.0), v(0.0, 2.0, -4.0)),
        (v(2.0, 12.0, -30.0), v(0.0, 2.0, 0.0)),
        (v(-24.0, 7.0, -10.0), v(0.0, 2.0, 2.0)),
        (v(-20.0, 3.0, 12.0), v(2.0, 3.0, 0.0)),
        (v(-8.0, 6.0, 25.0), v(1.0, 3.0, 0.0)),
    ]);
}
