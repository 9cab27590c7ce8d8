//! By what do neighbouring receivers get different points?

use super::shader::ShaderNumber;
use crate::kernel::{interleaved_gradient_noise, world_noise};
use crate::lookup::place::Query;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::values::{Choice, Values};

/// The source of the per-receiver rotation: screen position, world position, or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum NoiseSource {
    /// Each pixel has its own: noise that stays on the screen (Jimenez 2014).
    Screen,
    /// Each millimetre of the world has its own: noise that stays on things.
    World,
    /// All receivers have the same: bands instead of noise.
    None,
}

impl NoiseSource {
    /// The noise of a receiver, from 0 to 1.
    pub(super) fn at(self, query: &Query) -> f32 {
        match self {
            Self::Screen => interleaved_gradient_noise(query.pixel),
            Self::World => world_noise(query.position),
            Self::None => 0.0,
        }
    }

    /// The number that shaders know it by.
    pub(super) fn number(self) -> ShaderNumber {
        let number = match self {
            Self::Screen => 0,
            Self::World => 1,
            Self::None => 2,
        };
        ShaderNumber::u32("UMBRAGE_NOISE", number)
    }
}

pub(super) const NOISE: Key = Key {
    name: "filter.noise",
    label: "noise",
    help: "What gives each receiver its own points, or its own rotation of them.",
    costs: &[Cost::Shader],
    values: Values::Choice(&[
        Choice {
            name: "screen",
            label: "on the screen",
            help: "The pixel: noise that stays on the screen.",
            source: "Jimenez 2014",
        },
        Choice {
            name: "world",
            label: "on things",
            help: "The millimetre of the world: noise that stays on things.",
            source: "opengl-tutorial 16",
        },
        Choice { name: "none", label: "none", help: "Nothing: bands instead of noise.", source: "" },
    ]),
    ..Key::of(Group::Filter)
};
