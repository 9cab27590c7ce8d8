//! Moment shadow maps: four moments of depth (Peters & Klein 2015; Peters et al. 2017).

use super::blurred;
use super::prefilter::{ANISOTROPY, BLUR_TEXELS, DOWNSAMPLE, MIP_LEVELS, Prefilter};
use crate::error::SettingsError;
use crate::filter::bounds::LIGHT_BLEED_REDUCTION;
use crate::filter::family::Family;
use crate::filter::shader::ShaderNumber;
use crate::filter::stored::{MomentTexel, Stored, TexelPrecision};
use crate::filter::technique::Technique;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::moments::{Moments, Msm};
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::kind::Kind;
use crate::schema::values::{Choice, Values};

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "msm",
        label: "MSM",
        help: "Four moments of depth, blurred before they are read.",
        source: "Peters & Klein 2015; Peters et al. 2017",
    },
    keys: &[PRECISION, LIGHT_BLEED_REDUCTION, BLUR_TEXELS, DOWNSAMPLE, MIP_LEVELS, ANISOTROPY],
};

const PRECISION: Key = Key {
    name: "filter.precision",
    label: "precision",
    help: "What a number of the map of moments is.",
    costs: &[Cost::Shader, Cost::Maps],
    values: Values::Choice(&[
        Choice {
            name: "f32",
            label: "32-bit float",
            help: "Needs next to no bias of the moments.",
            source: "Peters et al. 2017",
        },
        Choice {
            name: "u16",
            label: "16-bit unsigned",
            help: "Half of the memory. The moments are biased more, so more light leaks.",
            source: "Peters et al. 2017",
        },
    ]),
    ..Key::of(Group::Filter)
};

/// Four moments of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct FourMoments {
    /// The format of a number of the map: `f32`, the default, or half of the memory as `u16`.
    pub precision: MomentPrecision,
    /// The share of light that is taken for leaked, from 0 to 0.99. The default is 0.1.
    pub light_bleed_reduction: f32,
    /// How moments are made smooth.
    pub prefilter: Prefilter,
}

/// The format of one of four moments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum MomentPrecision {
    /// A 32-bit float.
    F32,
    /// A 16-bit unsigned number, normalised.
    U16,
}

impl Default for FourMoments {
    fn default() -> Self {
        Self { precision: MomentPrecision::F32, light_bleed_reduction: 0.1, prefilter: Prefilter::default() }
    }
}

impl FourMoments {
    fn all_moments(&self) -> Moments {
        Moments::Msm(Msm {
            light_bleed_reduction: self.light_bleed_reduction,
            ..match self.precision {
                MomentPrecision::F32 => Msm::F32,
                MomentPrecision::U16 => Msm::UNORM16,
            }
        })
    }
}

impl Technique for FourMoments {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Prefiltered
    }

    fn validate(&self) -> Result<(), SettingsError> {
        let Self { precision: _, light_bleed_reduction, prefilter } = self;
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
        let texel = MomentTexel { moments: "msm", channels: 4, exponents: [0.0; 2] };
        let precision = match self.precision {
            MomentPrecision::F32 => TexelPrecision::F32,
            MomentPrecision::U16 => TexelPrecision::U16,
        };
        Stored::Prefiltered { texel, precision, prefilter: self.prefilter }
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        blurred::numbers(&self.prefilter, &self.all_moments(), 0.0)
    }

    fn visibility(&self, reader: &Reader<'_>, _query: &Query) -> f32 {
        blurred::visibility(reader, &self.all_moments(), &self.prefilter)
    }
}
