//! The hillside: a knoll to look from, a hollow, and a slope that faces it, so that shadows far away are seen.

use glam::{Vec2, Vec3};
use noise_functions::{Noise as _, Perlin};

use super::OUTLOOK;
use crate::Texture;
use crate::shape::Ground;
use crate::worlds::picture::picture;

pub(super) const SIDE: f32 = 1000.0;
const TRIANGLES: usize = 80_000;

pub(super) fn build(seed: i32) -> Ground {
    Ground::new(SIDE, TRIANGLES, |p| {
        let knoll = 4.0 * (-(p - OUTLOOK - Vec2::new(0.0, 8.0)).length_squared() / 900.0).exp();
        let hill = 74.0 * smooth(190.0, -330.0, p.y);
        let rolling = |size: f32| Perlin.frequency(1.0 / size).seed(seed).sample2(p.to_array());
        knoll + hill + 5.0 * rolling(170.0) + 0.7 * rolling(37.0)
    })
}

/// Mown and unmown grass, and where it is dry.
pub(super) fn meadow(seed: i32) -> Texture {
    picture("meadow", 1024, SIDE, |p| {
        let mottled = |size: f32| Perlin.frequency(1.0 / size).seed(seed + 3).sample2(p.to_array());
        let dry = (0.5 + 0.9 * mottled(70.0) + 0.4 * mottled(19.0)).clamp(0.0, 1.0);
        let green = Vec3::new(0.13, 0.22, 0.05).lerp(Vec3::new(0.25, 0.27, 0.10), dry);
        green * (1.0 + 0.22 * mottled(4.0))
    })
}

/// 0 where `value` is at or before `from`, 1 at or beyond `to`, and smooth between.
pub(super) fn smooth(from: f32, to: f32, value: f32) -> f32 {
    let share = ((value - from) / (to - from)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
