//! Basic solids on a ground of 40 m that turn, and one spot light that moves to and fro around them: all shadows move.
//!
//! Source: the course deck *Shadow Rendering*, its second step. At a time t its light is at
//! (300 sin 6πt, 200, 100 cos 4πt + 250) and looks at the origin through a frustum of 90°, and its scene is turned by 720° t
//! about Y. Here one of its units is [`METRES_A_UNIT`]. In what t is counted the deck does not say; everything is back where
//! it was after t = 1, which takes [`LOOP_SECONDS`].

use std::f64::consts::PI;

use glam::{DVec3, Mat4, Quat, Vec3};

use super::primitives::solids;
use super::rigging::Moves;
use super::stage::{Stage, View, standing};
use crate::curve::{Curve, Keys};
use crate::paint::Paint;
use crate::rig::Track;
use crate::shape::{Model, plane, sphere};
use crate::{Instance, Light, Motion, Scene};

const VIEW: View = View { fov_degrees: 55.0, near: 1.0, far: 80.0 };
/// The deck's scene is hundreds of its units across, and the ground here is 40 m.
const METRES_A_UNIT: f64 = 0.05;
/// How long the deck's t takes from 0 to 1.
pub(super) const LOOP_SECONDS: f32 = 24.0;
/// Keys of the light's curve. Cubic splines through so many are within 0.1 mm of the formula.
const KEYS: u16 = 144;
/// The lamp's glass is this far behind the light, metres, and in nobody's way.
const BEHIND: f32 = 0.8;
/// How many of the solids of `primitives` stand around the balls, which are the last of them.
const RING: usize = 6;

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::dark("orbit", seed, VIEW);
    stage.ground(&[plane(40.0, 0.0, Paint::Stone as usize, 40.0)]);
    let [ring @ .., balls] = solids();
    let balls = mesh(&mut stage, balls);
    turn(&mut stage, balls, standing(Vec3::ZERO, 0.0, 1.1));
    for (i, solid) in ring.into_iter().take(RING).enumerate() {
        let solid = mesh(&mut stage, solid);
        let angle = i as f32 / RING as f32 * std::f32::consts::TAU + stage.dice.between(-0.2, 0.2);
        let place = Vec3::new(6.0 * angle.sin(), 0.0, 6.0 * angle.cos());
        turn(&mut stage, solid, standing(place, angle, 1.0));
    }
    lamp(&mut stage);
    cameras(&mut stage);
    stage.scene
}

fn mesh(stage: &mut Stage, (name, paint, solid): (&str, Paint, crate::shape::Solid)) -> usize {
    let mut model = Model::default();
    model.add(paint, solid);
    stage.mesh(name, &model)
}

/// Places a solid that turns about the world's middle, by 720° in a loop.
fn turn(stage: &mut Stage, solid: usize, at: Mat4) {
    let pace = 2.0 * std::f32::consts::TAU / LOOP_SECONDS;
    stage.place_rotating(solid, at, Vec3::ZERO, Vec3::Y, pace);
}

/// Where the light is at the deck's time, metres.
pub(super) fn place(t: f64) -> DVec3 {
    let (x, z) = ((6.0 * PI * t).sin() * 300.0, (4.0 * PI * t).cos() * 100.0 + 250.0);
    DVec3::new(x, 200.0, z) * METRES_A_UNIT
}

/// How fast the light moves there, metres for each 1 of the deck's time.
fn velocity(t: f64) -> DVec3 {
    let (x, z) = (6.0 * PI * (6.0 * PI * t).cos() * 300.0, -4.0 * PI * (4.0 * PI * t).sin() * 100.0);
    DVec3::new(x, 0.0, z) * METRES_A_UNIT
}

/// How the light is turned there so that its −Z looks at the middle: about Y, then about its own X.
fn rotation(t: f64) -> Quat {
    let place = place(t);
    let (yaw, pitch) = (place.x.atan2(place.z), -place.y.atan2(place.x.hypot(place.z)));
    (glam::DQuat::from_rotation_y(yaw) * glam::DQuat::from_rotation_x(pitch)).as_quat()
}

/// The light, and a glass ball that flies with it, so that it can be seen.
fn lamp(stage: &mut Stage) {
    /// The middle is 20.2 m away at the start: 930 / 20.2² ≈ 2.3.
    const CANDELA: f32 = 930.0;
    /// Half of the deck's frustum, whose sides are as far from its axis as its plane is from the light.
    const HALF_ANGLE: f32 = std::f32::consts::FRAC_PI_4;
    let start = place(0.0).as_vec3();
    let node = stage.node("lamp", None, start, rotation(0.0), Vec3::ONE);
    let ball = mesh(stage, ("lamp", Paint::Glass, sphere(0.5, 12, 7)));
    let motion = Motion::Node { node, node_from_thing: Mat4::from_translation(Vec3::Z * BEHIND) };
    let ball = Instance { motion, node: Some(node), ..Instance::still(ball, Mat4::IDENTITY) };
    stage.scene.instances.push(ball);
    let motion = Motion::Node { node, node_from_thing: Mat4::IDENTITY };
    let spot = Light::spot("lamp", start, Vec3::ZERO, 0.85 * HALF_ANGLE, HALF_ANGLE, 50.0, CANDELA);
    stage.scene.lights.push(Light { motion, ..spot });

    let mut moves = Moves::new(LOOP_SECONDS);
    curves().for_each(|track| moves.add(node, track));
    moves.play("orbit", stage);
}

/// Where the light is in a loop, and how it is turned.
fn curves() -> impl Iterator<Item = Track> {
    let times = || (0..=KEYS).map(|key| f64::from(key) / f64::from(KEYS));
    let seconds: Vec<f32> = times().map(|t| t as f32 * LOOP_SECONDS).collect();
    let a_second = 1.0 / f64::from(LOOP_SECONDS);
    let place = |t: f64| {
        let slope = (velocity(t) * a_second).as_vec3();
        [slope, place(t).as_vec3(), slope]
    };
    let rotation = |t: f64| {
        /// Short enough for a difference to be a slope, and long enough for f32.
        const STEP: f64 = 1e-3;
        let slope = (rotation(t + STEP) - rotation(t - STEP)) * (0.5 / STEP * a_second) as f32;
        [slope, rotation(t), slope]
    };
    let places = Curve::new(seconds.clone(), Keys::Cubic(times().map(place).collect()));
    let rotations = Curve::new(seconds, Keys::Cubic(times().map(rotation).collect()));
    [places.map(Track::Translation), rotations.map(Track::Rotation)].into_iter().flatten()
}

fn cameras(stage: &mut Stage) {
    let v = Vec3::new;
    stage.look("main", v(-15.0, 8.5, -5.0), v(-1.0, 0.0, -1.0));
    stage.look_far(v(-22.0, 24.0, -12.0), v(-1.0, 0.0, -2.0));
    stage.look("close", v(-6.0, 1.8, -11.0), v(-2.5, 0.3, -4.0));
    stage.look("split", v(-17.0, 1.7, -6.0), v(10.0, 0.6, -3.0));
    stage.look_into_light(v(-5.0, 1.4, -10.0), 11.0);
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
