//! How a map is read: one variant a technique, each with its own numbers.
//!
//! Three families. *Comparisons* ask of texels around the receiver whether they leave it lit, and weigh the answers
//! (percentage-closer filtering, Reeves et al. 1987): a grid of them, or points on a disc. *Moments* are made of the map
//! before it is read, blurred as any picture, and turned back into visibility ([`crate::moments`]). *Soft* filters first
//! ask how far the blocker is, and are as wide as its penumbra ([`crate::penumbra`]).
//!
//! Widths are in metres on a plane that faces the light, or in texels of the view. A width in metres is the same in every
//! split.

use crate::SettingsError;
use crate::check::check;
use crate::moments::{self, Exponent, Moments, Msm, Precision};

/// How a map is read; each variant has a file of shader code.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields))]
pub enum Filter {
    /// One comparison with the nearest texel.
    Hard {},
    /// Four comparisons, weighted bilinearly.
    Bilinear {},
    /// The mean of `size` × `size` bilinear lookups, one texel apart.
    Pcf {
        /// Lookups a side: 1, 3, 5, 7 or 9.
        size: u32,
    },
    /// A bell-shaped kernel of bilinear lookups, in as few of them as can be (Castaño 2013).
    Optimised {
        /// Texels a side of the bell: 3, 5 or 7.
        size: u32,
    },
    /// A fixed table of points on a disc (opengl-tutorial 16).
    Poisson(Disc),
    /// Points picked at random from that table, at each place others (opengl-tutorial 16).
    Stratified(Disc),
    /// That table, at each place turned by another angle.
    Rotated(Disc),
    /// A spiral of equal areas (Vogel 1979), at each place turned by another angle.
    Vogel(Disc),
    /// What the pixel covers of the map.
    Footprint(Footprint),
    /// Percentage-closer soft shadows: a disc as wide as the penumbra (Fernando 2005).
    Pcss(Pcss),
    /// Mean and variance of depth (Donnelly & Lauritzen 2006).
    Vsm(Variance),
    /// The same over boxes of any size, from a summed-area table (Lauritzen 2007).
    Savsm(SummedVariance),
    /// The mean of an exponential of depth (Annen et al. 2008; Salvi 2008).
    Esm(Exponential),
    /// Mean and variance of an exponential of depth (Lauritzen & McCool 2008).
    Evsm2(ExponentialVariance),
    /// The same, and of an exponential that falls.
    Evsm4(ExponentialVariance),
    /// Four moments of depth (Peters & Klein 2015; Peters et al. 2017).
    Msm(FourMoments),
    /// Soft shadows from a summed-area table of four moments (Peters et al. 2017).
    Mssm(SoftMoments),
}

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
    /// What a place is, where each has other points or another angle.
    pub seed: Seed,
    /// Whether four points on the rim are asked first, and the others only where those disagree.
    pub bail: bool,
}

/// Comparisons all over what the pixel covers of the map: a parallelogram, and a texel around it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Footprint {
    /// How many: 1 to 64.
    pub taps: u32,
    /// The most that a pixel may reach from its middle, texels, 1 to 64. Maps have so much room around what is seen.
    pub most_texels: f32,
}

/// By what places are told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Seed {
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
    pub lamp_metres: f32,
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
    pub most_texels: f32,
    /// What a place is; each has another angle.
    pub seed: Seed,
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
    pub shrink: u32,
    /// Sizes that the moments are kept in, each half of the one before, 1 to 12.
    pub levels: u32,
    /// The most lookups along a long footprint, 1 to 16; needs more than one level.
    pub anisotropy: u32,
}

