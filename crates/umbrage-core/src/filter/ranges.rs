//! Whether a filter's numbers are in their ranges.

use super::{Disc, ExponentialVariance, Filter, Footprint, FourMoments, LightSize, Pcss, Prefilter};
use super::{Exponential, SoftMoments, SummedVariance, Variance};
use crate::SettingsError;
use crate::check::{check, check_given, check_most, out_of_range};
use crate::moments::Precision;
use crate::schema::Key;
use crate::schema::filter::{OPTIMISED_SIZE, PCF_SIZE, moments, points, soft};

impl Filter {
    /// Whether every value is in its range, for maps of `resolution` texels a side.
    pub(crate) fn validate(&self, resolution: u32) -> Result<(), SettingsError> {
        match self {
            Self::Hard {} | Self::Bilinear {} => {}
            Self::Pcf { size } => check(&PCF_SIZE, *size)?,
            Self::Optimised { size } => check(&OPTIMISED_SIZE, *size)?,
            Self::Poisson(disc) | Self::Stratified(disc) | Self::Rotated(disc) => {
                disc.validate(&points::TABLE_TAPS)?;
            }
            Self::Vogel(disc) => disc.validate(&points::TAPS)?,
            Self::Footprint(Footprint { taps, max_texels }) => {
                check(&points::TAPS, *taps)?;
                check(&points::FOOTPRINT_MAX_TEXELS, *max_texels)?;
            }
            Self::Pcss(of) => of.validate()?,
            Self::Vsm(of) => of.validate()?,
            Self::Savsm(of) => of.validate()?,
            Self::Esm(Exponential { exponent, prefilter }) => {
                check(&moments::EXPONENT, *exponent)?;
                prefilter.validate()?;
            }
            Self::Evsm2(of) | Self::Evsm4(of) => of.validate()?,
            Self::Msm(FourMoments { precision: _, light_bleed_reduction, prefilter }) => {
                check(&moments::LIGHT_BLEED_REDUCTION, *light_bleed_reduction)?;
                prefilter.validate()?;
            }
            Self::Mssm(SoftMoments { light, max_texels, light_bleed_reduction }) => {
                light.validate()?;
                check(&soft::MSSM_MAX_TEXELS, *max_texels)?;
                check(&moments::LIGHT_BLEED_REDUCTION, *light_bleed_reduction)?;
            }
        }
        self.check_tile(resolution)
    }

    /// Whether it fits tiles of so many texels a side.
    pub(crate) fn check_tile(&self, resolution: u32) -> Result<(), SettingsError> {
        let downsample = self.prefilter().map_or(1, |prefilter| prefilter.downsample).max(1);
        if !resolution.is_multiple_of(downsample) {
            let wanted = "an even number of texels, since `filter.prefilter.downsample` is 2";
            return Err(out_of_range("resolution", f64::from(resolution), wanted));
        }
        let reach = f64::from(self.reach_texels());
        if (0.0..=0.25 * f64::from(resolution)).contains(&reach) {
            return Ok(());
        }
        let wanted = "a filter that reaches no farther than a quarter of `resolution`: make it narrower, or the maps larger";
        Err(out_of_range("filter", reach, wanted))
    }
}

impl Disc {
    fn validate(&self, taps_key: &'static Key) -> Result<(), SettingsError> {
        let Self { taps, radius, radius_texels, centred: _, noise: _, early_out: _ } = self;
        check(taps_key, *taps)?;
        check_given(&points::RADIUS, *radius)?;
        check(&points::RADIUS_TEXELS, *radius_texels)
    }
}

impl LightSize {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { sun_degrees, punctual_metres } = self;
        check(&soft::SUN_DEGREES, *sun_degrees)?;
        check(&soft::PUNCTUAL_METRES, *punctual_metres)
    }
}

impl Pcss {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { light, blockers, taps, max_texels, noise: _ } = self;
        light.validate()?;
        check(&soft::BLOCKERS, *blockers)?;
        check(&points::TAPS, *taps)?;
        check(&soft::PCSS_MAX_TEXELS, *max_texels)
    }
}

impl Prefilter {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { blur_texels, downsample, mip_levels, anisotropy } = *self;
        check(&moments::BLUR_TEXELS, blur_texels)?;
        check(&moments::DOWNSAMPLE, downsample)?;
        check(&moments::MIP_LEVELS, mip_levels)?;
        check(&moments::ANISOTROPY, anisotropy)
    }
}

impl Variance {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { min_standard_deviation, light_bleed_reduction, prefilter } = self;
        check(&moments::MIN_STANDARD_DEVIATION, *min_standard_deviation)?;
        check(&moments::LIGHT_BLEED_REDUCTION, *light_bleed_reduction)?;
        prefilter.validate()
    }
}

impl SummedVariance {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { radius, radius_texels, min_standard_deviation, light_bleed_reduction } = self;
        check_given(&points::BOX_RADIUS, *radius)?;
        check(&points::BOX_RADIUS_TEXELS, *radius_texels)?;
        check(&moments::MIN_STANDARD_DEVIATION, *min_standard_deviation)?;
        check(&moments::LIGHT_BLEED_REDUCTION, *light_bleed_reduction)
    }
}

impl ExponentialVariance {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self {
            precision,
            exponent,
            falling_exponent,
            min_standard_deviation,
            light_bleed_reduction,
            prefilter,
        } = self;
        let (growing, falling) = (&moments::PRECISION_EXPONENT, &moments::FALLING_EXPONENT);
        let most = precision.largest_exponent();
        let wanted = match precision {
            Precision::F32 => growing.wanted,
            Precision::F16 => {
                "above 0 and at most 5.54, since its square must fit 16 bits; or set filter.precision=f32"
            }
        };
        check_most(growing, exponent.unwrap_or(1.0), most, wanted)?;
        check_most(falling, *falling_exponent, most, wanted)?;
        check(&moments::MIN_STANDARD_DEVIATION, *min_standard_deviation)?;
        check(&moments::LIGHT_BLEED_REDUCTION, *light_bleed_reduction)?;
        prefilter.validate()
    }
}
