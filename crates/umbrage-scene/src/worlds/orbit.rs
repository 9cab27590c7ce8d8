//! Basic solids on a ground of 40 m, and one spot light that circles around them: all shadows move, though nothing that
//! casts them does. After the course deck's moving light.

use std::f32::consts::TAU;

use glam::Vec3;

use super::primitives::solids;
use super::stage::{Stage, View, standing};
use crate::paint::Paint;
use crate::shape::{Model, plane, sphere};
use crate::{Light, Motion, Scene};

const VIEW: View = View { fov_degrees: 55.0, near: 1.0, far: 80.0 };
/// Where the light starts, metres: 14 from the axis, 9.5 above the ground.
const START: Vec3 = Vec3::new(12.6, 9.5, 6.1);
/// One turn takes this long.
const TURN_SECONDS: f32 = 12.0;
/// The lamp's glass is this far behind the light, metres, and in nobody's way.
const BEHIND: f32 = 0.8;
/// How many of the solids of `primitives` stand around the balls, which are the last of them.
const RING: usize = 6;

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::dark("orbit", seed, VIEW);
    stage.ground(&[plane(40.0, 0.0, Paint::Stone as usize, 40.0)]);
    lamp(&mut stage);
    let [ring @ .., balls] = solids();
    let balls = mesh(&mut stage, balls);
    stage.place(balls, standing(Vec3::ZERO, 0.0, 1.1));
    for (i, solid) in ring.into_iter().take(RING).enumerate() {
        let solid = mesh(&mut stage, solid);
        let angle = i as f32 / RING as f32 * TAU + stage.dice.between(-0.2, 0.2);
        stage.place(solid, standing(Vec3::new(6.0 * angle.sin(), 0.0, 6.0 * angle.cos()), angle, 1.0));
    }
    cameras(&mut stage);
    stage.scene
}

fn mesh(stage: &mut Stage, (name, paint, solid): (&str, Paint, crate::shape::Solid)) -> usize {
    let mut model = Model::default();
    model.add(paint, solid);
    stage.mesh(name, &model)
}

/// The light, and a glass ball that flies with it, so that it can be seen.
fn lamp(stage: &mut Stage) {
    /// The middle is 16.9 m away: 650 / 16.9² ≈ 2.3.
    const CANDELA: f32 = 650.0;
    let (inner, outer) = (30.0_f32.to_radians(), 36.0_f32.to_radians());
    let spot = Light::spot("lamp", START, Vec3::ZERO, inner, outer, 45.0, CANDELA);
    let ball = mesh(stage, ("lamp", Paint::Glass, sphere(0.5, 12, 7)));
    let at = standing(START - spot.direction() * BEHIND, 0.0, 1.0);
    let pace = TAU / TURN_SECONDS;
    stage.place_rotating(ball, at, Vec3::ZERO, Vec3::Y, pace);
    let motion = Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second: pace };
    stage.scene.lights.push(Light { motion, ..spot });
}

fn cameras(stage: &mut Stage) {
    let v = Vec3::new;
    stage.look("main", v(-8.5, 8.0, 14.0), v(-1.0, 0.0, -1.0));
    stage.look_far(v(-4.0, 24.0, 24.0), v(-2.0, 0.0, -1.0));
    stage.look("close", v(-4.0, 1.8, 10.0), v(-2.5, 0.3, 2.0));
    stage.look("split", v(-17.0, 1.7, 6.0), v(10.0, 0.6, -3.0));
    stage.look_into_light(v(-14.0, 1.4, -8.0), 11.0);
    let middle = v(0.0, 1.0, 0.0);
    stage.fly(&[
        (v(-9.0, 8.5, 20.0), middle),
        (v(9.0, 5.0, 16.0), middle),
        (v(17.0, 3.0, 2.0), middle),
        (v(10.0, 5.0, -15.0), middle),
        (v(-12.0, 7.0, -12.0), middle),
        (v(-17.0, 4.0, 6.0), middle),
        (v(-9.0, 8.5, 20.0), middle),
    ]);
}
