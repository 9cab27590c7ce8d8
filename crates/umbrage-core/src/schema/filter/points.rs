//! Comparisons at points: how many, how far around, and by what places differ.

use super::BASE;
use crate::schema::{Absent, Choice, Group, Key, Values};

pub(crate) const KEYS: &[Key] = &[
    TABLE_TAPS,
    TAPS,
    RADIUS,
    RADIUS_TEXELS,
    BOX_RADIUS,
    BOX_RADIUS_TEXELS,
    CENTRED,
    NOISE,
    EARLY_OUT,
    FOOTPRINT_MAX_TEXELS,
];

/// The filters with points on a disc.
const DISCS: &[&str] = &["poisson", "stratified", "rotated", "vogel"];

pub(crate) const TABLE_TAPS: Key = Key {
    name: "filter.taps",
    label: "points",
    help: "How many points of the table are compared. More of them leave fewer bands or less noise, \
           and cost a lookup each.",
    source: "opengl-tutorial 16",
    unit: "points",
    kinds: &["poisson", "stratified", "rotated"],
    values: Values::whole(1, 16),
    wanted: "from 1 to 16 points, which the table has",
    ..BASE
};

pub(crate) const TAPS: Key = Key {
    name: "filter.taps",
    label: "points",
    help: "How many points are compared. More of them leave less noise, and cost a lookup each.",
    unit: "points",
    kinds: &["vogel", "footprint", "pcss"],
    values: Values::whole(1, 64),
    wanted: "from 1 to 64 points",
    ..BASE
};

pub(crate) const RADIUS: Key = Key {
    name: "filter.radius",
    label: "radius",
    help: "Of the disc, the same in every split. A wider one makes softer edges and more noise.",
    unit: "metres",
    kinds: DISCS,
    values: Values::number(0.0, 1e3, [0.0, 1.0]),
    wanted: "from 0 to 1000 metres",
    absent: Some(Absent { means: "the radius in texels", start: "0.1" }),
    ..BASE
};

pub(crate) const RADIUS_TEXELS: Key = Key {
    name: "filter.radius_texels",
    label: "radius in texels",
    help: "Of the disc; where there is a radius in metres, the most that it may become. \
           A wider one makes softer edges and more noise, and maps keep so much room around what is seen.",
    unit: "texels",
    kinds: DISCS,
    values: Values::number(0.0, 64.0, [0.0, 16.0]),
    wanted: "from 0 to 64 texels",
    ..BASE
};

pub(crate) const BOX_RADIUS: Key = Key {
    help: "Half a side of the box, the same in every split. A wider one makes softer edges for the same lookups.",
    source: "Lauritzen 2007",
    kinds: &["savsm"],
    ..RADIUS
};

pub(crate) const BOX_RADIUS_TEXELS: Key = Key {
    help: "Half a side of the box; where there is a radius in metres, the most that it may become. \
           A wider one makes softer edges, and maps keep so much room around what is seen.",
    source: "Lauritzen 2007",
    kinds: &["savsm"],
    ..RADIUS_TEXELS
};

const CENTRED: Key = Key {
    name: "filter.centred",
    label: "centred",
    help: "The table's points are moved so that their middle is the receiver. \
           The tutorial's are not: four of them look half a radius aside.",
    source: "opengl-tutorial 16, corrected",
    kinds: DISCS,
    ..Key::switch(Group::Filter)
};

const NOISE: Key = Key {
    name: "filter.noise",
    label: "noise",
    help: "By what places are told apart, where each has other points or another angle.",
    kinds: &["poisson", "stratified", "rotated", "vogel", "pcss"],
    values: Values::Choice(&[
        Choice {
            name: "screen",
            label: "on the screen",
            help: "By pixel: noise that stays on the screen.",
            source: "Jimenez 2014",
        },
        Choice {
            name: "world",
            label: "on things",
            help: "By millimetre of the world: noise that stays on things.",
            source: "opengl-tutorial 16",
        },
        Choice { name: "none", label: "none", help: "Not at all: bands instead of noise.", source: "" },
    ]),
    ..BASE
};

const EARLY_OUT: Key = Key {
    name: "filter.early_out",
    label: "early_out",
    help: "Four points on the rim are asked first, and the others only where those disagree. \
           It saves lookups, and misses what is narrower than a quarter of the disc.",
    source: "opengl-tutorial 16",
    kinds: DISCS,
    ..Key::switch(Group::Filter)
};

pub(crate) const FOOTPRINT_MAX_TEXELS: Key = Key {
    name: "filter.max_texels",
    label: "reach",
    help: "The most that a pixel may reach from its middle. \
           Maps keep so much room around what is seen, so more of it makes texels coarser.",
    unit: "texels",
    kinds: &["footprint"],
    values: Values::number(1.0, 64.0, [1.0, 32.0]),
    wanted: "from 1 to 64 texels",
    ..BASE
};
