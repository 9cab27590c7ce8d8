//! Comparisons at points of a disc around the receiver (opengl-tutorial 16).

use glam::Vec2;

use crate::error::SettingsError;
use crate::filter::noise::{NOISE, NoiseSource};
use crate::filter::radius::{self, radius_at};
use crate::filter::shader::ShaderNumber;
use crate::kernel::{POISSON, poisson};
use crate::lookup::reader::Reader;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::values::Values;

/// Points on a disc around the receiver that are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Disc {
    /// The number of points: from 1 to 16 points where they come from the table, from 1 to 64 points for `vogel`. The
    /// default is 16.
    pub taps: u32,
    /// The radius of the disc, from 0 to 1000 metres, which is the same in every split; `None`, the default, takes
    /// `radius_texels` instead.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub radius: Option<f32>,
    /// The radius of the disc, from 0 to 64 texels; where there is one in metres, the most that it may become. The default
    /// is 2.5.
    pub radius_texels: f32,
    /// Whether the table's points are moved so that their middle is the receiver. The tutorial's are not: four of them
    /// look half a radius aside. The default is true.
    pub centred: bool,
    /// What gives each receiver its own points, or its own rotation of them; `poisson` has the same everywhere. The
    /// default is the screen.
    pub noise: NoiseSource,
    /// Whether four points on the rim are compared first, and the others only where those disagree. The default is false.
    pub early_out: bool,
}

impl Default for Disc {
    fn default() -> Self {
        Self {
            taps: 16, // the whole table
            radius: None,
            radius_texels: 2.5, // as wide as PCF 5 × 5
            centred: true,
            noise: NoiseSource::Screen,
            early_out: false, // it misses what is narrower than a quarter of the disc
        }
    }
}

impl Disc {
    /// The radius in a view whose texels have this side in metres, texels; at least half a texel.
    pub fn radius_at(&self, texel_metres: f32) -> f32 {
        radius_at(self.radius, self.radius_texels, texel_metres)
    }

    /// The disc's points of the tutorial's table, in radii.
    pub fn table(&self) -> Vec<Vec2> {
        poisson(self.taps as usize, self.centred).collect()
    }

    /// Returns how far the farthest point lies from the receiver, in radii: the tutorial's own table leaves its disc.
    pub fn farthest(&self) -> f32 {
        if self.centred { 1.0 } else { 1.25 }
    }

    pub(super) fn reach_texels(&self) -> f32 {
        self.radius_texels.max(0.5) * self.farthest() + 1.0
    }

    pub(super) fn offset_reach_texels(&self, texel_metres: f32) -> f32 {
        self.radius_at(texel_metres) * self.farthest() + 1.0
    }

    pub(super) fn validate(&self, taps_key: &Key) -> Result<(), SettingsError> {
        let Self { taps, radius, radius_texels, centred: _, noise: _, early_out: _ } = self;
        taps_key.check(*taps)?;
        RADIUS.check_given(*radius)?;
        RADIUS_TEXELS.check(*radius_texels)
    }

    pub(super) fn numbers(&self, points: Vec<Vec2>) -> Vec<ShaderNumber> {
        let whole = Self { taps: POISSON.len() as u32, ..*self };
        let taps = points.len() as u32;
        let own = [
            ShaderNumber::vec2s("UMBRAGE_POINTS", points),
            ShaderNumber::vec2s("UMBRAGE_TABLE", whole.table()),
            ShaderNumber::u32("UMBRAGE_TAPS", taps),
            ShaderNumber::bool("UMBRAGE_EARLY_OUT", self.early_out),
            ShaderNumber::f32("UMBRAGE_FARTHEST", self.farthest()),
            self.noise.number(),
        ];
        own.into_iter().chain(radius::numbers(self.radius, self.radius_texels)).collect()
    }

    /// The mean of comparisons at points; `place` says where one of them lies for this receiver, in radii.
    pub(super) fn mean(
        &self,
        reader: &Reader<'_>,
        points: &[Vec2],
        place: impl Fn(u32, Vec2) -> Vec2,
    ) -> f32 {
        let Vec2 { x, y } = reader.place.texel_metres;
        let radius = Vec2::new(self.radius_at(x), self.radius_at(y));
        let rim = CORNERS.map(|corner| reader.tap(corner * radius)).iter().sum::<f32>() / 4.0;
        if self.early_out && (rim == 0.0 || rim == 1.0) {
            return rim;
        }
        let taps = (0..).zip(points).map(|(i, point)| reader.tap(place(i, *point) * radius));
        taps.sum::<f32>() / points.len() as f32
    }
}

/// Four points on the rim of the unit disc.
const CORNERS: [Vec2; 4] = {
    let half = std::f32::consts::FRAC_1_SQRT_2;
    [Vec2::new(half, half), Vec2::new(-half, half), Vec2::new(-half, -half), Vec2::new(half, -half)]
};

/// The points of discs that take them from the table.
pub(super) const TABLE_TAPS: Key = Key {
    name: "filter.taps",
    label: "points",
    help: "How many points of the table are compared. More of them leave fewer bands or less noise, \
           and cost a lookup each.",
    source: "opengl-tutorial 16",
    unit: "points",
    costs: &[Cost::Shader],
    values: Values::whole(1, POISSON.len() as i64),
    note: "which the table has",
    ..Key::of(Group::Filter)
};

pub(super) const RADIUS: Key = Key {
    help: "The radius of the disc, the same in every split. A wider one makes softer edges and more noise.",
    // With a radius of nothing, the offset along the normal need not reach as far.
    costs: &[Cost::Plan, Cost::Shader],
    ..radius::METRES
};

pub(super) const RADIUS_TEXELS: Key = Key {
    help: "The radius of the disc; where there is one in metres, the most that it may become. \
           A wider one makes softer edges and more noise, and maps keep so much room around what is seen.",
    ..radius::TEXELS
};

pub(super) const CENTRED: Key = Key {
    name: "filter.centred",
    label: "centred",
    help: "The table's points are moved so that their middle is the receiver. \
           The tutorial's are not: four of them look half a radius aside.",
    source: "opengl-tutorial 16, corrected",
    costs: &[Cost::Plan, Cost::Shader],
    ..Key::of(Group::Filter)
};

pub(super) const EARLY_OUT: Key = Key {
    name: "filter.early_out",
    label: "early out",
    help: "Four points on the rim are compared first, and the others only where those disagree. \
           It saves lookups, and misses what is narrower than a quarter of the disc.",
    source: "opengl-tutorial 16",
    costs: &[Cost::Shader],
    ..Key::of(Group::Filter)
};

/// The rows of discs that take their points from the table.
pub(super) const TABLE_KEYS: &[Key] = &[TABLE_TAPS, RADIUS, RADIUS_TEXELS, CENTRED, NOISE, EARLY_OUT];
