//! Where to cut the view frustum, so that every shadow map wastes about the same share of its texels.
//!
//! Source: Zhang et al., *Parallel-Split Shadow Maps for Large-scale Virtual Environments*, VRCIA 2006, eqs. 4–7;
//! λ as in Ferko 2010 §3.1 and GPU Gems 3, ch. 10. Paper → here: n → `near`, f → `far`, m → `splits`, C_i → the i-th
//! returned distance. δ_bias moves inner distances only, so that C_0 = n and C_m = f hold (the paper's eq. 7 moves all).
//!
//! Space: view depth, positive metres from the eye.

use std::ops::{Deref, Range};

use arrayvec::ArrayVec;

use crate::camera::Camera;
use crate::convex::ConvexBody;
use crate::light_frustum::Pyramid;
use crate::settings::{MAX_SPLITS, Scheme, Settings};

/// Splits are at least this share of the whole depth range deep, so that none is empty.
const MIN_SHARE: f64 = 1e-6;

/// The split distances C_0 … C_m: view depths in metres, rising. Reads as a slice.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Splits(ArrayVec<f64, { MAX_SPLITS + 1 }>);

impl Deref for Splits {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.0
    }
}

/// Returns the distances C_0 … C_m of a sun; C_0 is `depths.start` and C_m is `depths.end` exactly.
///
/// With `settings.near` (a virtual near) the inner distances are those of a range that starts there; C_0 stays, so that
/// what is nearer still gets shadows. `depths` must be finite with 0 < start < end and `settings` valid.
pub fn split_distances(depths: Range<f32>, settings: &Settings) -> Splits {
    let all = f64::from(depths.start)..f64::from(depths.end);
    distances_within(depths, all, settings)
}

/// Returns the distances of a sun that cut `cut` as [`split_distances`] would, but for C_0 and C_m, which are those of `depths`: what
/// is nearer than what was seen, or farther, has shadows all the same.
pub(crate) fn distances_within(depths: Range<f32>, cut: Range<f64>, settings: &Settings) -> Splits {
    let (near, far) = (f64::from(depths.start), f64::from(depths.end));
    let to = cut.end.clamp(near, far);
    let virtual_near = settings.near.map_or(near, f64::from);
    let from = virtual_near.max(cut.start).clamp(near, to);
    let count = settings.splits;
    let min_depth = (far - near) * MIN_SHARE;
    let mut distances = ArrayVec::new();
    let mut fits = distances.try_push(near).is_ok();
    let mut previous = near;
    for i in 1..count {
        let wanted = match settings.scheme {
            Scheme::Uniform => uniform(from, to, i, count),
            Scheme::Logarithmic => logarithmic(from, to, i, count),
            Scheme::Practical => practical(from, to, i, count, f64::from(settings.lambda)),
            Scheme::Manual => f64::from(settings.manual[i as usize - 1]),
        } + f64::from(settings.split_bias);
        let room_after = min_depth * f64::from(count - i);
        let distance = wanted.max(previous + min_depth).min(far - room_after);
        fits &= distances.try_push(distance).is_ok();
        previous = distance;
    }
    fits &= distances.try_push(far).is_ok();
    debug_assert!(fits, "valid settings have at most MAX_SPLITS splits");
    Splits(distances)
}

/// Returns the distances of a spot, which cut the view depths that its pyramid reaches; all of them where it reaches
/// nothing.
pub(crate) fn spot_splits(
    camera: &Camera,
    pyramid: &Pyramid,
    depths: Range<f32>,
    settings: &Settings,
) -> Splits {
    let all = f64::from(depths.start)..f64::from(depths.end);
    let (eye, forward) = (camera.eye().as_dvec3(), camera.forward().as_dvec3());
    let body = ConvexBody::of_slice(&camera.slice_corners(all)).clipped_by_all(&pyramid.planes());
    let mut reached = f64::INFINITY..f64::NEG_INFINITY;
    for depth in body.corners().map(|corner| forward.dot(corner - eye)) {
        reached = reached.start.min(depth)..reached.end.max(depth);
    }
    let from = (reached.start as f32).clamp(depths.start, depths.end);
    let to = (reached.end as f32).clamp(depths.start, depths.end);
    let reached = if from < to { from..to } else { depths };
    // Distances that were given by hand are a sun's.
    let scheme = if settings.scheme == Scheme::Manual { Scheme::Practical } else { settings.scheme };
    let Settings { lambda, split_bias, near, spot_splits: splits, .. } = *settings;
    split_distances(reached, &Settings { splits, scheme, lambda, split_bias, near, ..Settings::default() })
}

fn uniform(near: f64, far: f64, i: u32, count: u32) -> f64 {
    near + (far - near) * f64::from(i) / f64::from(count)
}

fn logarithmic(near: f64, far: f64, i: u32, count: u32) -> f64 {
    near * (far / near).powf(f64::from(i) / f64::from(count))
}

