//! What one light's shadows in a picture come to, against the truth, and what those of several do together.

use rayon::prelude::*;
use umbrage::{LightKind, Settings, ShadowPlan};
use umbrage_judge::{
    DepthBand, Edges, Error, Part, Pixel, Receiver, ShadowResult, Smooth, Truth, Verdict, World,
};

use crate::aliasing::Aliasing;
use crate::measurement::{MeasuredLight, TruthCounts};
use crate::truths::Traced;

/// The judgement of one light's shadows.
pub(crate) struct Judgement {
    pub part: Option<Part>,
    counts: TruthCounts,
    pub splits: Vec<DepthBand>,
    pub around_cuts: Vec<[DepthBand; 2]>,
    pub aliasing: Aliasing,
}

impl Judgement {
    /// Judges the shadows of all lights of a plan: their truth and their visibility light by light.
    pub fn by_light(
        world: &World,
        (plan, settings): (&ShadowPlan, &Settings),
        traced: &[Traced],
        smooth: Option<&Vec<Smooth>>,
        visibility: &[Vec<f32>],
    ) -> Vec<Self> {
        let of_light = |(light, (visibility, traced)): (usize, (&Vec<f32>, &Traced))| {
            let smooth = smooth.and_then(|smooth| smooth.get(light));
            Self::new(world, plan, settings, light, traced, smooth, visibility)
        };
        visibility.iter().zip(traced).enumerate().map(of_light).collect()
    }

    /// Judges light number `light` of the plan, by what its maps say of each pixel. `smooth` is a truth between lit and
    /// shadowed, for the figures that know such.
    fn new(
        world: &World,
        plan: &ShadowPlan,
        settings: &Settings,
        light: usize,
        traced: &Traced,
        smooth: Option<&Smooth>,
        visibility: &[f32],
    ) -> Self {
        let Traced { truth, edges } = traced;
        let texel_metres = texel_metres(plan, settings, light, truth);
        let result = ShadowResult { visibility, texel_metres: &texel_metres };
        // The views of punctual lights are cut elsewhere, or not at all.
        let is_sun = matches!(plan.lights()[light].kind(), LightKind::Directional { .. });
        let cuts = if is_sun { plan.splits() } else { &[] };
        let counts = TruthCounts {
            pixels: truth.judged(),
            ambiguous: truth.count(Pixel::Ambiguous),
            shadowed: truth.count(Pixel::Shadowed),
            partial: truth.partial(),
            edge_px: edges.length(),
            standard_error: smooth.map_or(0.0, |smooth| mean_error(truth, smooth)),
        };
        let error = Error::new(world, truth, edges, smooth, &result);
        Self {
            part: error.map(|error| Part { error, pixels: counts.pixels, edge_px: counts.edge_px }),
            counts,
            splits: DepthBand::between(truth, edges, &result, cuts),
            around_cuts: around_cuts(truth, edges, &result, cuts),
            aliasing: Aliasing::new(plan, settings, light, truth),
        }
    }

    /// Returns the figures as they are stored, under the light's name.
    pub fn measured(&self, name: &str) -> MeasuredLight {
        let error = self.part.as_ref().map(|part| part.error.clone());
        MeasuredLight { name: name.to_owned(), truth: self.counts, error, aliasing: self.aliasing.summary }
    }
}

/// The mean standard error over judged pixels; 0 without any.
fn mean_error(truth: &Truth, smooth: &Smooth) -> f64 {
    let pixels = truth.pixels.iter().zip(&smooth.standard_error);
    let sum: f64 = pixels.filter(|(pixel, _)| pixel.is_judged()).map(|(_, error)| f64::from(*error)).sum();
    sum / truth.judged().max(1) as f64
}

/// What the truth says of all lights together.
pub(crate) fn pooled(judgements: &[Judgement]) -> TruthCounts {
    let sum = judgements.iter().fold(TruthCounts::default(), |sum, Judgement { counts, .. }| TruthCounts {
        pixels: sum.pixels + counts.pixels,
        ambiguous: sum.ambiguous + counts.ambiguous,
        shadowed: sum.shadowed + counts.shadowed,
        partial: sum.partial + counts.partial,
        edge_px: sum.edge_px + counts.edge_px,
        standard_error: sum.standard_error + counts.standard_error * counts.pixels as f64,
    });
    TruthCounts { standard_error: sum.standard_error / sum.pixels.max(1) as f64, ..sum }
}

/// The verdict on each pixel, all lights together.
pub(crate) fn verdicts(traced: &[Traced], visibility: &[Vec<f32>]) -> Vec<Verdict> {
    let pixels = traced.first().map_or(0, |traced| traced.truth.pixels.len());
    let of_lights = |i: usize| {
        let lights = traced.iter().zip(visibility);
        Verdict::of_lights(
            lights.map(|(traced, visibility)| Verdict::new(Some(traced.truth.pixels[i]), visibility[i])),
        )
    };
    (0..pixels).map(of_lights).collect()
}

/// The size of the texels that each pixel is read from, on a plane there that faces the light.
fn texel_metres(plan: &ShadowPlan, settings: &Settings, light: usize, truth: &Truth) -> Vec<f32> {
    let size = |receiver: &Receiver| {
        let (position, normal) = (receiver.position.as_vec3(), receiver.normal.as_vec3());
        let view = umbrage::view_of(plan, settings, light, position, normal);
        view.map_or(0.0, |view| view.texel_basis_at(position).texel_metres())
    };
    truth.receivers.par_iter().map(|receiver| receiver.as_ref().map_or(0.0, size)).collect()
}

/// What is wrong within a quarter of each inner cut's depth, before and after it.
fn around_cuts(
    truth: &Truth,
    edges: &Edges,
    result: &ShadowResult<'_>,
    splits: &[f64],
) -> Vec<[DepthBand; 2]> {
    let inner = splits.iter().skip(1).take(splits.len().saturating_sub(2));
    inner
        .map(|cut| [[0.75 * cut, *cut], [*cut, 1.25 * cut]])
        .filter_map(|sides| {
            let [before, after] = sides.map(|side| DepthBand::between(truth, edges, result, &side).pop());
            Some([before?, after?])
        })
        .collect()
}
