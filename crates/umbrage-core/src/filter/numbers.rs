//! What filters are given: their numbers, with units, ranges and defaults.

use glam::Vec2;

use crate::kernel::poisson;
use crate::moments::{Exponent, Precision};

/// Points on a disc around the receiver that are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Disc {
    /// How many: 1 to 64, from the table 1 to 16.
    pub taps: u32,
    /// Of the disc, metres; in texels where absent.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub radius: Option<f32>,
    /// Of the disc, texels, 0 to 64; where there is a radius in metres, the most that it may become.
    pub radius_texels: f32,
    /// Whether the table's points are moved so that their middle is the receiver. The tutorial's are not: four of them
    /// look half a radius aside.
    pub centred: bool,
    /// What a place is, where each has other points or another angle; `poisson` has the same everywhere.
    pub noise: NoiseSource,
    /// Whether four points on the rim are asked first, and the others only where those disagree.
    pub early_out: bool,
}

/// Comparisons all over what the pixel covers of the map: a parallelogram, and a texel around it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Footprint {
    /// How many: 1 to 64.
    pub taps: u32,
    /// The most that a pixel may reach from its middle, texels, 1 to 64. Maps have so much room around what is seen.
    pub max_texels: f32,
}

/// By what places are told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum NoiseSource {
    /// By pixel: noise that stays on the screen (Jimenez 2014).
    Screen,
    /// By millimetre of the world: noise that stays on things.
    World,
    /// Not at all: no noise, and bands instead.
    None,
}

/// How large lights are.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct LightSize {
    /// The whole angle that a sun is seen under, degrees, 0 to 180; 0 is a point.
    pub sun_degrees: f32,
    /// Diameter of spots and points, metres; 0 is a point.
    pub punctual_metres: f32,
}

/// A disc as wide as the penumbra.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Pcss {
    /// Of lights that have no size of their own.
    pub light: LightSize,
    /// Points that are searched for blockers, 1 to 64.
    pub blockers: u32,
    /// Points that are compared, 1 to 64.
    pub taps: u32,
    /// The most that a radius may be, texels, 1 to 256. Maps have so much room around what is seen.
    pub max_texels: f32,
    /// What a place is; each has another angle.
    pub noise: NoiseSource,
}

/// How a map of moments is made smooth before it is read.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Prefilter {
    /// Of the Gaussian's reach, texels of moments, 0 to 16; its standard deviation is half of it. 0 is no blur.
    pub blur_texels: u32,
    /// How many depths a side make one texel of moments: 1 or 2. With 2, moments have a quarter of the texels, each the
    /// mean of four depths: what multisampling of a map that small would resolve to.
    pub downsample: u32,
    /// Sizes that the moments are kept in, each half of the one before, 1 to 12.
    pub mip_levels: u32,
    /// The most lookups along a long footprint, 1 to 16; needs more than one level.
    pub anisotropy: u32,
}

/// Mean and variance of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Variance {
    /// The least standard deviation, metres, 0 to 10: less is acne, more lets light in at contacts.
    pub min_standard_deviation: f32,
    /// The share of light that is taken for leaked, 0 to 0.99.
    pub light_bleed_reduction: f32,
    /// How moments are made smooth.
    pub prefilter: Prefilter,
}

/// Mean and variance of depth over a box.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct SummedVariance {
    /// Half a side of the box, metres; in texels where absent.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub radius: Option<f32>,
    /// Half a side of the box, texels, 0 to 64; where there is a radius in metres, the most that it may become.
    pub radius_texels: f32,
    /// The least standard deviation, metres, 0 to 10.
    pub min_standard_deviation: f32,
    /// The share of light that is taken for leaked, 0 to 0.99.
    pub light_bleed_reduction: f32,
}

/// The mean of an exponential of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Exponential {
    /// How steep: above 0, at most 88. Steeper leaks less and blurs less.
    pub exponent: f32,
    /// How moments are made smooth.
    pub prefilter: Prefilter,
}

/// Mean and variance of exponentials of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct ExponentialVariance {
    /// What a number of the map is: `f32`, or half of the memory as `f16`.
    pub precision: Precision,
    /// Of the exponential that grows; the most that the precision holds where absent: 42, or 5.54.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub exponent: Option<f32>,
    /// Of the one that falls, for `evsm4`: above 0, and at most as the other.
    pub falling_exponent: f32,
    /// The least standard deviation, metres, 0 to 10.
    pub min_standard_deviation: f32,
    /// The share of light that is taken for leaked, 0 to 0.99.
    pub light_bleed_reduction: f32,
    /// How moments are made smooth.
    pub prefilter: Prefilter,
}

