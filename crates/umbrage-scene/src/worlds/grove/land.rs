//! The hillside: a knoll to look from, a hollow, and a slope that faces it, so that shadows far away are seen.

use glam::{Vec2, Vec3};
use noise_functions::{Noise as _, Perlin};

use super::OUTLOOK;
use crate::Texture;
use crate::shape::Ground;
use crate::worlds::picture::picture;

pub(super) const SIDE: f32 = 800.0;
const TRIANGLES: usize = 51_200;

pub(super) fn build(seed: i32) -> Ground {
    Ground::new(SIDE, TRIANGLES, |p| {
        let knoll = 4.0 * (-(p - OUTLOOK - Vec2::new(0.0, 8.0)).length_squared() / 900.0).exp();
        let hill = 74.0 * smooth(190.0, -330.0, p.y);
        let rolling = |size: f32| Perlin.frequency(1.0 / size).seed(seed).sample2(p.to_array());
        knoll + hill + 5.0 * rolling(170.0) + 0.7 * rolling(37.0)
    })
}

/// Mown and unmown grass, clover and bare soil.
pub(super) fn meadow() -> Texture {
    picture("meadow", 512, 1.0, |p| {
        // Two octaves of a lattice that repeats with the picture.
        let wave = |x: f32, y: f32| (std::f32::consts::TAU * (x * p.x + y * p.y)).sin();
        let mottled = wave(2.0, 1.0) * wave(-1.0, 3.0) + 0.6 * wave(7.0, -5.0) * wave(4.0, 9.0);
        let fine = wave(41.0, 23.0) * wave(-29.0, 37.0) + wave(67.0, -59.0) * wave(53.0, 61.0);
        let green = Vec3::new(0.16, 0.24, 0.06).lerp(Vec3::new(0.23, 0.27, 0.09), 0.5 + 0.3 * mottled);
        green * (1.0 + 0.12 * fine)
    })
}

/// 0 where `value` is at or before `from`, 1 at or beyond `to`, and smooth between.
pub(super) fn smooth(from: f32, to: f32, value: f32) -> f32 {
    let share = ((value - from) / (to - from)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
