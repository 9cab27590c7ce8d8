//! What a shadow map can store that may be blurred before it is compared, and what visibility follows from it.
//!
//! A map of depths must be compared first and averaged after. A map of *moments*, means of functions of depth, may be
//! averaged first: blurred, resolved, sampled as any picture. A lookup asks what share of the depths lies before the
//! receiver, and answers with the most light that its moments allow, so that surfaces do not shadow themselves; where
//! several casters overlap that is too much, and light leaks. `docs/sources.md` has the papers; each file of `moments/`
//! is one of them.
//!
//! Space: depths are linear along the light, 0 near it and 1 far; others are taken to the nearer end. Visibility is 1 for
//! lit. All is in f32, as the shaders do it.

mod chebyshev;
mod esm;
mod evsm;
mod exponent;
mod msm;
mod vsm;

#[cfg(test)]
mod properties;
#[cfg(test)]
mod v11;
#[cfg(test)]
mod vectors;

use glam::{Vec2, Vec4};

use crate::filter::shader::ShaderNumber;

pub use esm::Esm;
pub use evsm::{Evsm2, Evsm4};
pub use exponent::{Exponent, Precision};
pub use msm::Msm;
pub use vsm::Vsm;

/// What a texel of a filterable shadow map holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Moments {
    /// Depth and its square.
    Vsm(Vsm),
    /// The logarithm of the mean of an exponential of depth.
    Esm(Esm),
    /// An exponential of depth, and its square.
    Evsm2(Evsm2),
    /// Two exponentials of depth, and their squares.
    Evsm4(Evsm4),
    /// The first four powers of depth, mixed so that they fill their range.
    Msm(Msm),
}

impl Moments {
    /// The name of the moments, which is that of their shader file.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Vsm(_) => "vsm",
            Self::Esm(_) => "esm",
            Self::Evsm2(_) => "evsm2",
            Self::Evsm4(_) => "evsm4",
            Self::Msm(_) => "msm",
        }
    }

    /// The moments of one depth, as they are stored. `slope` is how much depth grows from a texel to the next, to the right and downward;
    /// only [`Vsm`] asks for it.
    pub fn of_depth(&self, depth: f32, slope: Vec2) -> Vec4 {
        let depth = depth.clamp(0.0, 1.0);
        match self {
            Self::Vsm(_) => Vsm::of_depth(depth, slope),
            Self::Esm(esm) => esm.of_depth(depth),
            Self::Evsm2(evsm) => evsm.of_depth(depth),
            Self::Evsm4(evsm) => evsm.of_depth(depth),
            Self::Msm(_) => Msm::of_depth(depth),
        }
    }

    /// The sum of nothing, to begin a mean with.
    pub fn none(&self) -> Vec4 {
        match self {
            Self::Esm(_) => Esm::NONE,
            Self::Vsm(_) | Self::Evsm2(_) | Self::Evsm4(_) | Self::Msm(_) => Vec4::ZERO,
        }
    }

    /// A sum with one more summand. `weight` is not negative; those of a mean add to 1.
    pub fn add(&self, sum: Vec4, moments: Vec4, weight: f32) -> Vec4 {
        match self {
            Self::Esm(_) => Esm::add(sum, moments, weight),
            Self::Vsm(_) | Self::Evsm2(_) | Self::Evsm4(_) | Self::Msm(_) => sum + moments * weight,
        }
    }

    /// How much light reaches a receiver at `depth`, from 0 to 1.
    pub fn visibility(&self, moments: Vec4, depth: f32) -> f32 {
        let depth = depth.clamp(0.0, 1.0);
        match self {
            Self::Vsm(vsm) => vsm.visibility(moments, depth),
            Self::Esm(esm) => esm.visibility(moments, depth),
            Self::Evsm2(evsm) => evsm.visibility(moments, depth),
            Self::Evsm4(evsm) => evsm.visibility(moments, depth),
            Self::Msm(msm) => msm.visibility(moments, depth),
        }
    }

    /// The numbers that their shader text is compiled with. The smallest variance is none of them, since it depends on how
    /// deep a map is.
    pub fn numbers(&self) -> Vec<ShaderNumber> {
        let bleed = |reduction| ShaderNumber::f32("UMBRAGE_MOMENTS_LIGHT_BLEED_REDUCTION", reduction);
        let exponent = |exponent| ShaderNumber::f32("UMBRAGE_MOMENTS_EXPONENT", exponent);
        match *self {
            Self::Vsm(Vsm { min_variance: _, light_bleed_reduction }) => vec![bleed(light_bleed_reduction)],
            Self::Esm(Esm { exponent: steepness }) => vec![exponent(steepness)],
            Self::Evsm2(Evsm2 { exponent: growing, min_variance: _, light_bleed_reduction }) => {
                vec![exponent(growing.get()), bleed(light_bleed_reduction)]
            }
            Self::Evsm4(Evsm4 { positive, negative, min_variance: _, light_bleed_reduction }) => vec![
                exponent(positive.get()),
                ShaderNumber::f32("UMBRAGE_MOMENTS_NEGATIVE_EXPONENT", negative.get()),
                bleed(light_bleed_reduction),
            ],
            Self::Msm(Msm { bias, centre, light_bleed_reduction }) => vec![
                ShaderNumber::f32("UMBRAGE_MOMENTS_BIAS", bias),
                ShaderNumber::f32("UMBRAGE_MOMENTS_CENTRE", centre),
                bleed(light_bleed_reduction),
                ShaderNumber::f32("UMBRAGE_MOMENTS_LEAST_SHARE", Msm::MIN_SHARE),
            ],
        }
    }
}
