//! The table of points, rotated by another angle for each receiver (opengl-tutorial 16; Jimenez 2014).

use super::points::{Disc, TABLE_KEYS, TABLE_TAPS};
use crate::error::SettingsError;
use crate::filter::family::Family;
use crate::filter::shader::ShaderNumber;
use crate::filter::technique::Technique;
use crate::kernel::rotation;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::schema::kind::Kind;
use crate::schema::values::Choice;

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "rotated",
        label: "rotated disc",
        help: "The table, rotated by another angle for each receiver: finer noise.",
        source: "opengl-tutorial 16; Jimenez 2014",
    },
    keys: TABLE_KEYS,
};

/// The table's points, rotated for each receiver.
pub(in crate::filter) struct Rotated(pub Disc);

impl Technique for Rotated {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Disc
    }

    fn validate(&self) -> Result<(), SettingsError> {
        self.0.validate(&TABLE_TAPS)
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
        self.0.numbers(self.0.table())
    }

    fn visibility(&self, reader: &Reader<'_>, query: &Query) -> f32 {
        let rotation = rotation(self.0.noise.at(query));
        self.0.mean(reader, &self.0.table(), |_, point| rotation.rotate(point))
    }
}
