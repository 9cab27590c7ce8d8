//! Points drawn at random from the table, other ones for each receiver (opengl-tutorial 16).

use glam::Vec2;

use super::points::{Disc, TABLE_KEYS, TABLE_TAPS};
use crate::error::SettingsError;
use crate::filter::family::Family;
use crate::filter::shader::ShaderNumber;
use crate::filter::technique::Technique;
use crate::kernel::{POISSON, poisson, stratified};
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::schema::kind::Kind;
use crate::schema::values::Choice;

pub(in crate::filter) const KIND: Kind = Kind {
    choice: Choice {
        name: "stratified",
        label: "stratified disc",
        help: "Points drawn at random from the table, others for each receiver: noise instead of bands.",
        source: "opengl-tutorial 16",
    },
    keys: TABLE_KEYS,
};

/// Points of the table, drawn anew for each receiver.
pub(in crate::filter) struct Stratified(pub Disc);

impl Technique for Stratified {
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
        let all: Vec<Vec2> = poisson(POISSON.len(), self.0.centred).collect();
        let noise = self.0.noise.at(query);
        self.0.mean(reader, &self.0.table(), |i, _| all[stratified(i, noise)])
    }
}
