//! Variance shadow maps: depth and its square.
//!
//! Donnelly & Lauritzen, *Variance Shadow Maps*, I3D 2006; Lauritzen, *Summed-Area Variance Shadow Maps*, GPU Gems 3, 2007,
//! chapter 8. Paper → here: M₁, M₂ → x and y of the moments; the smallest variance → `min_variance`; within a texel a flat
//! surface has the variance ¼ ((∂z/∂x)² + (∂z/∂y)²), from `slope`.

use glam::{Vec2, Vec4};

use super::chebyshev::{largest_share_beyond, without_bleed};

/// Variance shadow maps: how a mean and a mean square are read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vsm {
    /// No variance is taken to be smaller, from 0 to 0.01 squares of the depth range.
    pub min_variance: f32,
    /// The share of light that is taken for leaked, from 0 to 0.99: a smaller visibility becomes 0. Light leaks less, and
    /// penumbrae are narrower.
    pub light_bleed_reduction: f32,
}

impl Default for Vsm {
    fn default() -> Self {
        Self {
            min_variance: 1e-6,         // ten times what 32 bits round the square to
            light_bleed_reduction: 0.0, // a bound that stays one
        }
    }
}

impl Vsm {
    pub(super) fn of_depth(depth: f32, slope: Vec2) -> Vec4 {
        // A step larger than the range is a silhouette's, and no depths in 0…1 have a mean square above their mean.
        let slope = slope.clamp(Vec2::NEG_ONE, Vec2::ONE);
        let square = (depth * depth + 0.25 * slope.length_squared()).min(depth);
        Vec4::new(depth, square, 0.0, 0.0)
    }

    pub(super) fn visibility(&self, moments: Vec4, depth: f32) -> f32 {
        let lit = largest_share_beyond(moments.x, moments.y, depth, self.min_variance.sqrt());
        without_bleed(self.light_bleed_reduction, lit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_adds_a_quarter_of_its_square_and_never_more_than_depths_can_vary() {
        assert_eq!(Vsm::of_depth(0.5, Vec2::new(0.2, -0.4)).y, 0.25 + 0.25 * 0.2);
        assert_eq!(Vsm::of_depth(0.5, Vec2::splat(1e30)).y, 0.5);
        assert_eq!(Vsm::of_depth(1.0, Vec2::ONE).y, 1.0, "what is cleared has no slope");
    }
}
