//! The most light that a mean and a variance allow: Chebyshev's inequality, one-sided.
//!
//! Donnelly & Lauritzen, *Variance Shadow Maps*, I3D 2006. Paper → here: M₁, M₂ → `first`, `second`; μ = M₁;
//! σ² = M₂ − M₁²; t → `place`. P(x ≥ t) ≤ σ² / (σ² + (t − μ)²) for t > μ, else 1.
//!
//! Space: any that grows with depth, as depth itself or an exponential of it.

/// The largest share of a distribution that can lie at `place` or beyond it.
pub(super) fn largest_share_beyond(first: f32, second: f32, place: f32, min_standard_deviation: f32) -> f32 {
    // The smallest positive number keeps 0 / 0 away.
    let min_variance = (min_standard_deviation * min_standard_deviation).max(f32::MIN_POSITIVE);
    let variance = (second - first * first).max(min_variance);
    let behind = (place - first).max(0.0);
    variance / (variance + behind * behind)
}

/// Visibility with its lowest part cut off, and the rest stretched: light bleeding reduction, of Lauritzen, *Summed-Area
/// Variance Shadow Maps*, GPU Gems 3, 2007, chapter 8.
pub(super) fn without_bleed(light_bleed_reduction: f32, visibility: f32) -> f32 {
    ((visibility - light_bleed_reduction) / (1.0 - light_bleed_reduction).max(f32::EPSILON)).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cut_of_bleeding_is_v11d() {
        for (visibility, light_bleed_reduction, cut) in
            [(0.1, 0.2, 0.0), (0.5, 0.2, 0.375), (0.9, 0.3, 0.857142857), (1.0, 0.3, 1.0)]
        {
            let got = without_bleed(light_bleed_reduction, visibility);
            assert!(
                (got - cut).abs() < 1e-6,
                "{visibility} without {light_bleed_reduction}: {got}, not {cut}"
            );
        }
    }

    #[test]
    fn the_inequality_is_an_equality_for_two_depths_at_the_farther_one() {
        // A quarter at 0.2, the rest at 0.6: mean 0.5, mean square 0.28.
        assert!((largest_share_beyond(0.5, 0.28, 0.6, 0.0) - 0.75).abs() < 1e-6);
    }
}