/// Mean and variance of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Variance {
    /// The least standard deviation, metres, 0 to 10: less is acne, more lets light in at contacts.
    pub least_deviation: f32,
    /// The share of light that is taken for leaked, 0 to 0.99.
    pub bleed: f32,
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
    pub least_deviation: f32,
    /// The share of light that is taken for leaked, 0 to 0.99.
    pub bleed: f32,
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
    pub least_deviation: f32,
    /// The share of light that is taken for leaked, 0 to 0.99.
    pub bleed: f32,
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
    pub bleed: f32,
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
    pub most_texels: f32,
    /// The share of light that is taken for leaked, 0 to 0.99.
    pub bleed: f32,
}

impl Default for Disc {
    fn default() -> Self {
        Self {
            taps: 16, // the whole table
            radius: None,
            radius_texels: 2.5, // as wide as PCF 5 × 5
            centred: true,
            seed: Seed::Screen,
            bail: false, // it misses what is narrower than a quarter of the disc
        }
    }
}

impl Default for Footprint {
    fn default() -> Self {
        Self { taps: 32, most_texels: 8.0 } // as many comparisons as PCF 5 × 5; texels are about as large as pixels
    }
}

impl Default for LightSize {
    fn default() -> Self {
        Self { sun_degrees: 0.53, lamp_metres: 0.1 } // our sun, and a bulb with its shade
    }
}

impl Default for Pcss {
    fn default() -> Self {
        Self {
            light: LightSize::default(),
            blockers: 16,
            taps: 32,          // steps of 1/32
            most_texels: 32.0, // 6 % of a map of 1024
            seed: Seed::Screen,
        }
    }
}

impl Default for Prefilter {
    fn default() -> Self {
        Self { blur_texels: 2, shrink: 1, levels: 1, anisotropy: 1 } // as wide as PCF 5 × 5
    }
}

impl Default for Variance {
    fn default() -> Self {
        Self { least_deviation: 0.01, bleed: 0.2, prefilter: Prefilter::default() }
    }
}

impl Default for SummedVariance {
    fn default() -> Self {
        Self { radius: None, radius_texels: 2.5, least_deviation: 0.01, bleed: 0.2 }
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
            least_deviation: 0.01,
            bleed: 0.1,
            prefilter: Prefilter::default(),
        }
    }
}

impl Default for FourMoments {
    fn default() -> Self {
        Self { precision: MomentPrecision::F32, bleed: 0.1, prefilter: Prefilter::default() }
    }
}

impl Default for SoftMoments {
    fn default() -> Self {
        Self { light: LightSize::default(), most_texels: 24.0, bleed: 0.1 }
    }
}