fn practical(near: f64, far: f64, i: u32, count: u32, lambda: f64) -> f64 {
    lambda * logarithmic(near, far, i, count) + (1.0 - lambda) * uniform(near, far, i, count)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn practical_settings(splits: u32, lambda: f32) -> Settings {
        Settings { splits, lambda, ..Settings::default() }
    }

    #[test]
    fn what_is_seen_is_cut_and_all_has_shadows() {
        let settings = practical_settings(4, 1.0);
        assert_eq!(*distances_within(1.0..900.0, 4.0..64.0, &settings), [1.0, 8.0, 16.0, 32.0, 900.0]);
        let beyond = distances_within(1.0..9.0, 20.0..30.0, &settings);
        assert!(beyond.windows(2).all(|ends| ends[0] < ends[1]), "{beyond:?}");
    }

    #[test]
    fn lambda_zero_gives_equal_slices() {
        assert_eq!(*split_distances(1.0..9.0, &practical_settings(4, 0.0)), [1.0, 3.0, 5.0, 7.0, 9.0]);
    }

    #[test]
    fn practical_splits_are_those_of_v1() {
        for (near, far, lambda, wanted) in [
            (1.0, 800.0, 0.5, vec![1.0, 214.392136, 800.0]),
            (1.0, 800.0, 1.0, vec![1.0, 9.283178, 86.177388, 800.0]),
            (1.0, 800.0, 0.5, vec![1.0, 103.034148, 214.392136, 375.337062, 800.0]),
            (1.0, 1000.0, 0.75, vec![1.0, 66.905060, 148.842082, 320.933456, 1000.0]),
            (0.1, 100.0, 1.0, vec![0.1, 0.562341, 3.162278, 17.782794, 100.0]),
            (0.1, 100.0, 0.75, vec![0.1, 6.690506, 14.884208, 32.093346, 100.0]),
            (1.0, 50.0, 0.0, vec![1.0, 17.333333, 33.666667, 50.0]),
            (0.5, 300.0, 0.75, vec![0.5, 16.447912, 34.919978, 62.464941, 122.621820, 300.0]),
            (0.1, 150.0, 1.0, vec![0.1, 0.622333, 3.872983, 24.102853, 150.0]),
        ] {
            let got = split_distances(near..far, &practical_settings(wanted.len() as u32 - 1, lambda));
            for (i, (got, wanted)) in got.iter().zip(&wanted).enumerate() {
                assert!((got - wanted).abs() <= 6e-8 * wanted + 1e-6, "C_{i} is {got}, not {wanted}");
            }
            assert_eq!(got.len(), wanted.len());
        }
    }

    #[test]
    fn schemes_are_the_ends_of_lambda() {
        let of =
            |scheme, lambda| split_distances(0.5..300.0, &Settings { scheme, lambda, ..Settings::default() });
        assert_eq!(of(Scheme::Uniform, 0.3), of(Scheme::Practical, 0.0));
        assert_eq!(of(Scheme::Logarithmic, 0.3), of(Scheme::Practical, 1.0));
    }

    #[test]
    fn cuts_beyond_far_pile_up_before_it() {
        for (near, far) in [(1.0, 800.0), (0.5, 100.0), (0.5, 200.0)] {
            let settings = Settings { split_bias: 1000.0, ..Settings::default() };
            let got = split_distances(near..far, &settings);
            assert!(got.windows(2).all(|w| w[0] < w[1]) && got[4] == f64::from(far), "{got:?}");
        }
    }

    #[test]
    fn a_virtual_near_moves_the_inner_splits_only() {
        let settings = Settings { near: Some(10.0), lambda: 1.0, splits: 2, ..Settings::default() };
        let got = split_distances(0.1..1000.0, &settings);
        assert_eq!((got[0], got[2]), (f64::from(0.1f32), 1000.0));
        assert!((got[1] - 100.0).abs() < 1e-3, "the mean of 10 and 1000 is 100, got {}", got[1]);
    }

    proptest! {
        #[test]
        fn splits_rise_and_end_exactly_at_near_and_far(
            near in 1e-3f32..1e3, ratio in 1.001f32..1e6, splits in 1u32..=9, lambda in 0.0f32..=1.0,
            bias_share in 0.0f32..2.0, manual_shares in proptest::collection::vec(1e-3f32..2.0, 8), virtual_near in proptest::option::of(1e-3f32..1e4),
            scheme in prop_oneof![Just(Scheme::Uniform), Just(Scheme::Logarithmic), Just(Scheme::Practical), Just(Scheme::Manual)],
        ) {
            let far = near * ratio;
            let split_bias = (bias_share - 1.0).max(0.0) * far;
            let mut manual: Vec<f32> = manual_shares[..splits as usize - 1].iter().map(|share| share * far).collect();
            manual.sort_by(f32::total_cmp);
            let settings = Settings { splits, lambda, split_bias, manual, near: virtual_near, scheme, ..Settings::default() };
            let got = split_distances(near..far, &settings);
            prop_assert_eq!(got.len(), splits as usize + 1);
            prop_assert_eq!((got[0], got[splits as usize]), (f64::from(near), f64::from(far)));
            prop_assert!(got.windows(2).all(|w| w[0] <= w[1]), "{:?}", got);
        }
    }
}
