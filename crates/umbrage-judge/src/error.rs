//! How wrong a picture's shadows are.
//!
//! All shares are of the pixels that are judged. A pixel is claimed to be shadowed where its visibility is below ½. Names
//! as in the literature: false shadow is acne's side, false light that of leaks and of shadows that begin too late.

use std::ops::Range;

use crate::causes::{Causes, cause};
use crate::statistics::rank;
use crate::{Edges, Pixel, Smooth, Truth, World};

/// What a technique says of a picture.
#[derive(Clone, Copy, Debug)]
pub struct Claim<'a> {
    /// Visibility of every pixel, 0 to 1.
    pub visibility: &'a [f32],
    /// How large a texel is that each pixel's shadow was read from, metres, on a plane there that faces the light; 0 where no
    /// map serves the pixel.
    pub texel_metres: &'a [f32],
}

/// How wrong a claim is.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Error {
    /// Share of pixels that are shadowed but should not be, or the other way round.
    pub mis_shadowed: f64,
    /// Share of pixels that are shadowed and should be lit.
    pub false_shadow: f64,
    /// Share of pixels that are lit and should be shadowed.
    pub false_light: f64,
    /// Root of the mean squared error of visibility.
    pub rmse: f64,
    /// Mean absolute error of visibility.
    pub mae: f64,
    /// Mean error of visibility; above 0 where shadows are too bright.
    pub bias: f64,
    /// Wrong pixels for each pixel of true edge: how far edges are displaced in the mean, pixels. `None` without edges.
    pub edge_displacement_px: Option<f64>,
    /// How far the farthest twentieth of wrong pixels begins from the nearest true edge, pixels; 0 where none is wrong.
    /// `None` without edges.
    pub hausdorff_95_px: Option<f64>,
    /// Why; the shares add up to `mis_shadowed`.
    pub causes: Causes,
    /// The same by view depth, one band a decade of metres.
    pub decades: Vec<DepthBand>,
}

/// What is wrong within a range of view depths. Shares are of the band's own judged pixels.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DepthBand {
    /// View depths, metres; half-open.
    pub depths: [f64; 2],
    /// How many pixels of it are judged.
    pub pixels: usize,
    /// As in [`Error`]; 0 without pixels.
    pub mis_shadowed: f64,
    /// As in [`Error`]; 0 without pixels.
    pub false_shadow: f64,
    /// As in [`Error`]; 0 without pixels.
    pub false_light: f64,
    /// As in [`Error`]; `None` without edges.
    pub edge_displacement_px: Option<f64>,
    /// Length of true edges in it, pixels.
    pub edge_px: f64,
}

/// How a claim about a pixel is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wrong {
    FalseShadow,
    FalseLight,
}

/// Whether and how a claim about a judged pixel is wrong.
pub(crate) fn wrong(pixel: Pixel, visibility: f32) -> Option<Wrong> {
    match (pixel, visibility < 0.5) {
        (Pixel::Lit, true) => Some(Wrong::FalseShadow),
        (Pixel::Shadowed, false) => Some(Wrong::FalseLight),
        _ => None,
    }
}

