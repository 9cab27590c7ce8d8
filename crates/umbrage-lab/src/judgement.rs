//! What one light's shadows in a picture come to, against the truth, and what those of several do together.

use rayon::prelude::*;
use umbrage::{LightKind, Settings, ShadowPlan};
use umbrage_judge::{Claim, DepthBand, Edges, Error, Part, Pixel, Receiver, Smooth, Truth, World};

use crate::aliasing::Aliasing;
use crate::heat::Wrongness;
use crate::measurement::{MeasuredLight, TruthCounts};
use crate::truths::Traced;

/// What one light's shadows came to.
pub(crate) struct Judgement {
    pub part: Option<Part>,
    counts: TruthCounts,
    pub splits: Vec<DepthBand>,
    pub around_cuts: Vec<[DepthBand; 2]>,
    pub aliasing: Aliasing,
}

impl Judgement {
    /// Of light number `light` of the plan, by what its maps say of each pixel. `smooth` is a truth between lit and
    /// shadowed, for the figures that know such.
    pub fn new(
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
        let claim = Claim { visibility, texel_metres: &texel_metres };
        // Lamps' views are cut elsewhere, or not at all.
        let is_sun = matches!(plan.lights()[light].kind(), LightKind::Directional { .. });
        let cuts = if is_sun { plan.splits() } else { &[] };
        let counts = TruthCounts {
            pixels: truth.judged(),
            ambiguous: truth.count(Pixel::Ambiguous),
            shadowed: truth.count(Pixel::Shadowed),
            edge_px: edges.length(),
            standard_error: smooth.map_or(0.0, |smooth| mean_error(truth, smooth)),
        };
        let error = Error::new(world, truth, edges, smooth, &claim);
        Self {
            part: error.map(|error| Part { error, pixels: counts.pixels, edge_px: counts.edge_px }),
            counts,
            splits: DepthBand::between(truth, edges, &claim, cuts),
            around_cuts: around_cuts(truth, edges, &claim, cuts),
            aliasing: Aliasing::new(plan, settings, light, truth),
        }
    }

    /// As it is stored, under the light's name.
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
        edge_px: sum.edge_px + counts.edge_px,
        standard_error: sum.standard_error + counts.standard_error * counts.pixels as f64,
    });
    TruthCounts { standard_error: sum.standard_error / sum.pixels.max(1) as f64, ..sum }
}

/// What is claimed of each pixel, against the truth: of its lights, the first that is wrong.
pub(crate) fn wrongness(traced: &[Traced], visibility: &[Vec<f32>]) -> Vec<Wrongness> {
    let of_light =
        |traced: &Traced, visibility: &[f32], i: usize| match (traced.truth.pixels[i], visibility[i] < 0.5) {
            (Pixel::Lit, true) => Wrongness::FalseShadow,
            (Pixel::Shadowed, false) => Wrongness::FalseLight,
            (pixel, _) if pixel.is_judged() => Wrongness::Right,
            _ => Wrongness::NotJudged,
        };
    let pixels = traced.first().map_or(0, |traced| traced.truth.pixels.len());
    let worst = |i: usize| {
        let all =
            || traced.iter().zip(visibility).map(|(traced, visibility)| of_light(traced, visibility, i));
        let wrong = |of: &Wrongness| matches!(of, Wrongness::FalseShadow | Wrongness::FalseLight);
        all().find(wrong).or_else(|| all().find(|of| *of == Wrongness::Right)).unwrap_or(Wrongness::NotJudged)
    };
    (0..pixels).map(worst).collect()
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
fn around_cuts(truth: &Truth, edges: &Edges, claim: &Claim<'_>, splits: &[f64]) -> Vec<[DepthBand; 2]> {
    let inner = splits.iter().skip(1).take(splits.len().saturating_sub(2));
    inner
        .map(|cut| [[0.75 * cut, *cut], [*cut, 1.25 * cut]])
        .filter_map(|sides| {
            let [before, after] = sides.map(|side| DepthBand::between(truth, edges, claim, &side).pop());
            Some([before?, after?])
        })
        .collect()
}
