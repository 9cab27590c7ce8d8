//! How large texels look: for every pixel, how many pixels a texel of its shadow map extends over.
//!
//! That needs no truth. It says where a map has too few texels, and where more than anyone sees, whatever casts there.

use std::collections::HashSet;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use umbrage::{Camera, Settings, ShadowPlan, TexelExtent};
use umbrage_judge::{Pixel, Receiver, Truth};

/// The texels that one light's shadows in a picture are read from.
#[derive(Clone, Debug)]
pub struct Aliasing {
    /// The extent of the texel that each pixel's shadow is read from; `None` where no map serves the pixel, or its surface is
    /// edge-on.
    pub extents: Vec<Option<TexelExtent>>,
    /// A summary of the extents; `None` where no pixel reads a map.
    pub summary: Option<AliasingSummary>,
}

/// A summary of a picture's texels in a few numbers. Only pixels whose shadows can be seen count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AliasingSummary {
    /// The median over the picture of each texel's longest extent, in pixels.
    pub median_px: f64,
    /// The 95th percentile of each texel's longest extent, in pixels.
    pub p95_px: f64,
    /// The largest extent of a texel, in pixels.
    pub max_px: f64,
    /// The share of pixels whose texel is longer than a pixel, 0 to 1.
    pub under_sampled: f64,
    /// The share of pixels whose texel is shorter than half a pixel in its longest extent, 0 to 1.
    pub over_sampled: f64,
    /// The share of the light's texels that are read, 0 to 1.
    pub utilisation: f64,
}

impl Aliasing {
    /// Measures the texels of one light's views. `truth` says which surface each pixel shows, and which are judged.
    pub(crate) fn new(plan: &ShadowPlan, settings: &Settings, light: usize, truth: &Truth) -> Self {
        let (width, height) = (truth.eye.width, truth.eye.height);
        let reads: Vec<Option<Read>> = truth
            .receivers
            .par_iter()
            .zip(&truth.pixels)
            .map(|(receiver, pixel)| {
                let receiver = receiver.as_ref().filter(|_| is_read(*pixel))?;
                Read::new(plan, settings, light, receiver, (width, height))
            })
            .collect();
        let texels: HashSet<[i64; 3]> = reads.iter().flatten().map(|read| read.texel).collect();
        let extents: Vec<Option<TexelExtent>> =
            reads.into_iter().map(|read| read.and_then(|read| read.extent)).collect();
        let views = plan.views().iter().filter(|view| view.light == light);
        let all: u64 = views.map(|view| u64::from(view.tile.size).pow(2)).sum();
        let summary = AliasingSummary::new(&extents, texels.len() as f64 / all.max(1) as f64);
        Self { extents, summary }
    }
}

/// Whether a pixel's shadow can be seen.
fn is_read(pixel: Pixel) -> bool {
    pixel.is_judged() || pixel == Pixel::Ambiguous
}

/// What one pixel reads.
struct Read {
    /// View, column, row.
    texel: [i64; 3],
    extent: Option<TexelExtent>,
}

impl Read {
    fn new(
        plan: &ShadowPlan,
        settings: &Settings,
        light: usize,
        receiver: &Receiver,
        (width, height): (u32, u32),
    ) -> Option<Self> {
        let (position, normal) = (receiver.position.as_vec3(), receiver.normal.as_vec3());
        let view = umbrage::view_of(plan, settings, light, position, normal)?;
        let camera: &Camera = plan.camera();
        let ndc = view.clip_from_world.project_point3(receiver.position);
        let texel = |ndc: f64| ((0.5 + 0.5 * ndc) * f64::from(view.tile.size)).floor() as i64;
        Some(Self {
            texel: [view.index as i64, texel(ndc.x), texel(-ndc.y)],
            extent: view.texel_extent(camera, width, height, receiver.position, receiver.normal),
        })
    }
}

impl AliasingSummary {
    fn new(extents: &[Option<TexelExtent>], utilisation: f64) -> Option<Self> {
        let mut longest: Vec<f64> = extents.iter().flatten().map(|extent| extent.largest).collect();
        longest.sort_by(f64::total_cmp);
        let at = |share: f64| {
            let last = longest.len().saturating_sub(1);
            longest.get((share * last as f64).round() as usize).copied().unwrap_or(0.0)
        };
        let share = |is_so: fn(&TexelExtent) -> bool| {
            let count = extents.iter().flatten().filter(|extent| is_so(extent)).count();
            count as f64 / longest.len().max(1) as f64
        };
        (!longest.is_empty()).then(|| Self {
            median_px: at(0.5),
            p95_px: at(0.95),
            max_px: at(1.0),
            under_sampled: share(|extent| extent.largest > 1.0),
            over_sampled: share(|extent| extent.largest < 0.5),
            utilisation,
        })
    }
}

/// The extent at which colours are full: eight times too large, or eight times too small.
const FULL: f64 = 3.0;

/// Makes a heat map of the longest extents, as RGBA bytes: white where a texel is a pixel long, orange where longer, blue
/// where shorter, with full colours from eight times on. Pixels that no map serves are dark.
pub fn heat_map(extents: &[Option<TexelExtent>]) -> Vec<u8> {
    let colours =
        extents.iter().map(|extent| extent.map_or([24, 24, 24, 255], |extent| colour(extent.largest)));
    colours.flatten().collect()
}

fn colour(pixels: f64) -> [u8; 4] {
    let stops = (pixels.log2() / FULL).clamp(-1.0, 1.0);
    let end = if stops > 0.0 { crate::heat::FALSE_SHADOW } else { crate::heat::FALSE_LIGHT };
    let [red, green, blue] = end.map(|end| (255.0 + (f64::from(end) - 255.0) * stops.abs()).round() as u8);
    [red, green, blue, 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extent(largest: f64) -> Option<TexelExtent> {
        Some(TexelExtent { largest, smallest: largest, area: largest * largest })
    }

    #[test]
    fn sums_are_those_of_the_pixels_that_have_texels() {
        let extents = [extent(0.25), None, extent(0.75), extent(4.0), extent(2.0), extent(0.25)];
        let summary = AliasingSummary::new(&extents, 0.5).unwrap();
        assert_eq!((summary.median_px, summary.max_px), (0.75, 4.0));
        assert_eq!((summary.under_sampled, summary.over_sampled, summary.utilisation), (0.4, 0.4, 0.5));
        assert_eq!(AliasingSummary::new(&[None, None], 0.0), None, "no division by zero");
    }

    #[test]
    fn a_texel_of_a_pixel_is_white_and_others_tell_which_way_they_are_wrong() {
        assert_eq!(colour(1.0), [255; 4]);
        assert_eq!(colour(8.0), [230, 120, 0, 255]);
        assert_eq!(colour(100.0), colour(8.0));
        assert_eq!(colour(0.125), [0, 90, 200, 255]);
        assert_eq!(heat_map(&[None, extent(1.0)])[..4], [24, 24, 24, 255]);
    }
}
