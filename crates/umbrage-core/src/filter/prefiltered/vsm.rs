//! Variance shadow maps: mean and variance of depth (Donnelly & Lauritzen 2006).

use super::blurred;
use super::prefilter::{ANISOTROPY, BLUR_TEXELS, DOWNSAMPLE, MIP_LEVELS, Prefilter};
use crate::error::SettingsError;
use crate::filter::bounds::{LIGHT_BLEED_REDUCTION, MIN_STANDARD_DEVIATION, variance};
use crate::filter::family::Family;
use crate::filter::shader::ShaderNumber;
use crate::filter::stored::{MomentTexel, Stored, TexelPrecision};
use crate::filter::technique::Technique;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::moments::{Moments, Vsm};
use crate::schema::kind::Kind;
use crate::schema::values::Choice;

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "vsm",
        label: "VSM",
        help: "Mean and variance of depth, blurred before they are read. Light leaks where shadows overlap.",
        source: "Donnelly & Lauritzen 2006",
    },
    keys: &[MIN_STANDARD_DEVIATION, LIGHT_BLEED_REDUCTION, BLUR_TEXELS, DOWNSAMPLE, MIP_LEVELS, ANISOTROPY],
};

/// Mean and variance of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Variance {
    /// No standard deviation of depth is taken to be smaller, from 0 to 10 metres: less is acne, more lets light in at
    /// contacts. The default is 0.01.
    pub min_standard_deviation: f32,
    /// The share of light that is taken for leaked, from 0 to 0.99. The default is 0.2.
    pub light_bleed_reduction: f32,
    /// How moments are made smooth.
    pub prefilter: Prefilter,
}

impl Default for Variance {
    fn default() -> Self {
        Self { min_standard_deviation: 0.01, light_bleed_reduction: 0.2, prefilter: Prefilter::default() }
    }
}

impl Variance {
    /// The moments in a map where the smallest deviation is such a variance.
    fn of_variance(&self, min_variance: f32) -> Moments {
        Moments::Vsm(Vsm { min_variance, light_bleed_reduction: self.light_bleed_reduction })
    }
}

impl Technique for Variance {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Prefiltered
    }

    fn validate(&self) -> Result<(), SettingsError> {
        let Self { min_standard_deviation, light_bleed_reduction, prefilter } = self;
        MIN_STANDARD_DEVIATION.check(*min_standard_deviation)?;
        LIGHT_BLEED_REDUCTION.check(*light_bleed_reduction)?;
        prefilter.validate()
    }

    fn reach_texels(&self) -> f32 {
        self.prefilter.reach_texels()
    }

    fn offset_reach_texels(&self, _texel_metres: f32) -> f32 {
        1.0
    }

    fn plane_reach_texels(&self) -> f32 {
        0.0
    }

    fn stores(&self) -> Stored {
        let texel = MomentTexel { moments: "vsm", channels: 2, exponents: [0.0; 2] };
        Stored::Prefiltered { texel, precision: TexelPrecision::F32, prefilter: self.prefilter }
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        // Shaders know how deep a map is, and make the variance themselves.
        blurred::numbers(&self.prefilter, &self.of_variance(0.0), self.min_standard_deviation)
    }

    fn visibility(&self, reader: &Reader<'_>, _query: &Query) -> f32 {
        let min_variance = variance(self.min_standard_deviation, reader.map.depth_metres());
        blurred::visibility(reader, &self.of_variance(min_variance), &self.prefilter)
    }
}
