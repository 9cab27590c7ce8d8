//! Exponential shadow maps: the mean of an exponential of depth (Annen et al. 2008; Salvi 2008).

use super::blurred;
use super::prefilter::{ANISOTROPY, BLUR_TEXELS, DOWNSAMPLE, MIP_LEVELS, Prefilter};
use crate::error::SettingsError;
use crate::filter::family::Family;
use crate::filter::shader::ShaderNumber;
use crate::filter::stored::{MomentTexel, Stored, TexelPrecision};
use crate::filter::technique::Technique;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::moments::{Esm, Moments};
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::kind::Kind;
use crate::schema::values::{Choice, Values};

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "esm",
        label: "ESM",
        help: "The mean of an exponential of depth. Light leaks close behind a caster.",
        source: "Annen et al. 2008; Salvi 2008",
    },
    keys: &[EXPONENT, BLUR_TEXELS, DOWNSAMPLE, MIP_LEVELS, ANISOTROPY],
};

const EXPONENT: Key = Key {
    name: "filter.exponent",
    label: "exponent",
    help: "How steep the exponential is. A steeper one leaks less light close behind casters, and blurs less.",
    source: "Annen et al. 2008; Salvi 2008",
    costs: &[Cost::Shader, Cost::Maps],
    values: Values::number(1e-3, Esm::MAX_EXPONENT as f64, [1.0, 88.0]),
    note: "since 32 bits end at e^88.7",
    ..Key::of(Group::Filter)
};

/// The mean of an exponential of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Exponential {
    /// How steep the exponential is, from 0.001 to 88. A steeper one leaks less light, and blurs less. The default is 80.
    pub exponent: f32,
    /// How moments are made smooth.
    pub prefilter: Prefilter,
}

impl Default for Exponential {
    fn default() -> Self {
        Self { exponent: 80.0, prefilter: Prefilter::default() } // e^80 has room for sums in 32 bits
    }
}

impl Exponential {
    fn all_moments(&self) -> Moments {
        Moments::Esm(Esm { exponent: self.exponent })
    }
}

impl Technique for Exponential {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Prefiltered
    }

    fn validate(&self) -> Result<(), SettingsError> {
        let Self { exponent, prefilter } = self;
        EXPONENT.check(*exponent)?;
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
        let texel = MomentTexel { moments: "esm", channels: 1, exponents: [self.exponent, 0.0] };
        Stored::Prefiltered { texel, precision: TexelPrecision::F32, prefilter: self.prefilter }
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        blurred::numbers(&self.prefilter, &self.all_moments(), 0.0)
    }

    fn visibility(&self, reader: &Reader<'_>, _query: &Query) -> f32 {
        blurred::visibility(reader, &self.all_moments(), &self.prefilter)
    }
}