impl Disc {
    /// Its radius in a view whose texels have this side, texels; at least half a texel.
    pub fn radius_at(&self, texel_metres: f32) -> f32 {
        radius_at(self.radius, self.radius_texels, texel_metres)
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

impl Filter {
    /// What is stored instead of depth, of a map that is `depth_metres` deep; `None` where depths themselves are read.
    pub fn moments(&self, depth_metres: f32) -> Option<Moments> {
        let variance = |deviation: f32| (deviation / depth_metres.max(f32::MIN_POSITIVE)).powi(2).min(0.01);
        match self {
            Self::Hard {} | Self::Bilinear {} | Self::Pcf { .. } | Self::Optimised { .. } => None,
            Self::Poisson(_) | Self::Stratified(_) | Self::Rotated(_) | Self::Vogel(_) => None,
            Self::Footprint(_) | Self::Pcss(_) => None,
            Self::Vsm(Variance { least_deviation, bleed, .. })
            | Self::Savsm(SummedVariance { least_deviation, bleed, .. }) => {
                let least_variance = variance(*least_deviation);
                Some(Moments::Vsm(moments::Vsm { least_variance, bleed: *bleed }))
            }
            Self::Esm(of) => Some(Moments::Esm(moments::Esm { exponent: of.exponent })),
            Self::Evsm2(of) => {
                let (exponent, _) = of.exponents();
                let least_variance = variance(of.least_deviation);
                Some(Moments::Evsm2(moments::Evsm2 { exponent, least_variance, bleed: of.bleed }))
            }
            Self::Evsm4(of) => {
                let (positive, negative) = of.exponents();
                let least_variance = variance(of.least_deviation);
                Some(Moments::Evsm4(moments::Evsm4 { positive, negative, least_variance, bleed: of.bleed }))
            }
            Self::Msm(of) => Some(Moments::Msm(Msm {
                bleed: of.bleed,
                ..match of.precision {
                    MomentPrecision::F32 => Msm::F32,
                    MomentPrecision::U16 => Msm::UNORM16,
                }
            })),
            Self::Mssm(of) => Some(Moments::Msm(Msm { bleed: of.bleed, ..Msm::in_steps(self.sum_steps()) })),
        }
    }

    /// How its map of moments is made smooth; `None` where it has none, or sums of them.
    pub fn prefilter(&self) -> Option<&Prefilter> {
        match self {
            Self::Vsm(Variance { prefilter, .. })
            | Self::Esm(Exponential { prefilter, .. })
            | Self::Evsm2(ExponentialVariance { prefilter, .. })
            | Self::Evsm4(ExponentialVariance { prefilter, .. })
            | Self::Msm(FourMoments { prefilter, .. }) => Some(prefilter),
            Self::Hard {} | Self::Bilinear {} | Self::Pcf { .. } | Self::Optimised { .. } => None,
            Self::Poisson(_) | Self::Stratified(_) | Self::Rotated(_) | Self::Vogel(_) => None,
            Self::Footprint(_) | Self::Pcss(_) => None,
            Self::Savsm(_) | Self::Mssm(_) => None,
        }
    }

    /// How large it takes lights to be; `None` where it does not ask.
    pub fn light_size(&self) -> Option<LightSize> {
        match self {
            Self::Pcss(Pcss { light, .. }) | Self::Mssm(SoftMoments { light, .. }) => Some(*light),
            Self::Hard {} | Self::Bilinear {} | Self::Pcf { .. } | Self::Optimised { .. } => None,
            Self::Poisson(_)
            | Self::Stratified(_)
            | Self::Rotated(_)
            | Self::Vogel(_)
            | Self::Footprint(_) => None,
            Self::Vsm(_) | Self::Savsm(_) | Self::Esm(_) | Self::Evsm2(_) | Self::Evsm4(_) | Self::Msm(_) => {
                None
            }
        }
    }

    /// Steps that make a moment of 1 in a summed-area table of 32-bit whole numbers: as many as let the widest box hold no
    /// more than 2³² − 1.
    pub fn sum_steps(&self) -> f32 {
        // A box that cuts texels on both sides counts one more.
        let side = f64::from(2.0 * self.reach_texels()).ceil() + 1.0;
        (f64::from(u32::MAX) / (side * side)).floor() as f32
    }

    /// How far a lookup may reach from its centre, texels: a nearest lookup half a texel, a bilinear one a whole.
    pub fn reach_texels(&self) -> f32 {
        match self {
            Self::Hard {} => 0.5,
            Self::Bilinear {} => 1.0,
            Self::Pcf { size } | Self::Optimised { size } => 0.5 * *size as f32 + 0.5,
            Self::Poisson(disc) | Self::Stratified(disc) | Self::Rotated(disc) | Self::Vogel(disc) => {
                disc.radius_texels.max(0.5) + 1.0
            }
            Self::Footprint(Footprint { most_texels, .. })
            | Self::Pcss(Pcss { most_texels, .. })
            | Self::Mssm(SoftMoments { most_texels, .. }) => most_texels + 1.0,
            Self::Savsm(SummedVariance { radius_texels, .. }) => radius_texels.max(0.5) + 1.0,
            Self::Vsm(_) | Self::Esm(_) | Self::Evsm2(_) | Self::Evsm4(_) | Self::Msm(_) => {
                self.prefilter().map_or(1.0, |of| (of.shrink * (of.blur_texels + 1)) as f32)
            }
        }
    }

    /// How much of that the offset along the normal must cover in a view whose texels have this side, texels. Penumbrae
    /// begin at nothing; moments know the slope of what they hold.
    pub fn offset_reach_texels(&self, texel_metres: f32) -> f32 {
        match self {
            Self::Hard {} | Self::Bilinear {} | Self::Pcf { .. } | Self::Optimised { .. } => {
                self.reach_texels()
            }
            Self::Poisson(disc) | Self::Stratified(disc) | Self::Rotated(disc) | Self::Vogel(disc) => {
                disc.radius_at(texel_metres) + 1.0
            }
            Self::Footprint(_) | Self::Pcss(_) | Self::Savsm(_) | Self::Mssm(_) => 1.0,
            Self::Vsm(_) | Self::Esm(_) | Self::Evsm2(_) | Self::Evsm4(_) | Self::Msm(_) => 1.0,
        }
    }

    /// The steepest receiver whose plane is followed, as the tangent of the angle between its normal and the light: 40 (88.6°)
    /// where a lookup stays near, and 8 (83°) where it reaches far. A steep plane is soon before the near plane, or behind
    /// what it stands on, and maps need as much room around it. Measured: less leaves acne on walls along the light.
    pub fn steepest_plane(&self) -> f32 {
        /// That many texels deep a plane is followed, from the receiver to where a lookup ends.
        const DEEPEST_TEXELS: f32 = 40.0;
        let reach = match self {
            Self::Pcss(_) => self.reach_texels(),
            _ => self.offset_reach_texels(f32::MIN_POSITIVE),
        };
        (DEEPEST_TEXELS / reach).clamp(8.0, 40.0)
    }

    /// Whether every value is in its range, for maps of `resolution` texels a side.
    pub(crate) fn validate(&self, resolution: u32) -> Result<(), SettingsError> {
        match self {
            Self::Hard {} | Self::Bilinear {} => {}
            Self::Pcf { size: 1 | 3 | 5 | 7 | 9 } | Self::Optimised { size: 3 | 5 | 7 } => {}
            Self::Pcf { size } => return wrong_size(*size, "1, 3, 5, 7 or 9 lookups a side"),
            Self::Optimised { size } => return wrong_size(*size, "3, 5 or 7 texels a side"),
            Self::Poisson(disc) | Self::Stratified(disc) | Self::Rotated(disc) => disc.validate(16.0)?,
            Self::Vogel(disc) => disc.validate(64.0)?,
            Self::Footprint(Footprint { taps, most_texels }) => {
                check("filter.taps", f64::from(*taps), 1.0, 64.0, "from 1 to 64 points")?;
                check("filter.most_texels", *most_texels, 1.0, 64.0, "from 1 to 64 texels")?;
            }
            Self::Pcss(of) => of.validate()?,
            Self::Vsm(of) => {
                check_deviation(of.least_deviation)?;
                check_bleed(of.bleed)?;
                of.prefilter.validate()?;
            }
            Self::Savsm(of) => {
                check_radius(of.radius, of.radius_texels)?;
                check_deviation(of.least_deviation)?;
                check_bleed(of.bleed)?;
            }
            Self::Esm(of) => {
                check(
                    "filter.exponent",
                    of.exponent,
                    1e-3,
                    88.0,
                    "from 0.001 to 88, since 32 bits end at e^88.7",
                )?;
                of.prefilter.validate()?;
            }
            Self::Evsm2(of) | Self::Evsm4(of) => of.validate()?,
            Self::Msm(of) => {
                check_bleed(of.bleed)?;
                of.prefilter.validate()?;
            }
            Self::Mssm(of) => {
                of.light.validate()?;
                check("filter.most_texels", of.most_texels, 1.0, 64.0, "from 1 to 64 texels")?;
                check_bleed(of.bleed)?;
            }
        }
        let wanted = "a filter that reaches no farther than a quarter of `resolution`: make it narrower, or the maps larger";
        check("filter", self.reach_texels(), 0.0, 0.25 * f64::from(resolution), wanted)
    }
}

impl ExponentialVariance {
    /// Of the exponential that grows, and of the one that falls; no more than the precision holds.
    fn exponents(&self) -> (Exponent, Exponent) {
        let most = Exponent::most(self.precision);
        let held = |value: f32| Exponent::new(value, self.precision).unwrap_or(most);
        (self.exponent.map_or(most, held), held(self.falling_exponent))
    }
}

impl Disc {
    fn validate(&self, most_taps: f64) -> Result<(), SettingsError> {
        let Self { taps, radius, radius_texels, centred: _, seed: _, bail: _ } = self;
        let wanted =
            if most_taps > 16.0 { "from 1 to 64 points" } else { "from 1 to 16 points, which the table has" };
        check("filter.taps", f64::from(*taps), 1.0, most_taps, wanted)?;
        check_radius(*radius, *radius_texels)
    }
}

impl LightSize {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { sun_degrees, lamp_metres } = self;
        check("filter.light.sun_degrees", *sun_degrees, 0.0, 180.0, "from 0 to 180 degrees")?;
        check("filter.light.lamp_metres", *lamp_metres, 0.0, 1e4, "from 0 to 10000 metres")
    }
}

impl Pcss {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { light, blockers, taps, most_texels, seed: _ } = self;
        light.validate()?;
        check("filter.blockers", f64::from(*blockers), 1.0, 64.0, "from 1 to 64 points")?;
        check("filter.taps", f64::from(*taps), 1.0, 64.0, "from 1 to 64 points")?;
        check("filter.most_texels", *most_texels, 1.0, 256.0, "from 1 to 256 texels")
    }
}

