//! One comparison with the nearest texel: Williams 1978.

use crate::error::SettingsError;
use crate::filter::family::Family;
use crate::filter::shader::ShaderNumber;
use crate::filter::technique::Technique;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::schema::kind::Kind;
use crate::schema::values::Choice;

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "hard",
        label: "hard",
        help: "One comparison with the nearest texel: the least work, and edges of steps.",
        source: "Williams 1978",
    },
    keys: &[],
};

/// One comparison with the nearest texel.
pub(in crate::filter) struct Hard;

impl Technique for Hard {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Grid
    }

    fn validate(&self) -> Result<(), SettingsError> {
        Ok(())
    }

    fn reach_texels(&self) -> f32 {
        0.5
    }

    fn offset_reach_texels(&self, _texel_metres: f32) -> f32 {
        self.reach_texels()
    }

    fn plane_reach_texels(&self) -> f32 {
        self.reach_texels()
    }

    fn is_bilinear(&self) -> bool {
        false
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        vec![ShaderNumber::f32("UMBRAGE_OFFSET_REACH", self.reach_texels())]
    }

    fn visibility(&self, reader: &Reader<'_>, _query: &Query) -> f32 {
        reader.lit(reader.place.texel.floor())
    }
}
