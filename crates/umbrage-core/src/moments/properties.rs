//! What holds of every kind of moments, whatever the depths.

use glam::{Vec2, Vec4};
use proptest::prelude::*;

use super::{Esm, Evsm2, Evsm4, Exponent, Moments, Msm, Precision, Vsm};

/// One of each kind, with defaults, and the extremes of the exponents.
pub(super) fn all() -> [Moments; 8] {
    let exponent = |value, precision| Exponent::new(value, precision).expect("a valid exponent");
    let steepest = exponent(42.0, Precision::F32);
    let half = exponent(5.54, Precision::F16);
    [
        Moments::Vsm(Vsm::default()),
        Moments::Esm(Esm::default()),
        Moments::Evsm2(Evsm2::default()),
        Moments::Evsm2(Evsm2 { exponent: half, min_variance: 1e-5, light_bleed_reduction: 0.0 }),
        Moments::Evsm4(Evsm4::default()),
        Moments::Evsm4(Evsm4 { positive: steepest, negative: steepest, ..Evsm4::default() }),
        Moments::Msm(Msm::F32),
        Moments::Msm(Msm::UNORM16),
    ]
}

/// The mean of the moments of some depths. Weights need not add to 1.
fn mean(moments: &Moments, depths: &[(f32, f32)]) -> Vec4 {
    let total: f32 = depths.iter().map(|(weight, _)| weight).sum();
    depths.iter().fold(moments.none(), |sum, (weight, depth)| {
        moments.add(sum, moments.of_depth(*depth, Vec2::ZERO), weight / total)
    })
}

fn is_visibility(value: f32) -> bool {
    (0.0..=1.0).contains(&value)
}

#[test]
fn one_depth_lights_what_is_before_it_and_darkens_what_is_well_behind() {
    for moments in all() {
        for i in 0..=60 {
            let depth = i as f32 / 100.0;
            let stored = mean(&moments, &[(1.0, depth)]);
            for before in [0.0, 0.5 * depth, depth] {
                let lit = moments.visibility(stored, before);
                assert!(lit > 0.999, "{moments:?} of {depth} at {before}: {lit}");
            }
            for behind in [depth + 0.2, 1.0] {
                let lit = moments.visibility(stored, behind);
                assert!(lit < 0.01, "{moments:?} of {depth} at {behind}: {lit}");
            }
        }
    }
}

#[test]
fn texels_that_no_depths_can_have_made_still_give_a_visibility() {
    let odd = [0.0, 1.0, 0.5, -1.0, 1e-30, 1e30, -1e30, f32::MAX, f32::MIN, f32::MIN_POSITIVE];
    for moments in all() {
        for i in 0..10_000 {
            let stored = Vec4::from([1, 10, 100, 1000].map(|place| odd[i / place % 10]));
            for depth in [-1e30, -0.5, 0.0, 0.3, 1.0, 1.5, f32::MAX] {
                let lit = moments.visibility(stored, depth);
                assert!(is_visibility(lit), "{moments:?} of {stored} at {depth}: {lit}");
                if let Moments::Msm(msm) = moments
                    && let Some((share, mean)) = msm.blocker(stored, depth)
                {
                    assert!(share > 0.0 && share <= 1.0 + 1e-6, "{stored} at {depth}: share {share}");
                    assert!((0.0..=1.0).contains(&mean), "{stored} at {depth}: mean {mean}");
                }
            }
        }
    }
}

#[test]
fn weights_of_nothing_change_nothing() {
    for moments in all() {
        let stored = mean(&moments, &[(0.5, 0.2), (0.5, 0.6)]);
        let other = moments.of_depth(0.9, Vec2::ZERO);
        assert_eq!(moments.add(stored, other, 0.0), stored, "{moments:?}");
    }
}

prop_compose! {
    /// Depths of a 256th, so that two are equal or well apart.
    fn depth()(step in 0u32..=256) -> f32 { step as f32 / 256.0 }
}

proptest! {
    #[test]
    fn no_bound_is_darker_than_the_truth_by_more_than_its_bias(
        depths in proptest::array::uniform3((0.01f32..1.0, depth())), receiver in depth(),
    ) {
        let total: f32 = depths.iter().map(|(weight, _)| weight).sum();
        let beyond = depths.iter().filter(|(_, depth)| *depth >= receiver);
        let lit = beyond.map(|(weight, _)| weight).sum::<f32>() / total;
        for moments in all() {
            let darker = match moments {
                Moments::Vsm(_) | Moments::Esm(_) | Moments::Evsm2(_) | Moments::Evsm4(_) => 0.0,
                Moments::Msm(msm) => msm.bias,
            };
            let got = moments.visibility(mean(&moments, &depths), receiver);
            // What 32 bits round in sums, of numbers about 1, and in squares of exponentials.
            prop_assert!(is_visibility(got) && got > lit - darker - 1e-3, "{:?}: {} < {}", moments, got, lit);
        }
    }

    #[test]
    fn blockers_are_darker_and_nearer_than_the_receiver(
        depths in proptest::array::uniform3((0.01f32..1.0, depth())), receiver in depth(),
    ) {
        for msm in [Msm::F32, Msm::UNORM16] {
            let moments = Moments::Msm(msm);
            let stored = mean(&moments, &depths);
            let shadow = 1.0 - moments.visibility(stored, receiver);
            match msm.blocker(stored, receiver) {
                None => prop_assert!(shadow <= 1.1 * Msm::MIN_SHARE, "shadow {}", shadow),
                Some((share, mean)) => {
                    prop_assert!((share - shadow).abs() < 1e-6, "{} of blockers, shadow {}", share, shadow);
                    prop_assert!((0.0..=receiver).contains(&mean), "{} before {}", mean, receiver);
                }
            }
        }
    }
}