impl Error {
    /// Compares a claim with the truth. `rmse`, `mae` and `bias` are against `smooth` where it is given, otherwise
    /// against the hard truth. `None` where no pixel is judged.
    ///
    /// # Panics
    /// When the claim has another number of pixels than the truth.
    pub fn new(
        world: &World,
        truth: &Truth,
        edges: &Edges,
        smooth: Option<&Smooth>,
        claim: &Claim<'_>,
    ) -> Option<Self> {
        let Claim { visibility, texel_metres } = claim;
        assert_eq!(visibility.len(), truth.pixels.len(), "one visibility a pixel");
        assert_eq!(texel_metres.len(), truth.pixels.len(), "one texel size a pixel");
        let judged = truth.judged();
        if judged == 0 {
            return None;
        }
        let share = |count: usize| count as f64 / judged as f64;
        let all = band(truth, edges, visibility, 0.0..f64::INFINITY);
        let differences = differences(truth, smooth, visibility);
        let mean = |of: fn(f64) -> f64| differences.iter().map(|d| of(*d)).sum::<f64>() / judged as f64;
        let mut causes = Causes::default();
        let mut distances = Vec::new();
        for (i, (pixel, visibility)) in truth.pixels.iter().zip(*visibility).enumerate() {
            let (Some(wrong), Some(receiver)) = (wrong(*pixel, *visibility), truth.receivers[i]) else {
                continue;
            };
            distances.push(f64::from(edges.distance[i]));
            let cause =
                cause(world, truth, &receiver, wrong, *visibility, texel_metres[i], edges.distance[i]);
            *causes.of_mut(cause) += share(1);
        }
        distances.sort_by(f64::total_cmp);
        let has_edges = edges.length() > 0.0;
        Some(Self {
            mis_shadowed: all.mis_shadowed,
            false_shadow: all.false_shadow,
            false_light: all.false_light,
            rmse: mean(|d| d * d).sqrt(),
            mae: mean(f64::abs),
            bias: mean(|d| d),
            edge_displacement_px: all.edge_displacement_px,
            hausdorff_95_px: has_edges.then(|| rank(&distances, 0.95)),
            causes,
            decades: decades(truth, edges, visibility),
        })
    }
}

/// What is wrong between two view depths.
pub(crate) fn band(truth: &Truth, edges: &Edges, visibility: &[f32], depths: Range<f64>) -> DepthBand {
    let (mut pixels, mut shadow, mut light, mut length) = (0, 0, 0, 0.0);
    for (i, pixel) in truth.pixels.iter().enumerate() {
        let inside = truth.receivers[i].is_some_and(|receiver| depths.contains(&receiver.depth));
        if !inside || !pixel.is_judged() {
            continue;
        }
        pixels += 1;
        length += f64::from(edges.length_at[i]);
        match wrong(*pixel, visibility[i]) {
            Some(Wrong::FalseShadow) => shadow += 1,
            Some(Wrong::FalseLight) => light += 1,
            None => {}
        }
    }
    let share = |count: usize| count as f64 / pixels.max(1) as f64;
    DepthBand {
        depths: [depths.start, depths.end],
        pixels,
        mis_shadowed: share(shadow + light),
        false_shadow: share(shadow),
        false_light: share(light),
        edge_displacement_px: (length > 0.0).then(|| (shadow + light) as f64 / length),
        edge_px: length,
    }
}

impl DepthBand {
    /// What is wrong between each two of some rising view depths, metres.
    pub fn between(truth: &Truth, edges: &Edges, claim: &Claim<'_>, depths: &[f64]) -> Vec<Self> {
        depths.windows(2).map(|pair| band(truth, edges, claim.visibility, pair[0]..pair[1])).collect()
    }
}

fn decades(truth: &Truth, edges: &Edges, visibility: &[f32]) -> Vec<DepthBand> {
    let decade = |depth: f64| depth.log10().floor() as i32;
    let (first, last) = (decade(truth.eye.near), decade(truth.eye.far));
    let bands = (first..=last).map(|d| band(truth, edges, visibility, 10f64.powi(d)..10f64.powi(d + 1)));
    bands.filter(|band| band.pixels > 0).collect()
}

/// Claimed minus true visibility of every judged pixel.
pub(crate) fn differences(truth: &Truth, smooth: Option<&Smooth>, visibility: &[f32]) -> Vec<f64> {
    let hard = |pixel: Pixel| if pixel == Pixel::Lit { 1.0 } else { 0.0 };
    let judged = (0..truth.pixels.len()).filter(|i| truth.pixels[*i].is_judged());
    let truth_at = |i: usize| smooth.map_or_else(|| hard(truth.pixels[i]), |smooth| smooth.visibility[i]);
    judged.map(|i| f64::from(visibility[i]) - f64::from(truth_at(i))).collect()
}
