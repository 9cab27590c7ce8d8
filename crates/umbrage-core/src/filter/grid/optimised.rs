//! A bell-shaped kernel of bilinear lookups, in as few of them as can be: Castaño 2013.

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
        name: "optimised",
        label: "optimised PCF",
        help: "A bell-shaped kernel of bilinear lookups, in as few of them as can be.",
        source: "Castaño 2013",
    },
    keys: &[SIZE],
};

const SIZE: Key = Key {
    name: "filter.size",
    label: "size",
    help: "Texels a side of the bell. A larger one makes softer edges, of 4, 9 or 16 lookups.",
    source: "Castaño 2013",
    unit: "texels a side",
    costs: &[Cost::Plan, Cost::Shader],
    values: Values::only(&[3, 5, 7]),
    ..Key::of(Group::Filter)
};

/// A bell of `size` × `size` texels.
pub(in crate::filter) struct Optimised {
    pub size: u32,
}

impl Technique for Optimised {
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
        match self.size {
            3 => kernel(reader, &[1.0, 2.0, 1.0]),
            5 => kernel(reader, &[1.0, 3.0, 4.0, 3.0, 1.0]),
            _ => kernel(reader, &[1.0, 5.0, 12.0, 16.0, 12.0, 5.0, 1.0]),
        }
    }
}
