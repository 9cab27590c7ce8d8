//! Percentage-closer soft shadows: a search for blockers, then a disc as wide as their penumbra (Fernando 2005).

use glam::Vec2;

use super::family::Family;
use super::light_size::{LightSize, PUNCTUAL_METRES, SUN_DEGREES};
use super::noise::{NOISE, NoiseSource};
use super::shader::ShaderNumber;
use super::taps::TAPS;
use super::technique::Technique;
use crate::error::SettingsError;
use crate::kernel::{rotation, spiral};
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::kind::Kind;
use crate::schema::values::{Choice, Values};

pub(super) const KIND: Kind = Kind {
    choice: Choice {
        name: "pcss",
        label: "PCSS",
        help: "Percentage-closer soft shadows: a disc as wide as the penumbra. It searches for blockers first.",
        source: "Fernando 2005",
    },
    keys: &[TAPS, NOISE, SUN_DEGREES, PUNCTUAL_METRES, BLOCKERS, MAX_TEXELS],
};

const BLOCKERS: Key = Key {
    name: "filter.blockers",
    label: "search",
    help: "How many points are searched for blockers. \
           With fewer of them thin casters are missed and penumbrae are noisy; each costs a lookup.",
    source: "Fernando 2005",
    unit: "points",
    costs: &[Cost::Shader],
    values: Values::whole(1, 64),
    ..Key::of(Group::Filter)
};

const MAX_TEXELS: Key = Key {
    name: "filter.max_texels",
    label: "reach",
    help: "The most that a penumbra's radius may be; a wider one is cut. \
           Maps keep so much room around what is seen, so more of it makes texels coarser.",
    unit: "texels",
    costs: &[Cost::Plan, Cost::Shader],
    values: Values::number(1.0, 256.0, [1.0, 128.0]),
    ..Key::of(Group::Filter)
};

/// A disc as wide as the penumbra.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Pcss {
    /// The size of lights that have none of their own.
    pub light: LightSize,
    /// The number of points that are searched for blockers, from 1 to 64 points. The default is 16.
    pub blockers: u32,
    /// The number of points that are compared, from 1 to 64 points. The default is 32.
    pub taps: u32,
    /// The most that a penumbra's radius may be, from 1 to 256 texels; a wider one is cut. Maps have so much room around
    /// what is seen. The default is 32.
    pub max_texels: f32,
    /// What gives each receiver its own rotation of the points. The default is the screen.
    pub noise: NoiseSource,
}

impl Default for Pcss {
    fn default() -> Self {
        Self {
            light: LightSize::default(),
            blockers: 16,
            taps: 32,         // steps of 1/32
            max_texels: 32.0, // 6 % of a map of 1024
            noise: NoiseSource::Screen,
        }
    }
}

impl Technique for Pcss {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Pcss
    }

    fn validate(&self) -> Result<(), SettingsError> {
        let Self { light, blockers, taps, max_texels, noise: _ } = self;
        light.validate()?;
        BLOCKERS.check(*blockers)?;
        TAPS.check(*taps)?;
        MAX_TEXELS.check(*max_texels)
    }

    fn reach_texels(&self) -> f32 {
        self.max_texels + 1.0
    }

    fn offset_reach_texels(&self, _texel_metres: f32) -> f32 {
        1.0
    }

    fn plane_reach_texels(&self) -> f32 {
        self.reach_texels()
    }

    fn light_size(&self) -> Option<LightSize> {
        Some(self.light)
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        vec![
            ShaderNumber::f32("UMBRAGE_OFFSET_REACH", 1.0),
            ShaderNumber::vec2s("UMBRAGE_POINTS", spiral(self.taps)),
            ShaderNumber::vec2s("UMBRAGE_SEARCH", spiral(self.blockers)),
            ShaderNumber::u32("UMBRAGE_TAPS", self.taps),
            ShaderNumber::u32("UMBRAGE_BLOCKERS", self.blockers),
            ShaderNumber::f32("UMBRAGE_MAX_TEXELS", self.max_texels),
            self.noise.number(),
        ]
    }

    fn visibility(&self, reader: &Reader<'_>, query: &Query) -> f32 {
        let rotation = rotation(self.noise.at(query));
        let search = reader.penumbra(self.light, self.max_texels, 0.0);
        let blockers: Vec<f32> = spiral(self.blockers)
            .iter()
            .map(|point| reader.corner_inside(reader.place.texel + rotation.rotate(*point) * search))
            .filter(|corner| reader.lit(*corner) == 0.0)
            .map(|corner| reader.linear_depth(corner))
            .collect();
        if blockers.is_empty() {
            return 1.0;
        }
        let mean = blockers.iter().sum::<f32>() / blockers.len() as f32;
        let radius: Vec2 = reader.penumbra(self.light, self.max_texels, mean);
        let taps = spiral(self.taps).into_iter().map(|point| reader.tap(rotation.rotate(point) * radius));
        taps.sum::<f32>() / self.taps as f32
    }
}
