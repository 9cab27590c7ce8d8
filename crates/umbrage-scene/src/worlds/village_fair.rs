//! A village fair in the evening: a hundred people on one green, each a skin with its own bones, who dance, wave and run.
//!
//! Flags and bunting are morphed, a carousel turns with its horses, signs blink, stalls have roofs of cloth with lace and of
//! thin tarpaulin, and lamps hang over all of it while the sun is low.

mod carousel;
mod cloth;
mod crowd;
mod figure;
mod lamps;
mod skeleton;
mod stalls;
mod steps;
mod village;

#[cfg(test)]
mod tests;

use glam::{Vec2, Vec3};

use super::picture::picture;
use super::rigging::Moves;
use super::stage::{Stage, View};
use crate::Scene;
use crate::shape::Ground;

const VIEW: View = View { fov_degrees: 60.0, near: 0.25, far: 110.0 };
const SIDE: f32 = 120.0;
/// After so many seconds everything begins again: a turn of the carousel, 20 steps, 16 claps.
const ROUND_SECONDS: f32 = 24.0;
/// The middle of the carousel, of the ring of dancers, and of the stage's front edge, on the plan.
const CAROUSEL: Vec2 = Vec2::new(10.0, -3.0);
const MAYPOLE: Vec2 = Vec2::new(-4.0, 3.0);
const STAGE: Vec2 = Vec2::new(-2.0, -17.0);

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::new("village-fair", seed, VIEW, Vec3::new(0.82, -0.48, -0.4));
    stage.scene.lights[0].colour = Vec3::new(1.0, 0.86, 0.68);
    let green = stage.textured(green());
    stage.ground(&Ground::new(SIDE, 1800, |_| 0.0).primitives(green, 8.0));
    village::build(&mut stage);
    let mut moves = Moves::new(ROUND_SECONDS);
    let cloths = cloth::materials(&mut stage);
    stalls::put_up(&mut stage, &cloths, &mut moves);
    cloth::hoist(&mut stage, &cloths, &mut moves);
    carousel::put_up(&mut stage, &mut moves);
    lamps::hang(&mut stage, &mut moves);
    crowd::gather(&mut stage, &mut moves);
    moves.play("fair", &mut stage);
    look(&mut stage);
    stage.scene
}

/// Trodden grass, which repeats.
fn green() -> crate::Texture {
    picture("green", 256, 1.0, |p| {
        let wave = |x: f32, y: f32| (std::f32::consts::TAU * (x * p.x + y * p.y)).sin();
        let bare = 0.5 + 0.35 * wave(1.0, 2.0) * wave(-2.0, 1.0) + 0.2 * wave(5.0, -3.0) * wave(3.0, 7.0);
        let fine = 1.0 + 0.08 * wave(31.0, 17.0) * wave(-23.0, 29.0);
        Vec3::new(0.20, 0.24, 0.09).lerp(Vec3::new(0.33, 0.27, 0.18), bare.clamp(0.0, 1.0)) * fine
    })
}

/// A point on the green.
fn on_green(place: Vec2) -> Vec3 {
    Vec3::new(place.x, 0.0, place.y)
}

fn look(stage: &mut Stage) {
    let v = Vec3::new;
    let main = (v(-9.0, 6.0, 20.0), v(1.5, 1.0, -3.0));
    stage.look("main", main.0, main.1);
    stage.look_far(v(-30.0, 34.0, 44.0), v(2.0, 0.0, -3.0));
    stage.look("close", v(-7.0, 1.9, 10.5), v(-2.0, 0.5, 1.0));
    stage.look("split", v(-13.0, 1.7, 17.0), v(14.0, 1.0, -12.0));
    stage.look_into_light(v(6.0, 1.7, -9.0), 9.0);
    stage.look("crowd", v(3.5, 3.6, -4.0), v(-3.0, 0.8, -15.0));
    stage.fly(&[
        main,
        (v(-3.0, 4.0, 14.0), v(2.0, 1.0, -4.0)),
        (v(4.0, 3.2, 8.0), v(6.0, 1.0, -6.0)),
        (v(1.0, 3.0, -1.5), v(-3.0, 1.2, -17.0)),
        (v(-6.0, 4.5, -6.0), v(8.0, 1.0, -8.0)),
        (v(-8.5, 5.0, 2.0), v(6.0, 1.0, 0.0)),
        (v(-6.0, 7.0, 14.0), v(2.0, 0.5, -4.0)),
    ]);
}
