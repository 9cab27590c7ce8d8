//! How wrong a picture's shadows are.
//!
//! All shares are of the judged pixels, 0 to 1. A result shadows a pixel where its visibility is below one half
//! ([`Verdict`]). Names are those of the literature: false shadow is acne's side, false light that of leaks and of shadows
//! that begin too late.

use std::ops::Range;

use crate::causes::{Causes, cause};
use crate::statistics::rank;
use crate::{Edges, Smooth, Truth, Verdict, World};

/// The result of a shadow technique for one light in one picture: what is judged.
#[derive(Clone, Copy, Debug)]
pub struct ShadowResult<'a> {
    /// The visibility of every pixel, 0 to 1, row by row.
    pub visibility: &'a [f32],
    /// The size of the texel that each pixel's shadow was read from, in metres on a plane there that faces the light; 0
    /// where no map serves the pixel.
    pub texel_metres: &'a [f32],
}

/// The error of a result against the truth: how many pixels are wrong, which way, how far, and why.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Error {
    /// Share of judged pixels that are wrong in either direction.
    pub mis_shadowed: f64,
    /// Share of judged pixels that are shadowed and should be lit.
    pub false_shadow: f64,
    /// Share of judged pixels that are lit and should be shadowed.
    pub false_light: f64,
    /// Root mean square error of visibility.
    pub rmse: f64,
    /// Mean absolute error of visibility: it also counts shades that stay on the right side of one half.
    pub mae: f64,
    /// Mean signed error of visibility; above 0 where shadows are too bright.
    pub bias: f64,
    /// Mean displacement of edges, in pixels: the wrong pixels for each pixel of true edge. `None` where the truth has no
    /// edges.
    pub edge_displacement_px: Option<f64>,
    /// The 95th percentile of the distances of wrong pixels from the nearest true edge, in pixels; 0 where none is wrong.
    /// `None` where the truth has no edges.
    pub hausdorff_95_px: Option<f64>,
    /// The causes of wrong pixels; their shares add up to `mis_shadowed`.
    pub causes: Causes,
    /// The same figures by view depth: one band for each power of ten in metres that has judged pixels.
    pub decades: Vec<DepthBand>,
}

/// The errors within a range of view depths. Shares are of the band's own judged pixels, 0 to 1.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DepthBand {
    /// The range of view depths in metres; the end is not part of it.
    pub depths: [f64; 2],
    /// Number of judged pixels in the band.
    pub pixels: usize,
    /// Share of pixels that are wrong in either direction; 0 where no pixel is judged.
    pub mis_shadowed: f64,
    /// Mean absolute error of visibility, against the hard truth; 0 where no pixel is judged.
    pub mae: f64,
    /// Share of pixels that are falsely shadowed; 0 where no pixel is judged.
    pub false_shadow: f64,
    /// Share of pixels that are falsely lit; 0 where no pixel is judged.
    pub false_light: f64,
    /// Mean displacement of edges, in pixels, as in [`Error`]; `None` where the band has no edges.
    pub edge_displacement_px: Option<f64>,
    /// Length of the true edges in the band, in pixels.
    pub edge_px: f64,
}

impl Error {
    /// Compares a result with the truth; `None` where no pixel is judged. `rmse`, `mae` and `bias` are against `smooth`
    /// where it is given, otherwise against the hard truth.
    ///
    /// # Panics
    /// When the result has another number of pixels than the truth.
    pub fn new(
        world: &World,
        truth: &Truth,
        edges: &Edges,
        smooth: Option<&Smooth>,
        result: &ShadowResult<'_>,
    ) -> Option<Self> {
        let ShadowResult { visibility, texel_metres } = result;
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
            let verdict = Verdict::new(Some(*pixel), *visibility);
            let Some(receiver) = truth.receivers[i].filter(|_| verdict.is_wrong()) else {
                continue;
            };
            let distance = edges.distance[i];
            distances.push(f64::from(distance));
            let cause = cause(world, truth, &receiver, verdict, *visibility, texel_metres[i], distance);
            if let Some(cause) = cause {
                *causes.of_mut(cause) += share(1);
            }
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

/// Says what is wrong between two view depths.
pub(crate) fn band(truth: &Truth, edges: &Edges, visibility: &[f32], depths: Range<f64>) -> DepthBand {
    let (mut pixels, mut shadow, mut light, mut length, mut missed) = (0, 0, 0, 0.0, 0.0);
    for (i, pixel) in truth.pixels.iter().enumerate() {
        let inside = truth.receivers[i].is_some_and(|receiver| depths.contains(&receiver.depth));
        let Some(miss) = pixel.miss(visibility[i]).filter(|_| inside) else {
            continue;
        };
        pixels += 1;
        missed += miss;
        length += f64::from(edges.length_at[i]);
        match Verdict::new(Some(*pixel), visibility[i]) {
            Verdict::FalseShadow => shadow += 1,
            Verdict::FalseLight => light += 1,
            Verdict::NotTraced | Verdict::NotJudged | Verdict::Right => {}
        }
    }
    let share = |count: usize| count as f64 / pixels.max(1) as f64;
    DepthBand {
        depths: [depths.start, depths.end],
        pixels,
        mis_shadowed: share(shadow + light),
        mae: missed / pixels.max(1) as f64,
        false_shadow: share(shadow),
        false_light: share(light),
        edge_displacement_px: (length > 0.0).then(|| (shadow + light) as f64 / length),
        edge_px: length,
    }
}

impl DepthBand {
    /// Returns a band for each two neighbours of `depths`, which are view depths in metres in rising order.
    pub fn between(truth: &Truth, edges: &Edges, result: &ShadowResult<'_>, depths: &[f64]) -> Vec<Self> {
        depths.windows(2).map(|pair| band(truth, edges, result.visibility, pair[0]..pair[1])).collect()
    }
}

fn decades(truth: &Truth, edges: &Edges, visibility: &[f32]) -> Vec<DepthBand> {
    let decade = |depth: f64| depth.log10().floor() as i32;
    let (first, last) = (decade(truth.eye.near), decade(truth.eye.far));
    let bands = (first..=last).map(|d| band(truth, edges, visibility, 10f64.powi(d)..10f64.powi(d + 1)));
    bands.filter(|band| band.pixels > 0).collect()
}

/// The result's visibility less the true one, for every judged pixel.
pub(crate) fn differences(truth: &Truth, smooth: Option<&Smooth>, visibility: &[f32]) -> Vec<f64> {
    let hard = truth.pixels.iter().enumerate().filter_map(|(i, pixel)| Some((i, pixel.visibility()?)));
    let truth_at = |i: usize, hard: f32| smooth.map_or(hard, |smooth| smooth.visibility[i]);
    hard.map(|(i, hard)| f64::from(visibility[i]) - f64::from(truth_at(i, hard))).collect()
}
