//! Exponential variance shadow maps: exponentials of depth, and their squares.
//!
//! Lauritzen & McCool, *Layered Variance Shadow Maps*, GI 2008. Paper → here: the warps e^(c z) and −e^(−c z) of
//! depths taken to −1…1 → `warp`, c → an [`Exponent`]. Two depths lie further apart after the first warp the farther they
//! are, after the second the nearer; each is a variance shadow map, and the darker of the two counts.

use glam::Vec4;

use super::chebyshev::{largest_share_beyond, without_bleed};
use super::exponent::Exponent;

/// Exponential variance shadow maps of the positive exponential alone: how its mean and mean square are read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evsm2 {
    /// The exponent c of e^(c z).
    pub exponent: Exponent,
    /// No variance of depth is taken to be smaller, from 0 to 0.01 squares of the depth range. In 16 bits squares are
    /// rounded to a 2048th, which is a variance of about 1e-5.
    pub min_variance: f32,
    /// The share of light that is taken for leaked, from 0 to 0.99: a smaller visibility becomes 0.
    pub light_bleed_reduction: f32,
}

/// Exponential variance shadow maps of both exponentials: how their means and mean squares are read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evsm4 {
    /// The exponent c of e^(c z).
    pub positive: Exponent,
    /// The exponent c of −e^(−c z).
    pub negative: Exponent,
    /// No variance of depth is taken to be smaller; see [`Evsm2::min_variance`].
    pub min_variance: f32,
    /// The share of light that is taken for leaked, from 0 to 0.99: a smaller visibility becomes 0.
    pub light_bleed_reduction: f32,
}

/// A 20,000th of the depth range, squared: above what 32 bits round the squares to, for exponents from 5.
const MIN_VARIANCE: f32 = 2.5e-9;

impl Default for Evsm2 {
    fn default() -> Self {
        Self {
            exponent: Exponent::STEEP, // the steeper, the less light leaks
            min_variance: MIN_VARIANCE,
            light_bleed_reduction: 0.0, // a bound that stays one
        }
    }
}

impl Default for Evsm4 {
    fn default() -> Self {
        Self {
            positive: Exponent::STEEP,  // the steeper, the less light leaks
            negative: Exponent::GENTLE, // steeper, penumbrae are cut where one caster lies before another
            min_variance: MIN_VARIANCE,
            light_bleed_reduction: 0.0, // a bound that stays one
        }
    }
}

/// An exponential of depth that grows with depth; its exponent has the sign of the warp.
fn warp(exponent: f32, depth: f32) -> f32 {
    exponent.signum() * (exponent * (2.0 * depth - 1.0)).exp()
}

/// What one warp allows at `depth`.
fn largest_share_behind(exponent: f32, min_variance: f32, first: f32, second: f32, depth: f32) -> f32 {
    let place = warp(exponent, depth);
    // The warp stretches a small step of depth by its derivative.
    let min_standard_deviation = 2.0 * exponent * min_variance.sqrt() * place;
    largest_share_beyond(first, second, place, min_standard_deviation)
}

impl Evsm2 {
    pub(super) fn of_depth(&self, depth: f32) -> Vec4 {
        let warped = warp(self.exponent.get(), depth);
        Vec4::new(warped, warped * warped, 0.0, 0.0)
    }

    pub(super) fn visibility(&self, moments: Vec4, depth: f32) -> f32 {
        let lit = largest_share_behind(self.exponent.get(), self.min_variance, moments.x, moments.y, depth);
        without_bleed(self.light_bleed_reduction, lit)
    }
}

impl Evsm4 {
    pub(super) fn of_depth(&self, depth: f32) -> Vec4 {
        let (positive, negative) = (warp(self.positive.get(), depth), warp(-self.negative.get(), depth));
        Vec4::new(positive, positive * positive, negative, negative * negative)
    }

    pub(super) fn visibility(&self, moments: Vec4, depth: f32) -> f32 {
        let lit =
            |exponent, first, second| largest_share_behind(exponent, self.min_variance, first, second, depth);
        let positive = lit(self.positive.get(), moments.x, moments.y);
        let negative = lit(-self.negative.get(), moments.z, moments.w);
        without_bleed(self.light_bleed_reduction, positive.min(negative))
    }
}
