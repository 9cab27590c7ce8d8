//! What keeps surfaces from shadowing themselves: `docs/decisions/0015-biases.md`.

use super::{Choice, Group, Key, Values};

pub(super) const KEYS: &[Key] = &[
    RECEIVER_PLANE,
    CONSTANT,
    SLOPE,
    SLOPE_LIMIT,
    NORMAL,
    RASTER_CONSTANT,
    RASTER_SLOPE,
    CASTERS,
    DEPTH_LAYER,
    DEPTH_LAYER_LIMIT,
    TERMINATOR,
];

const BASE: Key = Key::of(Group::Bias);

const RECEIVER_PLANE: Key = Key {
    name: "bias.receiver_plane",
    label: "receiver's plane",
    help: "Each texel is compared with the depth that the receiver's own plane has there. \
           A flat receiver then needs next to no other bias.",
    source: "Dou et al. 2014",
    ..Key::switch(Group::Bias)
};

pub(crate) const CONSTANT: Key = Key {
    name: "bias.constant",
    label: "constant",
    help: "How far a lookup moves toward the light, whatever the slope. \
           More of it detaches shadows from what casts them.",
    source: "opengl-tutorial 16; with the receiver's plane, Dou et al. 2014",
    unit: "metres",
    values: Values::number(0.0, 1e3, [0.0, 0.2]),
    wanted: "from 0 to 1000 metres",
    ..BASE
};

pub(crate) const SLOPE: Key = Key {
    name: "bias.slope",
    label: "slope",
    help: "How far a lookup moves toward the light, times the tangent of the angle between normal and light. \
           More of it detaches shadows on slopes.",
    source: "opengl-tutorial 16",
    unit: "texels",
    values: Values::number(0.0, 100.0, [0.0, 10.0]),
    wanted: "from 0 to 100",
    ..BASE
};

pub(crate) const SLOPE_LIMIT: Key = Key {
    name: "bias.slope_limit",
    label: "steepest slope",
    help: "The largest tangent that `bias.slope` is multiplied with. \
           Less of it leaves acne on steep walls, more of it detaches their shadows.",
    source: "opengl-tutorial 16, where it is 2",
    values: Values::number(0.0, 1e4, [0.0, 40.0]),
    wanted: "from 0 to 10000",
    ..BASE
};

pub(crate) const NORMAL: Key = Key {
    name: "bias.normal",
    label: "along the normal",
    help: "How far a lookup moves along the receiver's normal. Without the receiver's plane, 1 is the least that \
           is exact for the filter's kernel on a flat receiver. More of it makes all shadows smaller.",
    source: "Holbert 2011",
    values: Values::number(0.0, 100.0, [0.0, 4.0]),
    wanted: "from 0 to 100",
    ..BASE
};

pub(crate) const RASTER_CONSTANT: Key = Key {
    name: "bias.raster_constant",
    label: "raster constant",
    help: "How many least steps of the map's format casters are drawn deeper. \
           More of it detaches shadows.",
    source: "glPolygonOffset, units; Ferko 2010",
    unit: "depth steps",
    values: Values::Whole {
        least: -1_000_000_000,
        most: 1_000_000_000,
        only: &[],
        slide: [-16, 16],
        logarithmic: false,
    },
    wanted: "within ±1000000000 depth steps",
    ..BASE
};

pub(crate) const RASTER_SLOPE: Key = Key {
    name: "bias.raster_slope",
    label: "raster slope",
    help: "How much deeper casters are drawn, in their own depth slopes a texel. \
           More of it detaches shadows on slopes.",
    source: "glPolygonOffset, factor; Ferko 2010",
    values: Values::number(-100.0, 100.0, [-8.0, 8.0]),
    wanted: "from -100 to 100",
    ..BASE
};

const CASTERS: Key = Key {
    name: "bias.casters",
    label: "faces",
    help: "Which faces of casters are drawn into the maps.",
    source: "opengl-tutorial 16",
    values: Values::Choice(&[
        Choice { name: "both", label: "both", help: "All of them.", source: "" },
        Choice { name: "front", label: "front", help: "Those turned to the light.", source: "" },
        Choice {
            name: "back",
            label: "back",
            help: "Those turned away. Closed things need no other bias; open ones shadow themselves.",
            source: "opengl-tutorial 16",
        },
    ]),
    ..BASE
};

const DEPTH_LAYER: Key = Key {
    name: "bias.depth_layer",
    label: "layer",
    help: "What is stored of the surfaces that a ray of light meets. All but the first draw casters twice.",
    values: Values::Choice(&[
        Choice { name: "first", label: "first", help: "The first surface.", source: "" },
        Choice {
            name: "second",
            label: "second",
            help: "The second surface. Wants closed casters.",
            source: "Wang & Molnar 1994",
        },
        Choice { name: "midpoint", label: "midpoint", help: "Half-way between the two.", source: "Woo 1992" },
        Choice {
            name: "dual",
            label: "dual",
            help: "Half-way between the two, but no farther behind the first than a limit.",
            source: "Weiskopf & Ertl 2003",
        },
    ]),
    ..BASE
};

pub(crate) const DEPTH_LAYER_LIMIT: Key = Key {
    name: "bias.depth_layer_limit",
    label: "layer's limit",
    help: "The most that a dual layer is stored behind the first surface; for the others, how far behind it where \
           there is no second. More of it lets light in under what is thin.",
    source: "Weiskopf & Ertl 2003",
    unit: "metres",
    values: Values::number(0.0, 1e3, [0.0, 1.0]),
    wanted: "from 0 to 1000 metres",
    ..BASE
};

pub(crate) const TERMINATOR: Key = Key {
    name: "bias.terminator",
    label: "terminator",
    help: "The cosine of the angle between normal and light up to which light fades in. It hides the facets of \
           smooth things where they turn away from the light, and darkens what is lit from the side.",
    values: Values::number(0.0, 1.0, [0.0, 1.0]),
    wanted: "from 0 to 1",
    ..BASE
};
