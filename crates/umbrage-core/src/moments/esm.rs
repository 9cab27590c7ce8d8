//! Exponential shadow maps: the mean of an exponential of depth.
//!
//! Annen et al., *Exponential Shadow Maps*, GI 2008; Salvi, *Rendering Filtered Shadows with Exponential Shadow Maps*,
//! ShaderX6, 2008, whose filter in logarithmic space keeps the exponent free of the format. Paper → here: c → `exponent`;
//! log E[e^(c z)] → x of the moments. Visibility is E[e^(c z)] e^(−c d), at most 1.

use glam::Vec4;

/// Exponential shadow maps: how the mean of an exponential is read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Esm {
    /// c, from 0.001 to 88: the larger it is, the darker it is close behind a caster.
    pub exponent: f32,
}

impl Default for Esm {
    fn default() -> Self {
        Self { exponent: 80.0 } // as in the paper
    }
}

impl Esm {
    /// What e^c can be in 32 bits: c < 88.72 (V11c).
    pub(crate) const MAX_EXPONENT: f32 = 88.0;

    /// The logarithm of nothing: its exponential is 0 beside any other.
    pub(super) const NONE: Vec4 = Vec4::new(-1e30, 0.0, 0.0, 0.0);

    pub(super) fn of_depth(&self, depth: f32) -> Vec4 {
        Vec4::new(self.exponent * depth, 0.0, 0.0, 0.0)
    }

    /// log(e^a + w e^b), from the larger of the two, so that no exponential overflows.
    pub(super) fn add(sum: Vec4, moments: Vec4, weight: f32) -> Vec4 {
        if weight < f32::MIN_POSITIVE {
            return sum;
        }
        let summand = moments.x + weight.ln();
        let (low, high) = (sum.x.min(summand), sum.x.max(summand));
        Vec4::new(high + (1.0 + (low - high).exp()).ln(), 0.0, 0.0, 0.0)
    }

    pub(super) fn visibility(&self, moments: Vec4, depth: f32) -> f32 {
        (moments.x - self.exponent * depth).min(0.0).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_is_that_of_v11c() {
        assert!((f64::from(f32::MAX).ln() - 88.72283906194683).abs() < 1e-6);
        assert!(Esm::MAX_EXPONENT.exp().is_finite());
    }

    #[test]
    fn a_sum_of_logarithms_is_the_logarithm_of_the_sum() {
        let esm = Esm::default();
        let summands = [(0.25, 0.3f64), (0.30, 0.0), (0.35, 0.6), (0.1, 0.1)];
        let sum = summands.iter().fold(Esm::NONE, |sum, (depth, weight)| {
            Esm::add(sum, esm.of_depth(*depth as f32), *weight as f32)
        });
        let direct: f64 =
            summands.iter().map(|(depth, weight): &(f64, f64)| weight * (80.0 * depth).exp()).sum();
        assert!((f64::from(sum.x) - direct.ln()).abs() < 1e-5, "{} is not {}", sum.x, direct.ln());
    }
}
