//! What stands still: houses around the green, a maypole, and the stage.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};

use super::{MAYPOLE, STAGE, on_green};
use crate::paint::Paint;
use crate::shape::{Model, Solid, cuboid, cylinder, frustum, prism, pyramid, torus};
use crate::worlds::stage::{Stage, standing};

pub(super) const STAGE_HEIGHT: f32 = 0.9;

pub(super) fn build(stage: &mut Stage) {
    let houses =
        [house(7.0, 3.4, Paint::White), house(9.0, 4.6, Paint::Sandstone), house(6.0, 5.2, Paint::Ivory)]
            .map(|house| stage.mesh("house", &house));
    // None on the side of the evening sun.
    for i in 0..17 {
        let angle = (0.03 + i as f32 / 23.0) * TAU - 2.2;
        let out = Vec2::new(angle.cos(), -angle.sin()) * stage.dice.between(36.0, 44.0);
        let yaw = (-out.x).atan2(-out.y) + stage.dice.between(-0.2, 0.2);
        stage.place(houses[i % houses.len()], standing(on_green(out), yaw, 1.0));
    }
    let church = stage.mesh("church", &church());
    stage.place(church, standing(Vec3::new(-14.0, 0.0, -50.0), 0.3, 1.0));
    let mut maypole = Model::default();
    maypole.add(Paint::White, frustum(0.11, 0.07, 8.0, 12));
    maypole.add(Paint::Green, torus(0.55, 0.1, 20, 8).moved(0.0, 6.6, 0.0));
    let maypole = stage.mesh("maypole", &maypole);
    stage.place(maypole, standing(on_green(MAYPOLE), 0.0, 1.0));
    let platform = stage.mesh("stage", &platform());
    stage.place(platform, standing(on_green(STAGE), 0.0, 1.0));
}

/// A house with a gable that looks to +Z.
fn house(wide: f32, tall: f32, wall: Paint) -> Model {
    let deep = wide * 1.25;
    let mut house = Model::default();
    house.add(wall, cuboid(wide, tall, deep).moved(0.0, tall * 0.5, 0.0));
    let (half, rise) = (0.5 * wide + 0.35, 0.45 * wide);
    house.add(
        Paint::Red,
        prism(&[[-half, 0.0], [half, 0.0], [0.0, rise]], deep + 0.6).moved(0.0, tall - 0.05, 0.0),
    );
    house.add(Paint::Rock, cuboid(0.6, 1.6, 0.6).moved(0.2 * wide, tall + 0.75 * rise, -0.2 * deep));
    let window = |x: f32, y: f32| cuboid(0.9, 1.2, 0.1).moved(x, y, 0.5 * deep + 0.03);
    let panes = [-0.3, 0.3].into_iter().fold(Solid::default(), |sum, x| sum.and(window(x * wide, 1.7)));
    house.add(Paint::Glass, panes.and(window(0.0, tall + 0.25 * rise)));
    house.add(Paint::Wood, cuboid(1.0, 2.1, 0.12).moved(0.0, 1.05, 0.5 * deep + 0.03));
    house
}

fn church() -> Model {
    let mut church = house(9.0, 7.0, Paint::Stone);
    church.add(Paint::Stone, cuboid(4.5, 18.0, 4.5).moved(0.0, 9.0, 7.0));
    church.add(Paint::Slate, pyramid(5.0, 8.0).moved(0.0, 17.9, 7.0));
    church
}

/// Planks on trestles; the front edge is above the origin, and the stage is behind it.
fn platform() -> Model {
    let mut stage = Model::default();
    for i in 0..8 {
        let z = -0.31 - 0.6 * i as f32;
        stage.add(Paint::Wood, cuboid(9.0, 0.06, 0.58).moved(0.0, STAGE_HEIGHT - 0.03, z));
    }
    for (x, z) in [-4.2, -1.4, 1.4, 4.2].into_iter().flat_map(|x| [-0.3, -4.5].map(|z| (x, z))) {
        stage.add(Paint::Bark, cylinder(0.07, STAGE_HEIGHT - 0.06, 8).moved(x, 0.0, z));
    }
    stage.add(Paint::Violet, cuboid(9.0, 3.6, 0.08).moved(0.0, 1.8 + 0.02, -4.95));
    stage
}
