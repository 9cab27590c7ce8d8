//! Lamps: lanterns that hang in the galleries, whose bars cast shadows around them, and two spots at the fountain.

use glam::Vec3;

use super::{COURT, STOREY};
use crate::paint::Paint;
use crate::shape::{Model, Solid, cone, cuboid, cylinder, sphere};
use crate::worlds::stage::{Stage, standing};
use crate::{Light, Material, Mesh};

const WARM: Vec3 = Vec3::new(1.0, 0.82, 0.58);
/// Lanterns hang so high above their floor.
const HIGH: f32 = 2.9;
/// Where lanterns hang: along, above the floor of which storey, and across.
const LANTERNS: [(f32, f32, f32); 8] = [
    (-8.0, 0.0, -7.6),
    (0.0, 0.0, -7.6),
    (8.0, 0.0, -7.6),
    (-11.6, 0.0, 0.0),
    (11.6, 0.0, 0.0),
    (-4.0, STOREY, -7.6),
    (4.0, STOREY, -7.6),
    (11.6, STOREY, 2.0),
];

pub(super) fn hang(stage: &mut Stage) {
    let lantern = stage.mesh("lantern", &lantern());
    let glow = stage.material(Material {
        emission: WARM * 2.0,
        casts: false,
        ..Material::plain("flame", 0.9, 0.8, 0.6)
    });
    let flame = stage.add(Mesh::new("flame", &[sphere(0.05, 10, 8).scaled(1.0, 1.6, 1.0).painted(glow)]));
    for (i, (x, floor, z)) in LANTERNS.into_iter().enumerate() {
        let place = Vec3::new(x, floor + HIGH, z);
        let yaw = stage.dice.angle();
        stage.place(lantern, standing(place, yaw, 1.0));
        stage.place(flame, standing(place, yaw, 1.0));
        let light = Light::point(&format!("lantern {}", i + 1), place, 11.0, 1.8 * HIGH * HIGH);
        stage.scene.lights.push(Light { colour: WARM, near: 0.08, ..light });
    }
    for side in [-1.0, 1.0] {
        let eye = Vec3::new(side * (COURT.x - 0.4), STOREY + 1.6, -COURT.y + 0.6);
        let target = Vec3::new(0.0, 0.9, 0.0);
        let candela = 2.4 * eye.distance_squared(target);
        let spot = Light::spot(
            if side < 0.0 { "west spot" } else { "east spot" },
            eye,
            target,
            0.2,
            0.36,
            24.0,
            candela,
        );
        stage.scene.lights.push(spot);
    }
}

/// A cage of bars with a lid, a floor and a rod up to the ceiling; the flame is at the origin.
fn lantern() -> Model {
    let bars = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
        .into_iter()
        .fold(Solid::default(), |sum, (x, z)| {
            sum.and(cuboid(0.02, 0.4, 0.02).moved(0.13 * x, 0.0, 0.13 * z))
        });
    let mut lantern = Model::default();
    lantern.add(Paint::Iron, bars.and(cone(0.24, 0.18, 8).moved(0.0, 0.19, 0.0)));
    lantern.add(Paint::Iron, cylinder(0.1, 0.025, 10).moved(0.0, -0.21, 0.0));
    lantern.add(Paint::Iron, cylinder(0.012, 1.1, 6).moved(0.0, 0.3, 0.0));
    lantern
}
