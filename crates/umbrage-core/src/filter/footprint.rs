//! Comparisons all over what a pixel covers of the map: a parallelogram, and a texel around it.

use glam::{Vec2, Vec4Swizzles as _};

use super::family::Family;
use super::shader::ShaderNumber;
use super::taps::TAPS;
use super::technique::Technique;
use crate::error::SettingsError;
use crate::kernel::two_squares;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::kind::Kind;
use crate::schema::values::{Choice, Values};

pub(super) const KIND: Kind = Kind {
    choice: Choice {
        name: "footprint",
        label: "footprint",
        help: "Comparisons all over what the pixel covers of the map. \
               The least error against the mean over a pixel, at the cost of PCF 5 × 5.",
        source: "",
    },
    keys: &[TAPS, MAX_TEXELS],
};

const MAX_TEXELS: Key = Key {
    name: "filter.max_texels",
    label: "reach",
    help: "The most that a pixel may reach from its middle. \
           Maps keep so much room around what is seen, so more of it makes texels coarser.",
    unit: "texels",
    costs: &[Cost::Plan, Cost::Shader],
    values: Values::number(1.0, 64.0, [1.0, 32.0]),
    ..Key::of(Group::Filter)
};

/// Comparisons all over what the pixel covers of the map: a parallelogram, and a texel around it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Footprint {
    /// The number of points that are compared, from 1 to 64 points. The default is 32.
    pub taps: u32,
    /// The most that a pixel may reach from its middle, from 1 to 64 texels. Maps have so much room around what is seen.
    /// The default is 8.
    pub max_texels: f32,
}

impl Default for Footprint {
    fn default() -> Self {
        Self { taps: 32, max_texels: 8.0 } // as many comparisons as PCF 5 × 5; texels are about as large as pixels
    }
}

impl Technique for Footprint {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Footprint
    }

    fn validate(&self) -> Result<(), SettingsError> {
        let Self { taps, max_texels } = self;
        TAPS.check(*taps)?;
        MAX_TEXELS.check(*max_texels)
    }

    fn reach_texels(&self) -> f32 {
        self.max_texels + 1.0
    }

    fn offset_reach_texels(&self, _texel_metres: f32) -> f32 {
        1.0
    }

    // A footprint reaches farther where pixels are much larger than texels, but planes that steep are then seen edge on.
    fn plane_reach_texels(&self) -> f32 {
        1.0
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        vec![
            ShaderNumber::f32("UMBRAGE_OFFSET_REACH", 1.0),
            ShaderNumber::vec4s("UMBRAGE_POINTS", (0..self.taps as usize).map(two_squares).collect()),
            ShaderNumber::u32("UMBRAGE_TAPS", self.taps),
            ShaderNumber::f32("UMBRAGE_MAX_TEXELS", self.max_texels),
        ]
    }

    fn visibility(&self, reader: &Reader<'_>, query: &Query) -> f32 {
        let footprint = reader.map.footprint(query);
        let max = Vec2::splat(self.max_texels);
        let tap = |i: u32| {
            let point = two_squares(i as usize);
            reader.tap((footprint * point.xy() + point.zw()).clamp(-max, max))
        };
        (0..self.taps).map(tap).sum::<f32>() / self.taps as f32
    }
}
