//! How a map is read: one variant a technique, each with its own numbers.
//!
//! Three families. *Comparisons* ask of texels around the receiver whether they leave it lit, and weigh the answers
//! (percentage-closer filtering, Reeves et al. 1987): a grid of them, or points on a disc. *Moments* are made of the map
//! before it is read, blurred as any picture, and turned back into visibility ([`crate::moments`]). *Soft* filters first
//! ask how far the blocker is, and are as wide as its penumbra ([`crate::penumbra`]).
//!
//! Widths are in metres on a plane that faces the light, or in texels of the view. A width in metres is the same in every
//! split.

mod kind;
mod numbers;
mod ranges;

use crate::moments::{self, Moments, Msm};

pub use numbers::{
    Disc, Exponential, ExponentialVariance, Footprint, FourMoments, LightSize, MomentPrecision, NoiseSource,
    Pcss, Prefilter, SoftMoments, SummedVariance, Variance,
};

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

impl Filter {
    /// What is stored instead of depth, of a map that is `depth_metres` deep; `None` where depths themselves are read.
    pub fn moments(&self, depth_metres: f32) -> Option<Moments> {
        let least_variance =
            (self.min_standard_deviation_metres() / depth_metres.max(f32::MIN_POSITIVE)).powi(2);
        match self {
            Self::Hard {} | Self::Bilinear {} | Self::Pcf { .. } | Self::Optimised { .. } => None,
            Self::Poisson(_) | Self::Stratified(_) | Self::Rotated(_) | Self::Vogel(_) => None,
            Self::Footprint(_) | Self::Pcss(_) => None,
            Self::Vsm(Variance { light_bleed_reduction, .. })
            | Self::Savsm(SummedVariance { light_bleed_reduction, .. }) => Some(Moments::Vsm(moments::Vsm {
                least_variance,
                light_bleed_reduction: *light_bleed_reduction,
            })),
            Self::Esm(of) => Some(Moments::Esm(moments::Esm { exponent: of.exponent })),
            Self::Evsm2(of) => {
                let (exponent, _) = of.exponents();
                Some(Moments::Evsm2(moments::Evsm2 {
                    exponent,
                    least_variance,
                    light_bleed_reduction: of.light_bleed_reduction,
                }))
            }
            Self::Evsm4(of) => {
                let (positive, negative) = of.exponents();
                Some(Moments::Evsm4(moments::Evsm4 {
                    positive,
                    negative,
                    least_variance,
                    light_bleed_reduction: of.light_bleed_reduction,
                }))
            }
            Self::Msm(of) => Some(Moments::Msm(Msm {
                light_bleed_reduction: of.light_bleed_reduction,
                ..match of.precision {
                    MomentPrecision::F32 => Msm::F32,
                    MomentPrecision::U16 => Msm::UNORM16,
                }
            })),
            Self::Mssm(of) => Some(Moments::Msm(Msm {
                light_bleed_reduction: of.light_bleed_reduction,
                ..Msm::in_steps(self.sum_steps())
            })),
        }
    }

    /// The least deviation of depth that its moments count with, metres; 0 where it asks for none.
    pub fn min_standard_deviation_metres(&self) -> f32 {
        match self {
            Self::Vsm(Variance { min_standard_deviation, .. })
            | Self::Savsm(SummedVariance { min_standard_deviation, .. })
            | Self::Evsm2(ExponentialVariance { min_standard_deviation, .. })
            | Self::Evsm4(ExponentialVariance { min_standard_deviation, .. }) => *min_standard_deviation,
            Self::Hard {} | Self::Bilinear {} | Self::Pcf { .. } | Self::Optimised { .. } => 0.0,
            Self::Poisson(_) | Self::Stratified(_) | Self::Rotated(_) | Self::Vogel(_) => 0.0,
            Self::Footprint(_) | Self::Pcss(_) | Self::Esm(_) | Self::Msm(_) | Self::Mssm(_) => 0.0,
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
                disc.radius_texels.max(0.5) * disc.farthest() + 1.0
            }
            Self::Footprint(Footprint { max_texels, .. })
            | Self::Pcss(Pcss { max_texels, .. })
            | Self::Mssm(SoftMoments { max_texels, .. }) => max_texels + 1.0,
            Self::Savsm(SummedVariance { radius_texels, .. }) => radius_texels.max(0.5) + 1.0,
            Self::Vsm(_) | Self::Esm(_) | Self::Evsm2(_) | Self::Evsm4(_) | Self::Msm(_) => {
                self.prefilter().map_or(1.0, |of| (of.downsample * (of.blur_texels + 1)) as f32)
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
                disc.radius_at(texel_metres) * disc.farthest() + 1.0
            }
            Self::Footprint(_) | Self::Pcss(_) | Self::Savsm(_) | Self::Mssm(_) => 1.0,
            Self::Vsm(_) | Self::Esm(_) | Self::Evsm2(_) | Self::Evsm4(_) | Self::Msm(_) => 1.0,
        }
    }

    /// How far from a receiver its plane is followed, texels; 0 where it is not. A footprint reaches farther where pixels are
    /// much larger than texels, but planes that steep are then seen edge on.
    pub fn plane_reach_texels(&self) -> f32 {
        match self {
            Self::Hard {} | Self::Bilinear {} | Self::Pcf { .. } | Self::Optimised { .. } => {
                self.reach_texels()
            }
            Self::Poisson(_) | Self::Stratified(_) | Self::Rotated(_) | Self::Vogel(_) => self.reach_texels(),
            Self::Footprint(_) => 1.0,
            Self::Pcss(_) => self.reach_texels(),
            Self::Vsm(_) | Self::Esm(_) | Self::Evsm2(_) | Self::Evsm4(_) | Self::Msm(_) => 0.0,
            Self::Savsm(_) | Self::Mssm(_) => 0.0,
        }
    }

    /// The steepest receiver whose plane is followed, as the tangent of the angle between its normal and the light: 40 (88.6°)
    /// where a lookup stays near, and 8 (83°) where it reaches far, since maps need as much room around it. Measured: less
    /// leaves acne on walls along the light.
    pub fn steepest_plane(&self) -> f32 {
        /// That many texels deep a plane is followed at least, from the receiver to where a lookup ends.
        const DEEPEST_TEXELS: f32 = 40.0;
        (DEEPEST_TEXELS / self.plane_reach_texels().max(1.0)).clamp(8.0, 40.0)
    }
}
