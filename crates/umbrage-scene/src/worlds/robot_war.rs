//! Two armies of robots on 1.44 km² of gently rolling ground: many still casters at random places, near and far.

use glam::{Vec2, Vec3};
use noise_functions::{Noise as _, Perlin};

use super::picture::picture;
use super::stage::{Room, Stage, View, standing};
use crate::Scene;
use crate::actors::robots;
use crate::paint::Paint;
use crate::shape::Ground;

const VIEW: View = View { fov_degrees: 60.0, near: 1.0, far: 800.0 };
const SIDE: f32 = 1200.0;
const ROBOTS: usize = 160;
const TRIANGLES: usize = 240_000;
/// Where the main camera stands; no robot does.
const OUTLOOK: Vec2 = Vec2::new(-14.0, 170.0);

/// Where the close and the dueling cameras stand; no robot does.
const LOW: Vec2 = Vec2::new(0.0, 66.0);

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::new("robot-war", seed, VIEW, Vec3::new(0.78, -0.55, 0.3));
    let kinds: Vec<_> = [Paint::Blue, Paint::Red].into_iter().flat_map(robots::all).collect();
    let per_army = kinds.len() / 2;
    let army: usize = kinds[..per_army].iter().map(|(_, model)| model.triangles()).sum();
    let ground = Ground::new(SIDE, TRIANGLES.saturating_sub(ROBOTS / per_army * army), |p| {
        6.0 * Perlin.frequency(1.0 / 260.0).seed(seed as i32).sample2(p.to_array())
    });
    let dust = stage.textured(picture("dust", 512, SIDE, |p| {
        let mottled = |size: f32| Perlin.fbm(4, 0.5, 2.0).frequency(1.0 / size).seed(7).sample2(p.to_array());
        Vec3::new(0.36, 0.27, 0.18)
            .lerp(Vec3::new(0.22, 0.19, 0.14), (0.5 + mottled(90.0) * 1.4).clamp(0.0, 1.0))
    }));
    stage.ground(&ground.primitives(dust, 1.0));
    let meshes: Vec<usize> = kinds.iter().map(|(name, model)| stage.mesh(name, model)).collect();

    let mut room = Room::default();
    room.take(OUTLOOK.x, OUTLOOK.y, 22.0);
    room.take(OUTLOOK.x, OUTLOOK.y - 24.0, 6.0);
    room.take(LOW.x, LOW.y, 10.0);
    for i in 0..ROBOTS {
        let dice = &mut stage.dice;
        let red = i % 2;
        // Every second pair is in the thick of it, the others anywhere on their side.
        let (depth, width) = if i / 2 % 2 == 0 { (85.0, 170.0) } else { (580.0, 580.0) };
        let place = room.find(8.0, || {
            let (behind, across) = (dice.between(6.0, depth), dice.between(-width, width));
            Vec2::new(if red == 1 { behind } else { -behind }, across)
        });
        let facing = if red == 1 { -1.0 } else { 1.0 } * std::f32::consts::FRAC_PI_2;
        let yaw = facing + dice.between(-0.5, 0.5);
        let size = dice.between(0.9, 1.1);
        let mesh = meshes[red * per_army + i / 4 % per_army];
        stage.place(mesh, standing(ground.at(place.x, place.y), yaw, size));
    }
    cameras(&mut stage, &ground);
    stage.scene
}

fn cameras(stage: &mut Stage, ground: &Ground) {
    let at = |x: f32, up: f32, z: f32| ground.at(x, z) + Vec3::Y * up;
    stage.look("main", at(OUTLOOK.x, 15.0, OUTLOOK.y), at(8.0, 2.0, 60.0));
    stage.look_far(at(-330.0, 260.0, 480.0), at(0.0, 0.0, 30.0));
    stage.look("close", at(LOW.x, 5.0, LOW.y), at(22.0, 0.0, 40.0));
    stage.look("split", at(-4.0, 3.0, 205.0), at(-4.0, 4.0, -100.0));
    stage.look_into_light(at(LOW.x, 6.0, LOW.y), 11.0);
    stage.fly(&[
        (at(OUTLOOK.x, 15.0, OUTLOOK.y), at(8.0, 2.0, 60.0)),
        (at(-60.0, 22.0, 160.0), at(60.0, 4.0, 0.0)),
        (at(0.0, 20.0, 80.0), at(120.0, 4.0, -60.0)),
        (at(90.0, 22.0, 0.0), at(60.0, 4.0, -160.0)),
        (at(60.0, 24.0, -120.0), at(-80.0, 4.0, -180.0)),
        (at(-60.0, 30.0, -160.0), at(-120.0, 4.0, 0.0)),
        (at(-160.0, 40.0, -40.0), at(0.0, 4.0, 60.0)),
    ]);
}