/// Four moments of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct FourMoments {
    /// What a number of the map is: `f32`, or half of the memory as `u16`.
    pub precision: MomentPrecision,
    /// The share of light that is taken for leaked, 0 to 0.99.
    pub light_bleed_reduction: f32,
    /// How moments are made smooth.
    pub prefilter: Prefilter,
}

/// What one of four moments is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum MomentPrecision {
    /// 32-bit float.
    F32,
    /// 16-bit unsigned, normalised.
    U16,
}

/// Soft shadows from sums of four moments.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct SoftMoments {
    /// Of lights that have no size of their own.
    pub light: LightSize,
    /// The most that half a side of a box may be, texels, 1 to 64. Maps have so much room around what is seen.
    pub max_texels: f32,
    /// The share of light that is taken for leaked, 0 to 0.99.
    pub light_bleed_reduction: f32,
}

impl Default for Disc {
    fn default() -> Self {
        Self {
            taps: 16, // the whole table
            radius: None,
            radius_texels: 2.5, // as wide as PCF 5 × 5
            centred: true,
            noise: NoiseSource::Screen,
            early_out: false, // it misses what is narrower than a quarter of the disc
        }
    }
}

impl Default for Footprint {
    fn default() -> Self {
        Self { taps: 32, max_texels: 8.0 } // as many comparisons as PCF 5 × 5; texels are about as large as pixels
    }
}

impl Default for LightSize {
    fn default() -> Self {
        Self { sun_degrees: 0.53, punctual_metres: 0.1 } // our sun, and a bulb with its shade
    }
}

impl Default for Pcss {
    fn default() -> Self {
        Self {
            light: LightSize::default(),
            blockers: 16,
            taps: 32,         // steps of 1/32
            max_texels: 32.0, // 6 % of a map of 1024
            noise: NoiseSource::Screen,
        }
    }
}

impl Default for Prefilter {
    fn default() -> Self {
        Self { blur_texels: 2, downsample: 1, mip_levels: 1, anisotropy: 1 } // as wide as PCF 5 × 5
    }
}

impl Default for Variance {
    fn default() -> Self {
        Self { min_standard_deviation: 0.01, light_bleed_reduction: 0.2, prefilter: Prefilter::default() }
    }
}

impl Default for SummedVariance {
    fn default() -> Self {
        Self { radius: None, radius_texels: 2.5, min_standard_deviation: 0.01, light_bleed_reduction: 0.2 }
    }
}

impl Default for Exponential {
    fn default() -> Self {
        Self { exponent: 80.0, prefilter: Prefilter::default() } // e^80 has room for sums in 32 bits
    }
}

impl Default for ExponentialVariance {
    fn default() -> Self {
        Self {
            precision: Precision::F32,
            exponent: None,
            falling_exponent: 5.0, // as MJP's sample
            min_standard_deviation: 0.01,
            light_bleed_reduction: 0.1,
            prefilter: Prefilter::default(),
        }
    }
}

impl Default for FourMoments {
    fn default() -> Self {
        Self { precision: MomentPrecision::F32, light_bleed_reduction: 0.1, prefilter: Prefilter::default() }
    }
}

impl Default for SoftMoments {
    fn default() -> Self {
        Self { light: LightSize::default(), max_texels: 24.0, light_bleed_reduction: 0.1 }
    }
}

impl Disc {
    /// Its radius in a view whose texels have this side, texels; at least half a texel.
    pub fn radius_at(&self, texel_metres: f32) -> f32 {
        radius_at(self.radius, self.radius_texels, texel_metres)
    }
}

impl Disc {
    /// Its points of the tutorial's table.
    pub fn table(&self) -> Vec<Vec2> {
        poisson(self.taps as usize, self.centred).collect()
    }

    /// How far its farthest point lies from the receiver, in radii: the tutorial's own table leaves its disc.
    pub fn farthest(&self) -> f32 {
        if self.centred { 1.0 } else { 1.25 }
    }
}

impl SummedVariance {
    /// Half a side of its box in a view whose texels have this side, texels; at least half a texel.
    pub fn radius_at(&self, texel_metres: f32) -> f32 {
        radius_at(self.radius, self.radius_texels, texel_metres)
    }
}

/// A radius in a view whose texels have this side, texels: the metres it has, no more than so many texels; at least half a
/// texel.
fn radius_at(metres: Option<f32>, texels: f32, texel_metres: f32) -> f32 {
    metres.map_or(texels, |metres| (metres / texel_metres.max(f32::MIN_POSITIVE)).min(texels)).max(0.5)
}

impl ExponentialVariance {
    /// Of the exponential that grows, and of the one that falls; no more than the precision holds.
    pub(super) fn exponents(&self) -> (Exponent, Exponent) {
        let most = Exponent::most(self.precision);
        let held = |value: f32| Exponent::new(value, self.precision).unwrap_or(most);
        (self.exponent.map_or(most, held), held(self.falling_exponent))
    }
}
