//! Boxes of any size, out of a summed-area table of moments (Crow 1984; Lauritzen 2007; Peters et al. 2017).

use glam::{Vec2, Vec4};

use crate::filter::shader::ShaderNumber;
use crate::lookup::reader::Reader;
use crate::moments::Moments;

/// Steps that make a moment of 1 in a summed-area table of 32-bit whole numbers: as many as let the widest box hold no more
/// than 2³² − 1.
pub(super) fn steps(reach_texels: f32) -> f32 {
    // A box that cuts texels on both sides counts one more.
    let side = f64::from(2.0 * reach_texels).ceil() + 1.0;
    (f64::from(u32::MAX) / (side * side)).floor() as f32
}

/// The numbers that the shaders of all such filters have.
pub(super) fn numbers(
    steps: f32,
    moments: &Moments,
    min_standard_deviation: f32,
) -> impl Iterator<Item = ShaderNumber> {
    let own = [
        ShaderNumber::f32("UMBRAGE_OFFSET_REACH", 1.0),
        ShaderNumber::f32("UMBRAGE_SUM_SCALE", steps),
        ShaderNumber::f32("UMBRAGE_MIN_STANDARD_DEVIATION", min_standard_deviation),
    ];
    own.into_iter().chain(moments.numbers())
}

/// The mean of moments over a box of such half sides, texels; texels that it cuts count in part. It is summed texel by texel:
/// slow, and another road than the shaders take.
pub(super) fn over(reader: &Reader<'_>, moments: &Moments, radius: Vec2) -> Vec4 {
    let size = Vec2::splat(reader.side() as f32);
    let low = (reader.place.texel - radius).clamp(Vec2::ZERO, size);
    let high = (reader.place.texel + radius).clamp(Vec2::ZERO, size);
    let share = |i: i64, low: f32, high: f32| ((i + 1) as f32).min(high) - (i as f32).max(low);
    let mut sum = Vec4::ZERO;
    for y in low.y.floor() as i64..high.y.ceil() as i64 {
        for x in low.x.floor() as i64..high.x.ceil() as i64 {
            let weight = share(x, low.x, high.x) * share(y, low.y, high.y);
            let depth = reader.linear_depth(Vec2::new(x as f32, y as f32));
            sum += moments.of_depth(depth, Vec2::ZERO) * weight;
        }
    }
    sum / ((high.x - low.x) * (high.y - low.y))
}
