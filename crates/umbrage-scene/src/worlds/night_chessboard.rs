//! The huge chessboard at night: the same board and men, and twelve floodlights on masts around it, whose cones overlap.

use glam::Vec3;

use super::huge_chessboard::{self, VIEW};
use super::stage::{Stage, standing};
use crate::paint::Paint;
use crate::shape::{Model, frustum, sphere};
use crate::{Light, Scene};

/// Height of the masts, metres: 30 more than the king.
const HEIGHT: f32 = 190.0;
/// Radius of the glass ball on top, and how far in front of its middle the light is, metres.
const BALL: f32 = 5.0;
const BEFORE: f32 = 7.0;
/// Where a mast stands and where its light is aimed, both as (x, z), metres. The corners of the board are at ±350.
const MASTS: [([f32; 2], [f32; 2]); 12] = [
    // East.
    ([395.0, -60.0], [210.0, -40.0]),
    ([395.0, -250.0], [210.0, -220.0]),
    ([395.0, 120.0], [210.0, 150.0]),
    // West.
    ([-395.0, -100.0], [-210.0, -120.0]),
    ([-395.0, 60.0], [-210.0, 60.0]),
    ([-395.0, 250.0], [-210.0, 230.0]),
    // North.
    ([-200.0, -395.0], [-130.0, -190.0]),
    ([0.0, -395.0], [0.0, -60.0]),
    ([200.0, -395.0], [100.0, -200.0]),
    // South.
    ([-200.0, 395.0], [-110.0, 190.0]),
    ([20.0, 395.0], [10.0, 70.0]),
    ([200.0, 395.0], [130.0, 210.0]),
];
/// Linear RGB: sodium, tungsten, halogen and mercury lamps in turn.
const COLOURS: [Vec3; 4] = [
    Vec3::new(1.0, 0.74, 0.48),
    Vec3::new(1.0, 0.86, 0.68),
    Vec3::new(1.0, 0.95, 0.88),
    Vec3::new(0.82, 0.91, 1.0),
];

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::dark("night-chessboard", seed, VIEW);
    huge_chessboard::set_up(&mut stage);
    floodlights(&mut stage);
    huge_chessboard::views(&mut stage);
    stage.look_into_light(Vec3::new(-80.0, 8.0, -46.0), 9.0);
    huge_chessboard::flight(&mut stage);
    stage.scene
}

fn floodlights(stage: &mut Stage) {
    let mut mast = Model::default();
    mast.add(Paint::Iron, frustum(3.0, 1.6, HEIGHT, 12).moved(0.0, -2.0, 0.0));
    mast.add(Paint::Glass, sphere(BALL, 12, 8).moved(0.0, HEIGHT, 0.0));
    let mast = stage.mesh("mast", &mast);
    for (i, (foot, aim)) in MASTS.into_iter().enumerate() {
        let foot = Vec3::new(foot[0], 0.0, foot[1]);
        stage.place(mast, standing(foot, 0.0, 1.0));
        let light = floodlight(i, foot + Vec3::Y * HEIGHT, Vec3::new(aim[0], 0.0, aim[1]));
        stage.scene.lights.push(light);
    }
}

/// A light just before the ball at `top`, aimed at a place on the board where it gives 2.6 lux.
fn floodlight(i: usize, top: Vec3, aim: Vec3) -> Light {
    let (inner, outer) = (21.0_f32.to_radians(), 28.0_f32.to_radians());
    let eye = top + (aim - top).normalize_or_zero() * BEFORE;
    let distance = eye.distance(aim);
    // The end of the range is where a fifth of the light is left: 1 / 2.2².
    let (range, candela) = (2.2 * distance, 2.6 * distance * distance);
    let name = format!("floodlight {}", i + 1);
    Light { colour: COLOURS[i % COLOURS.len()], ..Light::spot(&name, eye, aim, inner, outer, range, candela) }
}
