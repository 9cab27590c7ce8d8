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
            Self::Footprint(Footprint { taps, most_texels }) => {
                check(&points::TAPS, *taps)?;
                check(&points::FOOTPRINT_MOST_TEXELS, *most_texels)?;
            }
            Self::Pcss(of) => of.validate()?,
            Self::Vsm(of) => of.validate()?,
            Self::Savsm(of) => of.validate()?,
            Self::Esm(Exponential { exponent, prefilter }) => {
                check(&moments::EXPONENT, *exponent)?;
                prefilter.validate()?;
            }
            Self::Evsm2(of) | Self::Evsm4(of) => of.validate()?,
            Self::Msm(FourMoments { precision: _, bleed, prefilter }) => {
                check(&moments::BLEED, *bleed)?;
                prefilter.validate()?;
            }
            Self::Mssm(SoftMoments { light, most_texels, bleed }) => {
                light.validate()?;
                check(&soft::MSSM_MOST_TEXELS, *most_texels)?;
                check(&moments::BLEED, *bleed)?;
            }
        }
        self.check_tile(resolution)
    }

    /// Whether it fits tiles of so many texels a side.
    pub(crate) fn check_tile(&self, resolution: u32) -> Result<(), SettingsError> {
        let shrink = self.prefilter().map_or(1, |prefilter| prefilter.shrink).max(1);
        if !resolution.is_multiple_of(shrink) {
            let wanted = "an even number of texels, since `filter.prefilter.shrink` is 2";
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
        let Self { taps, radius, radius_texels, centred: _, seed: _, bail: _ } = self;
        check(taps_key, *taps)?;
        check_given(&points::RADIUS, *radius)?;
        check(&points::RADIUS_TEXELS, *radius_texels)
    }
}

impl LightSize {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { sun_degrees, lamp_metres } = self;
        check(&soft::SUN_DEGREES, *sun_degrees)?;
        check(&soft::LAMP_METRES, *lamp_metres)
    }
}

impl Pcss {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { light, blockers, taps, most_texels, seed: _ } = self;
        light.validate()?;
        check(&soft::BLOCKERS, *blockers)?;
        check(&points::TAPS, *taps)?;
        check(&soft::PCSS_MOST_TEXELS, *most_texels)
    }
}

impl Prefilter {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { blur_texels, shrink, levels, anisotropy } = *self;
        check(&moments::BLUR_TEXELS, blur_texels)?;
        check(&moments::SHRINK, shrink)?;
        check(&moments::LEVELS, levels)?;
        check(&moments::ANISOTROPY, anisotropy)
    }
}

impl Variance {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { least_deviation, bleed, prefilter } = self;
        check(&moments::LEAST_DEVIATION, *least_deviation)?;
        check(&moments::BLEED, *bleed)?;
        prefilter.validate()
    }
}

impl SummedVariance {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { radius, radius_texels, least_deviation, bleed } = self;
        check_given(&points::BOX_RADIUS, *radius)?;
        check(&points::BOX_RADIUS_TEXELS, *radius_texels)?;
        check(&moments::LEAST_DEVIATION, *least_deviation)?;
        check(&moments::BLEED, *bleed)
    }
}

impl ExponentialVariance {
    fn validate(&self) -> Result<(), SettingsError> {
        let Self { precision, exponent, falling_exponent, least_deviation, bleed, prefilter } = self;
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
        check(&moments::LEAST_DEVIATION, *least_deviation)?;
        check(&moments::BLEED, *bleed)?;
        prefilter.validate()
    }
}
