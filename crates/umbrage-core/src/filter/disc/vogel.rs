//! A spiral of equal areas, rotated by another angle for each receiver (Vogel 1979; Jimenez 2014).

use super::points::{CENTRED, Disc, EARLY_OUT, RADIUS, RADIUS_TEXELS};
use crate::error::SettingsError;
use crate::filter::family::Family;
use crate::filter::noise::NOISE;
use crate::filter::shader::ShaderNumber;
use crate::filter::taps::TAPS;
use crate::filter::technique::Technique;
use crate::kernel::{rotation, spiral};
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::schema::kind::Kind;
use crate::schema::values::Choice;

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "vogel",
        label: "Vogel disc",
        help: "A spiral of equal areas, of any number of points, rotated by another angle for each receiver.",
        source: "Vogel 1979; Jimenez 2014",
    },
    keys: &[TAPS, RADIUS, RADIUS_TEXELS, CENTRED, NOISE, EARLY_OUT],
};

/// A spiral of points, rotated for each receiver.
pub(in crate::filter) struct Vogel(pub Disc);

impl Technique for Vogel {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Disc
    }

    fn validate(&self) -> Result<(), SettingsError> {
        self.0.validate(&TAPS)
    }

    fn reach_texels(&self) -> f32 {
        self.0.reach_texels()
    }

    fn offset_reach_texels(&self, texel_metres: f32) -> f32 {
        self.0.offset_reach_texels(texel_metres)
    }

    fn plane_reach_texels(&self) -> f32 {
        self.reach_texels()
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        self.0.numbers(spiral(self.0.taps))
    }

    fn visibility(&self, reader: &Reader<'_>, query: &Query) -> f32 {
        let rotation = rotation(self.0.noise.at(query));
        self.0.mean(reader, &spiral(self.0.taps), |_, point| rotation.rotate(point))
    }
}
