//! Moments of depth that are blurred before they are read: [`crate::moments`].

use glam::{Vec2, Vec4};

use super::prefilter::Prefilter;
use crate::filter::shader::ShaderNumber;
use crate::kernel::gaussian;
use crate::lookup::reader::Reader;
use crate::moments::Moments;

/// The numbers of such a filter's shaders, which make moments and read them. A texel of moments knows the slope of what it holds, so that the offset along the
/// normal covers one texel.
pub(super) fn numbers(
    prefilter: &Prefilter,
    moments: &Moments,
    min_standard_deviation: f32,
) -> Vec<ShaderNumber> {
    let own = [
        ShaderNumber::f32("UMBRAGE_OFFSET_REACH", 1.0),
        ShaderNumber::f32("UMBRAGE_MIN_STANDARD_DEVIATION", min_standard_deviation),
    ];
    own.into_iter().chain(prefilter.numbers()).chain(moments.numbers()).collect()
}

/// How much light the blurred moments around the place let through.
pub(super) fn visibility(reader: &Reader<'_>, moments: &Moments, prefilter: &Prefilter) -> f32 {
    moments.visibility(prefiltered(reader, moments, prefilter), reader.depth())
}

/// The moments of one texel of the depth map; of the nearest inside, for places outside.
fn moments_of(reader: &Reader<'_>, moments: &Moments, x: i64, y: i64) -> Vec4 {
    let depth = |x: i64, y: i64| {
        let [x, y] = [x, y].map(|i| i.clamp(0, reader.side() - 1));
        reader.linear_depth(Vec2::new(x as f32, y as f32))
    };
    let here = depth(x, y);
    let lesser = |a: f32, b: f32| if a.abs() < b.abs() { a } else { b };
    let right = lesser(depth(x + 1, y) - here, here - depth(x - 1, y));
    let down = lesser(depth(x, y + 1) - here, here - depth(x, y - 1));
    moments.of_depth(here, Vec2::new(right, down))
}

/// The moments of the place: of blurred texels, weighted bilinearly. They are blurred around the place that is asked for:
/// slow, and another road than the shaders take.
fn prefiltered(reader: &Reader<'_>, moments: &Moments, prefilter: &Prefilter) -> Vec4 {
    let downsample = i64::from(prefilter.downsample);
    let side = reader.side() / downsample;
    let sharp = |x: i64, y: i64| {
        let [x, y] = [x, y].map(|i| i.clamp(0, side - 1) * downsample);
        let weight = 1.0 / (downsample * downsample) as f32;
        let texels = (0..downsample * downsample)
            .map(|i| moments_of(reader, moments, x + i % downsample, y + i / downsample));
        texels.fold(moments.none(), |sum, of| moments.add(sum, of, weight))
    };
    let weights = gaussian(prefilter.blur_texels);
    let reach = i64::from(prefilter.blur_texels);
    let weighed = |i: i64| weights[i.unsigned_abs() as usize];
    let blurred = |x: i64, y: i64| {
        (-reach..=reach).fold(moments.none(), |sum, j| {
            let row = (-reach..=reach)
                .fold(moments.none(), |sum, i| moments.add(sum, sharp(x + i, y + j), weighed(i)));
            moments.add(sum, row, weighed(j))
        })
    };
    let inset = Vec2::splat(0.5 * downsample as f32);
    let inside = reader.place.texel.clamp(inset, Vec2::splat(reader.side() as f32) - inset);
    let place = inside / downsample as f32 - 0.5;
    let (corner, share) = (place.floor(), place - place.floor());
    let at =
        |x: i64, y: i64| blurred((corner.x as i64 + x).min(side - 1), (corner.y as i64 + y).min(side - 1));
    at(0, 0).lerp(at(1, 0), share.x).lerp(at(0, 1).lerp(at(1, 1), share.x), share.y)
}
