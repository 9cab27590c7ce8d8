//! What are the maps, what do they cover, and which of them serves a receiver?

use super::transparent::TRANSPARENT_CASTERS;
use crate::fit::FITS;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::values::{Choice, Values};
use crate::warp::WARPS;

/// The format of a texel of a shadow map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum DepthFormat {
    /// A 32-bit float.
    F32,
    /// A 16-bit unsigned number, normalised.
    U16,
}

impl DepthFormat {
    /// The size of a texel, bytes.
    pub fn bytes(self) -> u64 {
        match self {
            Self::F32 => 4,
            Self::U16 => 2,
        }
    }

    /// Returns how much a stored depth may differ from the one that was drawn, of a range from 0 to 1, however small it is. Lookups
    /// stand off by it, and by [`Self::rounding`].
    pub fn step(self) -> f32 {
        match self {
            Self::F32 => 0.0,
            Self::U16 => 1.0 / 65535.0,
        }
    }

    /// Returns how much it may differ as a share of itself, or of the terms that it is the sum of: some roundings of an f32, in the
    /// vertex shader, between the corners of a triangle, and in the lookup.
    pub fn rounding(self) -> f32 {
        4.0 * f32::EPSILON
    }
}

/// Where the views' tiles lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Storage {
    /// Each tile in a layer of its own.
    Array,
    /// All tiles side by side in one layer.
    Atlas,
}

/// How a receiver finds its view.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Select {
    /// The view is the one whose slice holds the view depth of the receiver.
    Depth,
    /// The same, by the camera's clip depth (Zhang et al. 2006, eq. 8, corrected).
    ClipDepth,
    /// The finest view whose map holds the whole filter footprint.
    Map,
}

pub(crate) const KEYS: &[Key] = &[
    RESOLUTION,
    RESOLUTION_FALLOFF,
    DEPTH,
    STORAGE,
    FIT,
    UNCLIPPED_DEPTH,
    TRANSPARENT_CASTERS,
    CASTER_ERROR,
    WARP,
    SELECT,
    BLEND,
];

const BASE: Key = Key { costs: &[Cost::Plan], ..Key::of(Group::Maps) };

pub(super) const RESOLUTION: Key = Key {
    name: "resolution",
    label: "resolution",
    help: "Texels a side of each view's tile. \
           Twice as many make edges half as coarse, and cost four times the memory.",
    unit: "texels",
    costs: &[Cost::Plan, Cost::Maps],
    values: Values::Whole {
        min: LEAST_TILE as i64,
        max: LARGEST_TILE as i64,
        only: &[],
        slide: [256, 4096],
        logarithmic: true,
    },
    ..BASE
};

/// The least side of a tile, and the largest, texels.
pub(crate) const LEAST_TILE: u32 = 16;
pub(crate) const LARGEST_TILE: u32 = 16384;

pub(super) const RESOLUTION_FALLOFF: Key = Key {
    name: "resolution_falloff",
    label: "falloff",
    help: "How many texels a side each split has of those of the split before. \
           Less makes what is far coarser, and saves memory where `storage` is `atlas`.",
    source: "Tadamura et al. 2001",
    unit: "times",
    costs: &[Cost::Plan, Cost::Maps],
    values: Values::ratio(0.25, 2.0, [0.25, 2.0]),
    ..BASE
};

const DEPTH: Key = Key {
    name: "depth",
    label: "texel",
    help: "What a texel of a map is.",
    costs: &[Cost::Plan, Cost::Frame, Cost::Casters, Cost::Maps],
    values: Values::Choice(&[
        Choice {
            name: "f32",
            label: "32-bit float",
            help: "Four bytes, and hardly any rounding.",
            source: "",
        },
        Choice {
            name: "u16",
            label: "16-bit unsigned",
            help: "Half of the memory, and steps of a 65535th of the map's depth: fine where casters are flattened. Soft filters \
                   keep all of the world's depth, and want floats where that is kilometres.",
            source: "opengl-tutorial 16",
        },
    ]),
    ..BASE
};

const STORAGE: Key = Key {
    name: "storage",
    label: "storage",
    help: "Where the views' tiles lie. The picture is the same.",
    costs: &[Cost::Plan, Cost::Maps],
    values: Values::Choice(&[
        Choice { name: "array", label: "array", help: "Each tile in a layer of its own.", source: "" },
        Choice {
            name: "atlas",
            label: "atlas",
            help: "All tiles side by side in one layer.",
            source: "Ferko 2010, §3.4",
        },
    ]),
    ..BASE
};

const FIT: Key = Key {
    name: "fit",
    label: "fit",
    help: "What a view's box is fitted to. A tighter box has finer texels.",
    source: "Ferko 2010, §3.2",
    values: Values::Choice(FITS),
    ..BASE
};

const UNCLIPPED_DEPTH: Key = Key {
    name: "unclipped_depth",
    label: "flatten casters",
    help: "Casters between the light and a view's box are flattened onto its near plane. \
           Without it the near plane is moved toward the light, and depth is coarser.",
    costs: &[Cost::Plan, Cost::Casters],
    ..BASE
};

const WARP: Key = Key {
    name: "warp",
    label: "warp",
    help: "How a map's texels are spent on what is near the eye. Works in every split, for suns and spots.",
    costs: &[Cost::Plan, Cost::Shader],
    values: Values::Choice(WARPS),
    ..BASE
};

const SELECT: Key = Key {
    name: "select",
    label: "select",
    help: "How a receiver finds its view.",
    costs: &[Cost::Plan, Cost::Shader],
    values: Values::Choice(&[
        Choice {
            name: "depth",
            label: "view depth",
            help: "By view depth.",
            source: "Zhang et al. 2006, §3.6",
        },
        Choice {
            name: "clip_depth",
            label: "clip depth",
            help: "By the camera's clip depth. The picture is that of view depth.",
            source: "Zhang et al. 2006, eq. 8, corrected",
        },
        Choice {
            name: "map",
            label: "map",
            help: "The finest view whose map holds the whole filter. \
                   Less error than by depth, for some more tests a pixel.",
            source: "",
        },
    ]),
    ..BASE
};

pub(super) const CASTER_ERROR: Key = Key {
    name: "caster_error",
    label: "caster error",
    help: "How far a caster's level of detail may lie from the caster, in texels of the view that draws it. \
           More is faster, and moves edges; 0 draws every caster as it is.",
    unit: "texels",
    values: Values::number(0.0, 1.0, [0.0, 1.0]),
    ..BASE
};

pub(super) const BLEND: Key = Key {
    name: "blend",
    label: "blend",
    help: "What share of a slice's depth is cross-faded into the next one; the last one fades to lit. \
           By map, what share of the map's half width. Where views fade, two maps are read.",
    costs: &[Cost::Plan, Cost::Frame, Cost::Shader],
    values: Values::number(0.0, 1.0, [0.0, 1.0]),
    ..BASE
};
