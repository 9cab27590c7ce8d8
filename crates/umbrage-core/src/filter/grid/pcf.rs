//! The mean of a square of bilinear lookups: percentage-closer filtering, Reeves, Salesin & Cook 1987.

use super::kernel::{kernel, numbers, reach_texels};
use crate::error::SettingsError;
use crate::filter::family::Family;
use crate::filter::shader::ShaderNumber;
use crate::filter::technique::Technique;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::kind::Kind;
use crate::schema::values::{Choice, Values};

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "pcf",
        label: "PCF",
        help: "The mean of a square of bilinear lookups, one texel apart.",
        source: "Reeves, Salesin & Cook 1987",
    },
    keys: &[SIZE],
};

const SIZE: Key = Key {
    name: "filter.size",
    label: "size",
    help: "Lookups a side, one texel apart. More of them make softer edges, and cost their square.",
    source: "Reeves, Salesin & Cook 1987",
    unit: "lookups a side",
    costs: &[Cost::Plan, Cost::Shader],
    values: Values::only(&[1, 3, 5, 7, 9]),
    ..Key::of(Group::Filter)
};

/// The mean of `size` × `size` bilinear lookups.
pub(in crate::filter) struct Pcf {
    pub size: u32,
}

impl Technique for Pcf {
    fn kind(&self) -> &'static Kind {
        &KIND
    }

    fn family(&self) -> Family {
        Family::Grid
    }

    fn validate(&self) -> Result<(), SettingsError> {
        SIZE.check(self.size)
    }

    fn reach_texels(&self) -> f32 {
        reach_texels(self.size)
    }

    fn offset_reach_texels(&self, _texel_metres: f32) -> f32 {
        self.reach_texels()
    }

    fn plane_reach_texels(&self) -> f32 {
        self.reach_texels()
    }

    fn numbers(&self) -> Vec<ShaderNumber> {
        numbers(self.size)
    }

    fn visibility(&self, reader: &Reader<'_>, _query: &Query) -> f32 {
        kernel(reader, &vec![1.0; self.size as usize])
    }
}
