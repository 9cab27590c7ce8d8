//! An open-pit mine in the hills, 2.56 km²: terraces under a low sun, with windmills, clawbots, rocks and pines.
//!
//! The land itself is in `terrain.rs`; here is who stands on it.

mod terrain;

use std::f32::consts::TAU;

use glam::{Mat4, Vec2, Vec3};

use super::stage::{Room, Stage, View, standing};
use crate::Scene;
use crate::actors::{mine, plants};
use crate::shape::{Ground, Model};
use terrain::{FLOOR_RADIUS, PADS, PIT, PIT_RADIUS, SIDE, Terrain};

const VIEW: View = View { fov_degrees: 60.0, near: 1.0, far: 1000.0 };
const TRIANGLES: usize = 1_300_000;
const CLAWBOTS: usize = 10;
const WINDMILLS: usize = 15;
const ROCKS: usize = 20;
const TREES: usize = 10;

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::new("mining-terrain", seed, VIEW, Vec3::new(0.80, -0.53, 0.36));
    let bot = mine::clawbot();
    let windmill = [mine::windmill_tower(), mine::windmill_rotor()];
    let rocks = mine::rock(&mut stage.dice);
    let pine = plants::pine(&mut stage.dice);
    let casters = CLAWBOTS * bot.triangles()
        + WINDMILLS * windmill.iter().map(Model::triangles).sum::<usize>()
        + ROCKS * rocks.triangles()
        + TREES * pine.triangles();
    let terrain = Terrain::new(seed as i32);
    let ground = Ground::new(SIDE, TRIANGLES.saturating_sub(casters), |p| terrain.height(p));
    let earth = stage.textured(terrain.picture(&ground));
    stage.ground(&ground.primitives(earth, 1.0));
    place_clawbots(&mut stage, &ground, &bot);
    place_windmills(&mut stage, &ground, &windmill);
    place_rocks_and_trees(&mut stage, &ground, &rocks, &pine);
    cameras(&mut stage, &ground);
    stage.scene
}

/// Six on the floor of the pit and one on each pad, walking in circles, since both are level.
fn place_clawbots(stage: &mut Stage, ground: &Ground, bot: &Model) {
    let bot = stage.mesh("clawbot", bot);
    let on_floor = CLAWBOTS - PADS.len();
    for i in 0..CLAWBOTS {
        let (centre, radius, angle) = match i.checked_sub(on_floor) {
            Some(pad) => (PADS[pad], 15.0, stage.dice.angle()),
            None => {
                (PIT, FLOOR_RADIUS * 0.52, (i as f32 + stage.dice.between(0.0, 0.4)) / on_floor as f32 * TAU)
            }
        };
        let pace = if i % 2 == 0 || i < on_floor { 2.5 } else { -2.5 };
        stage.place_marching(bot, ground.at(centre.x, centre.y), radius, angle, 1.25, pace);
    }
}

/// Along the rim of the pit, facing the wind; each rotor turns at its own speed.
fn place_windmills(stage: &mut Stage, ground: &Ground, [tower, rotor]: &[Model; 2]) {
    let (tower, rotor) = (stage.mesh("tower", tower), stage.mesh("rotor", rotor));
    for i in 0..WINDMILLS {
        let angle = i as f32 / WINDMILLS as f32 * TAU + stage.dice.between(-0.1, 0.1);
        let away = PIT_RADIUS * [1.18, 1.42, 1.3][i % 3];
        let place = PIT + Vec2::from_angle(angle) * away;
        let yaw = 0.9 + stage.dice.between(-0.12, 0.12);
        let size = stage.dice.between(0.85, 1.1);
        let feet = standing(ground.at(place.x, place.y) - Vec3::Y * 0.6, yaw, size);
        let hub = feet * Mat4::from_translation(mine::HUB);
        stage.place(tower, feet);
        let (turned, speed) = (stage.dice.angle(), stage.dice.between(0.7, 1.1));
        let axis = feet.transform_vector3(Vec3::Z).normalize_or_zero();
        let centre = hub.transform_point3(Vec3::ZERO);
        stage.place_rotating(rotor, hub * Mat4::from_rotation_z(turned), centre, axis, speed);
    }
}

/// Rocks anywhere but on the pads and in the way; pines in groups on the outlook's side.
fn place_rocks_and_trees(stage: &mut Stage, ground: &Ground, rock: &Model, pine: &Model) {
    let (rock, pine) = (stage.mesh("rock", rock), stage.mesh("pine", pine));
    let mut room = Room::default();
    PADS.iter().for_each(|pad| room.take(pad.x, pad.y, 34.0));
    CAMERAS.iter().for_each(|camera| room.take(camera.x, camera.y, 14.0));
    for i in 0..ROCKS + TREES {
        let dice = &mut stage.dice;
        let tree = i >= ROCKS;
        let around = if tree { CAMERAS[0] + Vec2::new(0.0, -70.0) } else { PIT };
        let (low, high) = if tree { (24.0, 100.0) } else { (PIT_RADIUS * 0.55, PIT_RADIUS * 1.6) };
        let place = room.find(7.0, || around + Vec2::from_angle(dice.angle()) * dice.between(low, high));
        let (yaw, size) = (dice.angle(), if tree { dice.between(0.8, 1.3) } else { dice.between(2.5, 6.0) });
        let mesh = if tree { pine } else { rock };
        stage.place(mesh, standing(ground.at(place.x, place.y) - Vec3::Y * 0.3, yaw, size));
    }
}

/// Where the cameras "main", "close", "split" and "dueling" stand, (x, z).
const CAMERAS: [Vec2; 4] =
    [Vec2::new(96.0, 372.0), Vec2::new(58.0, 66.0), Vec2::new(140.0, 318.0), Vec2::new(262.0, 118.0)];

fn cameras(stage: &mut Stage, ground: &Ground) {
    let at = |x: f32, up: f32, z: f32| ground.at(x, z) + Vec3::Y * up;
    let [main, close, split, dueling] = CAMERAS;
    let pit = ground.at(PIT.x, PIT.y);
    stage.look("main", at(main.x, 36.0, main.y), pit + Vec3::new(10.0, 18.0, 20.0));
    stage.look_far(at(-300.0, 430.0, 800.0), pit);
    stage.look("close", at(close.x, 7.0, close.y), pit + Vec3::new(0.0, 4.0, 0.0));
    stage.look("split", at(split.x, 5.0, split.y), at(-60.0, 8.0, 240.0));
    stage.look_into_light(at(dueling.x, 4.0, dueling.y), 11.0);
    stage.fly(&[
        (at(main.x, 36.0, main.y), pit + Vec3::new(10.0, 18.0, 20.0)),
        (at(-40.0, 40.0, 260.0), pit + Vec3::Y * 15.0),
        (at(-180.0, 40.0, 120.0), pit + Vec3::Y * 10.0),
        (at(-80.0, 35.0, 10.0), pit + Vec3::new(60.0, 8.0, 0.0)),
        (at(40.0, 30.0, -30.0), pit + Vec3::new(120.0, 20.0, 120.0)),
        (at(190.0, 40.0, 10.0), pit + Vec3::new(0.0, 10.0, 60.0)),
        (at(260.0, 45.0, 180.0), pit + Vec3::Y * 10.0),
    ]);
}
