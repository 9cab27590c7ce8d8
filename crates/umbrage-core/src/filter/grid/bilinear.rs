//! Four comparisons, weighted bilinearly: one lookup of a sampler that compares.

use super::kernel::{kernel, numbers, reach_texels};
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
        name: "bilinear",
        label: "bilinear",
        help: "Four comparisons, weighted bilinearly: one lookup of the sampler's.",
        source: "opengl-tutorial 16",
    },
    keys: &[],
};

/// Four comparisons, weighted bilinearly.
pub(in crate::filter) struct Bilinear;

impl Technique for Bilinear {
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
        reach_texels(1)
    }

    fn offset_reach_texels(&self, _texel_metres: f32) -> f32 {
        self.reach_texels()
    }

    fn plane_reach_texels(&self) -> f32 {
        self.reach_texels()
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        numbers(1)
    }

    fn visibility(&self, reader: &Reader<'_>, _query: &Query) -> f32 {
        kernel(reader, &[1.0])
    }
}
