//! Giant dwarfs and knights who march in circles on 1.6 km² of desert, between trees and cacti: dense moving casters.

use glam::{Vec2, Vec3};
use noise_functions::{Noise as _, Perlin};

use super::picture::picture;
use super::stage::{Room, Stage, View, standing};
use crate::Scene;
use crate::actors::{folk, plants};
use crate::shape::{Ground, Model};

const VIEW: View = View { fov_degrees: 60.0, near: 1.0, far: 800.0 };
/// The root of 1.6 km², metres.
const SIDE: f32 = 1265.0;
const TRIANGLES: usize = 1_000_000;
/// How many of each kind.
const EACH: usize = 15;
/// The plain in the middle is level, so that those who march keep their feet on it; metres.
const PLAIN: f32 = 150.0;
/// Pace of a march, metres a second.
const PACE: f32 = 6.0;

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::new("knights", seed, VIEW, Vec3::new(0.8, -0.5, 0.28));
    let still = [plants::broadleaf(&mut stage.dice), plants::cactus(&mut stage.dice)];
    let moving = [folk::dwarf(), folk::knight()];
    let casters: usize = still.iter().chain(&moving).map(Model::triangles).sum();
    let ground = desert(&mut stage, TRIANGLES.saturating_sub(EACH * casters), seed as i32);
    march(&mut stage, &moving);
    grow(&mut stage, &ground, &still);
    cameras(&mut stage, &ground);
    stage.scene
}

/// Dunes around the plain, in sand of two colours.
fn desert(stage: &mut Stage, triangles: usize, seed: i32) -> Ground {
    let noise = |size: f32, p: Vec2| Perlin.frequency(1.0 / size).seed(seed).sample2(p.to_array());
    let ground = Ground::new(SIDE, triangles, |p| {
        let away = ((p.length() - PLAIN) / 220.0).clamp(0.0, 1.0);
        let bent = p + Vec2::new(noise(170.0, p + 900.0), noise(170.0, p - 900.0)) * 40.0;
        // Long crests: sharp on top, as the wind makes them.
        let crest = 1.0 - noise(1.0, Vec2::new(bent.x / 95.0, bent.y / 240.0)).abs() * 2.0;
        away * away * (3.0 - 2.0 * away) * (17.0 * crest.max(0.0).powi(2) + 10.0 * noise(420.0, p) + 6.0)
    });
    let sand = stage.textured(picture("sand", 1024, SIDE, |p| {
        let mottled = 0.5 + Perlin.fbm(4, 0.6, 2.2).frequency(1.0 / 70.0).seed(seed).sample2(p.to_array());
        let ripple = 0.02 * (0.7 * p.x + 0.25 * p.y + 6.0 * noise(40.0, p)).sin();
        Vec3::new(0.50, 0.33, 0.17).lerp(Vec3::new(0.60, 0.44, 0.26), mottled.clamp(0.0, 1.0)) + ripple
    }));
    stage.ground(&ground.primitives(sand, 1.0));
    ground
}

/// Dwarfs march in five ranks of three on an inner ring, knights the other way on an outer one.
fn march(stage: &mut Stage, kinds: &[Model; 2]) {
    let [dwarf, knight] =
        [("dwarf", &kinds[0]), ("knight", &kinds[1])].map(|(name, model)| stage.mesh(name, model));
    for i in 0..EACH {
        let (rank, file) = ((i / 3) as f32, (i % 3) as f32);
        let late = stage.dice.between(-0.02, 0.02);
        let size = stage.dice.between(0.95, 1.05);
        let dwarfs = (40.0 + 15.0 * file, -1.95 + 0.34 * rank + late);
        let knights = (93.0 + 17.0 * file, -0.55 - 0.22 * rank + late);
        stage.place_marching(dwarf, Vec3::ZERO, dwarfs.0, dwarfs.1, 9.0 * size, PACE * dwarfs.0 / 55.0);
        stage.place_marching(
            knight,
            Vec3::ZERO,
            knights.0,
            knights.1,
            11.0 * size,
            -PACE * knights.0 / 110.0,
        );
    }
}

/// Trees and cacti around the parade, more of them near than far.
fn grow(stage: &mut Stage, ground: &Ground, kinds: &[Model; 2]) {
    let [tree, cactus] =
        [("tree", &kinds[0]), ("cactus", &kinds[1])].map(|(name, model)| stage.mesh(name, model));
    let mut room = Room::default();
    for (x, z) in OUTLOOKS {
        room.take(x, z, 22.0);
    }
    for i in 0..2 * EACH {
        let dice = &mut stage.dice;
        let (low, high) = if i < EACH { (145.0, 215.0) } else { (215.0, 520.0) };
        let place = room.find(18.0, || Vec2::from_angle(dice.angle()) * dice.between(low, high));
        let (mesh, size) =
            if i % 2 == 0 { (tree, dice.between(1.6, 2.3)) } else { (cactus, dice.between(1.6, 2.6)) };
        let yaw = dice.angle();
        // A little into the sand, so that no foot hangs over a slope.
        stage.place(mesh, standing(ground.at(place.x, place.y) - Vec3::Y * 0.4, yaw, size));
    }
}

/// Where cameras stand that are not among those who march.
const OUTLOOKS: [(f32, f32); 3] = [(-45.0, 152.0), (70.0, 150.0), (-160.0, 60.0)];

fn cameras(stage: &mut Stage, ground: &Ground) {
    let at = |x: f32, up: f32, z: f32| ground.at(x, z) + Vec3::Y * up;
    stage.look("main", at(-45.0, 30.0, 152.0), at(38.0, 5.0, 62.0));
    stage.look_far(at(-330.0, 300.0, 520.0), at(0.0, 0.0, 30.0));
    stage.look("close", at(0.0, 5.0, 22.0), at(14.0, 1.0, 55.0));
    stage.look("split", at(70.0, 4.0, 150.0), at(-60.0, 9.0, 60.0));
    stage.look_into_light(at(75.0, 3.0, 75.0), 11.0);
    stage.fly(&[
        (at(-45.0, 30.0, 152.0), at(38.0, 5.0, 62.0)),
        (at(-110.0, 24.0, 80.0), at(10.0, 8.0, 60.0)),
        (at(-90.0, 22.0, 10.0), at(0.0, 8.0, 40.0)),
        (at(-30.0, 28.0, -10.0), at(30.0, 8.0, 70.0)),
        (at(25.0, 22.0, -5.0), at(90.0, 10.0, 60.0)),
        (at(160.0, 40.0, 20.0), at(40.0, 8.0, 60.0)),
        (at(150.0, 60.0, 170.0), at(20.0, 6.0, 50.0)),
    ]);
}
