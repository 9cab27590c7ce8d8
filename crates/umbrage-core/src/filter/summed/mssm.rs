//! Moment soft shadow mapping: soft shadows from a summed-area table of four moments (Peters et al. 2017).

use glam::Vec2;

use super::boxes::{numbers, over, steps};
use crate::error::SettingsError;
use crate::filter::bounds::LIGHT_BLEED_REDUCTION;
use crate::filter::family::Family;
use crate::filter::light_size::{LightSize, PUNCTUAL_METRES, SUN_DEGREES};
use crate::filter::shader::ShaderNumber;
use crate::filter::stored::{MomentTexel, Stored};
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
        name: "mssm",
        label: "soft MSM",
        help: "Soft shadows from a summed-area table of four moments. The cost does not grow with the penumbra.",
        source: "Peters et al. 2017",
    },
    keys: &[SUN_DEGREES, PUNCTUAL_METRES, MAX_TEXELS, LIGHT_BLEED_REDUCTION],
};

const MAX_TEXELS: Key = Key {
    name: "filter.max_texels",
    label: "reach",
    help: "The most that half a side of a box may be; a wider penumbra is cut. \
           More of it makes texels coarser, and sums rounder: they must hold the widest box.",
    source: "Peters et al. 2017",
    unit: "texels",
    costs: &[Cost::Plan, Cost::Shader, Cost::Maps],
    values: Values::number(1.0, 64.0, [1.0, 64.0]),
    ..Key::of(Group::Filter)
};

/// Soft shadows from sums of four moments.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct SoftMoments {
    /// The size of lights that have none of their own.
    pub light: LightSize,
    /// The most that half a side of a box may be, from 1 to 64 texels; a wider penumbra is cut. Maps have so much room
    /// around what is seen. The default is 24.
    pub max_texels: f32,
    /// The share of light that is taken for leaked, from 0 to 0.99. The default is 0.1.
    pub light_bleed_reduction: f32,
}

impl Default for SoftMoments {
    fn default() -> Self {
        Self { light: LightSize::default(), max_texels: 24.0, light_bleed_reduction: 0.1 }
    }
}

impl SoftMoments {
    fn steps(&self) -> f32 {
        steps(self.reach_texels())
    }

    fn msm(&self) -> Msm {
        Msm { light_bleed_reduction: self.light_bleed_reduction, ..Msm::in_steps(self.steps()) }
    }
}

impl Technique for SoftMoments {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Summed
    }

    fn validate(&self) -> Result<(), SettingsError> {
        let Self { light, max_texels, light_bleed_reduction } = self;
        light.validate()?;
        MAX_TEXELS.check(*max_texels)?;
        LIGHT_BLEED_REDUCTION.check(*light_bleed_reduction)
    }

    fn reach_texels(&self) -> f32 {
        self.max_texels + 1.0
    }

    fn offset_reach_texels(&self, _texel_metres: f32) -> f32 {
        1.0
    }

    fn plane_reach_texels(&self) -> f32 {
        0.0
    }

    fn stores(&self) -> Stored {
        let texel = MomentTexel { moments: "msm", channels: 4, exponents: [0.0; 2] };
        Stored::Summed { texel, steps: self.steps() }
    }

    fn light_size(&self) -> Option<LightSize> {
        Some(self.light)
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        let reach = ShaderNumber::f32("UMBRAGE_MAX_TEXELS", self.max_texels);
        std::iter::once(reach).chain(numbers(self.steps(), &Moments::Msm(self.msm()), 0.0)).collect()
    }

    fn visibility(&self, reader: &Reader<'_>, _query: &Query) -> f32 {
        let (msm, moments) = (self.msm(), Moments::Msm(self.msm()));
        // Half a side of the square that has the area of the unit disc.
        let square = 0.5 * std::f32::consts::PI.sqrt();
        let search = reader.penumbra(self.light, self.max_texels, 0.0) * square;
        let blockers = msm.blocker(over(reader, &moments, search), reader.depth());
        let blocker = blockers.map_or(reader.depth(), |(_, depth)| depth);
        let penumbra = reader.penumbra(self.light, self.max_texels, blocker) * square;
        moments.visibility(over(reader, &moments, penumbra.max(Vec2::splat(0.5))), reader.depth())
    }
}
