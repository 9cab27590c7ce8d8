//! What is made of a map before it is read?

use super::prefiltered::prefilter::Prefilter;

/// What lookups of a filter read. Two filters that store the same can be exchanged without making the maps anew.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stored {
    /// Depths, as casters were drawn.
    Depths,
    /// Moments of depth, made smooth before they are read.
    Prefiltered {
        /// What a texel holds.
        texel: MomentTexel,
        /// The format of its numbers.
        precision: TexelPrecision,
        /// How the moments are made smooth.
        prefilter: Prefilter,
    },
    /// A summed-area table of moments, in whole numbers of 32 bits.
    Summed {
        /// What a texel sums.
        texel: MomentTexel,
        /// The number of steps that make a moment of 1: as many as let the widest box hold no more than 2³² − 1.
        steps: f32,
    },
}

/// What a texel of moments holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MomentTexel {
    /// The name of the moments, which is that of their shader file: `vsm`, `esm`, `evsm2`, `evsm4` or `msm`.
    pub moments: &'static str,
    /// How many numbers it holds: 1, 2 or 4.
    pub channels: u32,
    /// The exponents of the exponential that grows with depth and of the one that falls; 0 where it has none.
    pub exponents: [f32; 2],
}

/// The format of one number of a texel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TexelPrecision {
    /// A 32-bit float.
    F32,
    /// A 16-bit float.
    F16,
    /// A 16-bit unsigned number, normalised.
    U16,
}
