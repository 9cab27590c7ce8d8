//! Summed-area variance shadow maps: mean and variance of depth over a box (Lauritzen 2007).

use glam::Vec2;

use super::boxes::{numbers, over, steps};
use crate::error::SettingsError;
use crate::filter::bounds::{LIGHT_BLEED_REDUCTION, MIN_STANDARD_DEVIATION, variance};
use crate::filter::family::Family;
use crate::filter::radius::{self, radius_at};
use crate::filter::shader::ShaderNumber;
use crate::filter::stored::{MomentTexel, Stored};
use crate::filter::technique::Technique;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::moments::{Moments, Vsm};
use crate::schema::cost::Cost;
use crate::schema::key::Key;
use crate::schema::kind::Kind;
use crate::schema::values::Choice;

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "savsm",
        label: "summed-area VSM",
        help: "Mean and variance of depth over boxes of any size, from a summed-area table.",
        source: "Lauritzen 2007",
    },
    keys: &[RADIUS, RADIUS_TEXELS, MIN_STANDARD_DEVIATION, LIGHT_BLEED_REDUCTION],
};

const RADIUS: Key = Key {
    help: "Half a side of the box, the same in every split. A wider one makes softer edges for the same lookups.",
    source: "Lauritzen 2007",
    ..radius::METRES
};

const RADIUS_TEXELS: Key = Key {
    help: "Half a side of the box; where there is a radius in metres, the most that it may become. \
           A wider one makes softer edges, and maps keep so much room around what is seen.",
    source: "Lauritzen 2007",
    // The sums have as many steps as the widest box allows.
    costs: &[Cost::Plan, Cost::Shader, Cost::Maps],
    ..radius::TEXELS
};

/// Mean and variance of depth over a box.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct SummedVariance {
    /// Half a side of the box, from 0 to 1000 metres, which is the same in every split; `None`, the default, takes
    /// `radius_texels` instead.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub radius: Option<f32>,
    /// Half a side of the box, from 0 to 64 texels; where there is a radius in metres, the most that it may become. The
    /// default is 2.5.
    pub radius_texels: f32,
    /// No standard deviation of depth is taken to be smaller, from 0 to 10 metres. The default is 0.01.
    pub min_standard_deviation: f32,
    /// The share of light that is taken for leaked, from 0 to 0.99. The default is 0.2.
    pub light_bleed_reduction: f32,
}

impl Default for SummedVariance {
    fn default() -> Self {
        Self { radius: None, radius_texels: 2.5, min_standard_deviation: 0.01, light_bleed_reduction: 0.2 }
    }
}

impl SummedVariance {
    /// Half a side of the box in a view whose texels have this side in metres, texels; at least half a texel.
    pub fn radius_at(&self, texel_metres: f32) -> f32 {
        radius_at(self.radius, self.radius_texels, texel_metres)
    }

    /// The moments in a map where the smallest deviation is such a variance.
    fn of_variance(&self, min_variance: f32) -> Moments {
        Moments::Vsm(Vsm { min_variance, light_bleed_reduction: self.light_bleed_reduction })
    }
}

impl Technique for SummedVariance {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Summed
    }

    fn validate(&self) -> Result<(), SettingsError> {
        let Self { radius, radius_texels, min_standard_deviation, light_bleed_reduction } = self;
        RADIUS.check_given(*radius)?;
        RADIUS_TEXELS.check(*radius_texels)?;
        MIN_STANDARD_DEVIATION.check(*min_standard_deviation)?;
        LIGHT_BLEED_REDUCTION.check(*light_bleed_reduction)
    }

    fn reach_texels(&self) -> f32 {
        self.radius_texels.max(0.5) + 1.0
    }

    fn offset_reach_texels(&self, _texel_metres: f32) -> f32 {
        1.0
    }

    fn plane_reach_texels(&self) -> f32 {
        0.0
    }

    fn stores(&self) -> Stored {
        let texel = MomentTexel { moments: "vsm", channels: 2, exponents: [0.0; 2] };
        Stored::Summed { texel, steps: steps(self.reach_texels()) }
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        let radius = radius::numbers(self.radius, self.radius_texels);
        // Shaders know how deep a map is, and make the variance themselves.
        let moments = self.of_variance(0.0);
        radius
            .into_iter()
            .chain(numbers(steps(self.reach_texels()), &moments, self.min_standard_deviation))
            .collect()
    }

    fn visibility(&self, reader: &Reader<'_>, _query: &Query) -> f32 {
        let moments = self.of_variance(variance(self.min_standard_deviation, reader.map.depth_metres()));
        let Vec2 { x, y } = reader.place.texel_metres;
        let radius = Vec2::new(self.radius_at(x), self.radius_at(y));
        moments.visibility(over(reader, &moments, radius), reader.depth())
    }
}
