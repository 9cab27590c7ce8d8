//! What the maps are, what they cover, and which of them serves a receiver.

use super::{Choice, Group, Key, Values};
use crate::fit::FITS;
use crate::warp::WARPS;

pub(super) const KEYS: &[Key] = &[RESOLUTION, DEPTH, STORAGE, FIT, UNCLIPPED_DEPTH, WARP, SELECT, BLEND];

const BASE: Key = Key::of(Group::Maps);

pub(crate) const RESOLUTION: Key = Key {
    name: "resolution",
    label: "resolution",
    help: "Texels a side of each view's tile. \
           Twice as many make edges half as coarse, and cost four times the memory.",
    unit: "texels",
    values: Values::Whole { least: 16, most: 16384, only: &[], slide: [256, 4096], logarithmic: true },
    wanted: "from 16 to 16384 texels",
    ..BASE
};

const DEPTH: Key = Key {
    name: "depth",
    label: "texel",
    help: "What a texel of a map is.",
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
            help: "Half of the memory, and steps of a 65535th of the map's depth.",
            source: "opengl-tutorial 16",
        },
    ]),
    ..BASE
};

const STORAGE: Key = Key {
    name: "storage",
    label: "storage",
    help: "Where the views' tiles lie. The picture is the same.",
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
    ..Key::switch(Group::Maps)
};

const WARP: Key = Key {
    name: "warp",
    label: "warp",
    help: "How a map's texels are spent on what is near the eye. Works in every split, for suns and spots.",
    values: Values::Choice(WARPS),
    ..BASE
};

const SELECT: Key = Key {
    name: "select",
    label: "select",
    help: "How a receiver finds its view.",
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

pub(crate) const BLEND: Key = Key {
    name: "blend",
    label: "blend",
    help: "What share of a slice's depth is cross-faded into the next one; the last one fades to lit. \
           By map, what share of the map's half width. Where views fade, two maps are read.",
    values: Values::number(0.0, 1.0, [0.0, 1.0]),
    wanted: "from 0 to 1",
    ..BASE
};
