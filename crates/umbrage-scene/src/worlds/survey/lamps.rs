//! The street lamps around the market: hooded ones that throw a cone on the street, and round ones that shine all around;
//! some with a range, and some without, as exporters write them.

use std::f32::consts::{FRAC_PI_2, PI};

use glam::{Vec2, Vec3};

use super::land::Land;
use super::quarters::{WORLD_FROM_SURVEY, z_up};
use super::town;
use super::wood::upright;
use crate::Light;
use crate::paint::Paint;
use crate::shape::{Model, cuboid, cylinder, frustum, sphere};
use crate::worlds::stage::Stage;

/// A lamp's place in town (along the valley road, north of it).
#[derive(Clone, Copy, Debug)]
enum Lamp {
    /// On an arm over the street, `HIGH` up, turned by so many radians.
    Hooded { along: f32, north: f32, turn: f32, range: f32 },
    /// A ball on a post, `LOW` up.
    Round { along: f32, north: f32, range: f32 },
}

const HIGH: f32 = 7.0;
const LOW: f32 = 4.0;
const ARM: f32 = 1.8;
const ENDLESS: f32 = f32::INFINITY;

const LAMPS: [Lamp; 12] = [
    Lamp::Hooded { along: -30.0, north: 5.4, turn: -FRAC_PI_2, range: 30.0 },
    Lamp::Hooded { along: 6.0, north: 5.4, turn: -FRAC_PI_2, range: ENDLESS },
    Lamp::Hooded { along: 40.0, north: 5.4, turn: -FRAC_PI_2, range: 30.0 },
    Lamp::Hooded { along: -75.0, north: -5.2, turn: FRAC_PI_2, range: 30.0 },
    Lamp::Hooded { along: 85.0, north: -5.2, turn: FRAC_PI_2, range: ENDLESS },
    Lamp::Hooded { along: -42.5, north: 40.0, turn: PI, range: 30.0 },
    Lamp::Hooded { along: 42.5, north: 60.0, turn: 0.0, range: 30.0 },
    Lamp::Round { along: -30.0, north: 22.0, range: ENDLESS },
    Lamp::Round { along: -26.0, north: 58.0, range: 24.0 },
    Lamp::Round { along: -37.0, north: 36.0, range: ENDLESS },
    Lamp::Round { along: 36.0, north: 22.0, range: 24.0 },
    Lamp::Round { along: 4.0, north: 22.0, range: 24.0 },
];

/// Linear RGB of sodium, and of warm white.
const SODIUM: Vec3 = Vec3::new(1.0, 0.68, 0.36);
const WARM: Vec3 = Vec3::new(1.0, 0.86, 0.66);

/// Puts up the posts, and lights.
pub(super) fn put_up(stage: &mut Stage, land: &Land) {
    let meshes = [stage.mesh("street lamp", &hooded()), stage.mesh("round lamp", &round())];
    for (i, lamp) in LAMPS.into_iter().enumerate() {
        let (along, north) = match lamp {
            Lamp::Hooded { along, north, .. } | Lamp::Round { along, north, .. } => (along, north),
        };
        let foot = town::above(land, along, north, 0.0);
        let name = format!("lamp {}", i + 1);
        match lamp {
            Lamp::Hooded { turn, range, .. } => {
                stage.place(meshes[0], upright(foot, turn, 1.0));
                // Below the hood's rim, so that the hood does not darken its own lamp.
                let eye = foot + (Vec2::from_angle(turn) * ARM).extend(HIGH - 0.25);
                let [eye, below] = [eye, eye - Vec3::Z].map(|p| WORLD_FROM_SURVEY.transform_point3(p));
                let light = Light::spot(&name, eye, below, 0.75, 1.1, range, 5.0 * HIGH * HIGH);
                stage.scene.lights.push(Light { colour: SODIUM, ..light });
            }
            Lamp::Round { range, .. } => {
                stage.place(meshes[1], upright(foot, 0.0, 1.0));
                let place = WORLD_FROM_SURVEY.transform_point3(foot + Vec3::Z * (LOW + 0.32));
                let light = Light::point(&name, place, range, 4.0 * LOW * LOW);
                stage.scene.lights.push(Light { colour: WARM, ..light });
            }
        }
    }
}

/// A post with an arm along x, and a hood at its end.
fn hooded() -> Model {
    let mut lamp = Model::default();
    lamp.add(Paint::Iron, z_up(frustum(0.11, 0.06, HIGH + 1.0, 7)).moved(0.0, 0.0, -1.0));
    lamp.add(Paint::Iron, cuboid(ARM, 0.07, 0.07).moved(ARM * 0.5, 0.0, HIGH));
    lamp.add(Paint::Iron, z_up(frustum(0.28, 0.1, 0.16, 10)).moved(ARM, 0.0, HIGH - 0.18));
    lamp
}

/// A post with a foot and a lid; the light is in the open between them.
fn round() -> Model {
    let mut lamp = Model::default();
    lamp.add(Paint::Iron, z_up(cylinder(0.06, LOW + 1.0, 7)).moved(0.0, 0.0, -1.0));
    lamp.add(Paint::Iron, z_up(frustum(0.16, 0.08, 0.5, 8)));
    lamp.add(Paint::White, sphere(0.08, 8, 6).moved(0.0, 0.0, LOW + 0.05));
    lamp.add(Paint::Iron, z_up(frustum(0.3, 0.04, 0.14, 10)).moved(0.0, 0.0, LOW + 0.62));
    lamp
}
