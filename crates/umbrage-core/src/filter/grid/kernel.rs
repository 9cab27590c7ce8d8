//! Comparisons on a grid of texels around the receiver: percentage-closer filtering, Reeves et al. 1987.

use glam::Vec2;

use crate::filter::shader::ShaderNumber;
use crate::lookup::reader::Reader;

/// Returns how far a kernel of so many bilinear lookups a side, one texel apart, reaches from its centre, texels.
pub(super) fn reach_texels(size: u32) -> f32 {
    0.5 * size as f32 + 0.5
}

/// The numbers of such a kernel's shader.
pub(super) fn numbers(size: u32) -> Vec<ShaderNumber> {
    let reach = ShaderNumber::f32("UMBRAGE_OFFSET_REACH", reach_texels(size));
    vec![reach, ShaderNumber::i32("UMBRAGE_KERNEL_SIZE", size.cast_signed())]
}

/// The mean of bilinear lookups, one texel apart, in rows and columns that weigh so.
pub(super) fn kernel(reader: &Reader<'_>, weights: &[f32]) -> f32 {
    let middle = (weights.len() / 2) as f32;
    let mut sum = 0.0;
    for (y, row) in weights.iter().enumerate() {
        for (x, column) in weights.iter().enumerate() {
            let tap = Vec2::new(x as f32 - middle, y as f32 - middle);
            sum += row * column * reader.bilinear(reader.place.texel + tap);
        }
    }
    sum / weights.iter().sum::<f32>().powi(2)
}
