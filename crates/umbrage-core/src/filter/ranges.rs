//! Whether a filter's numbers are in their ranges.

use super::{Disc, ExponentialVariance, Filter, Footprint, LightSize, Pcss, Prefilter};
use crate::SettingsError;
use crate::check::check;
use crate::moments::{Esm, Exponent, Precision};

impl Filter {
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
                    f64::from(Esm::LARGEST_EXPONENT),
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
        self.check_tile(resolution)
    }

    /// Whether it fits tiles of so many texels a side.
    pub(crate) fn check_tile(&self, resolution: u32) -> Result<(), SettingsError> {
        let shrink = self.prefilter().map_or(1, |prefilter| prefilter.shrink).max(1);
        if !resolution.is_multiple_of(shrink) {
            let wanted = "an even number of texels, since `filter.prefilter.shrink` is 2";
            return Err(SettingsError::OutOfRange {
                key: "resolution",
                value: f64::from(resolution),
                wanted,
            });
        }
        let wanted = "a filter that reaches no farther than a quarter of `resolution`: make it narrower, or the maps larger";
        check("filter", self.reach_texels(), 0.0, 0.25 * f64::from(resolution), wanted)
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