impl Prefilter {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { blur_texels, shrink, levels, anisotropy } = *self;
        check("filter.prefilter.blur_texels", f64::from(blur_texels), 0.0, 16.0, "from 0 to 16 texels")?;
        check("filter.prefilter.shrink", f64::from(shrink), 1.0, 2.0, "1 or 2 depths a side")?;
        check("filter.prefilter.levels", f64::from(levels), 1.0, 12.0, "from 1 to 12 sizes")?;
        check("filter.prefilter.anisotropy", f64::from(anisotropy), 1.0, 16.0, "from 1 to 16 lookups")
    }
}

impl ExponentialVariance {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { precision, exponent, falling_exponent, least_deviation, bleed, prefilter } = self;
        let most = f64::from(Exponent::most(*precision).get());
        let wanted = match precision {
            Precision::F32 => "above 0 and at most 42, since its square must fit 32 bits",
            Precision::F16 => {
                "above 0 and at most 5.54, since its square must fit 16 bits; or set filter.precision=f32"
            }
        };
        check("filter.exponent", exponent.unwrap_or(1.0), 1e-3, most, wanted)?;
        check("filter.falling_exponent", *falling_exponent, 1e-3, most, wanted)?;
        check_deviation(*least_deviation)?;
        check_bleed(*bleed)?;
        prefilter.validate()
    }
}

fn wrong_size(size: u32, wanted: &'static str) -> Result<(), SettingsError> {
    Err(SettingsError::OutOfRange { key: "filter.size", value: f64::from(size), wanted })
}

fn check_radius(metres: Option<f32>, texels: f32) -> Result<(), SettingsError> {
    check("filter.radius", metres.unwrap_or(0.0), 0.0, 1e3, "from 0 to 1000 metres")?;
    check("filter.radius_texels", texels, 0.0, 64.0, "from 0 to 64 texels")
}

fn check_deviation(metres: f32) -> Result<(), SettingsError> {
    check("filter.least_deviation", metres, 0.0, 10.0, "from 0 to 10 metres")
}

fn check_bleed(share: f32) -> Result<(), SettingsError> {
    check("filter.bleed", share, 0.0, 0.99, "from 0 to 0.99")
}
