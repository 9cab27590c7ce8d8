//! What keeps surfaces from shadowing themselves? Which faces are drawn, what is stored of them, and how far a lookup
//! stands off. Ten ways and what each costs: `docs/decisions/0015-biases.md`.

use crate::error::SettingsError;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::values::{Choice, Values};

/// What keeps surfaces from shadowing themselves. Zero everywhere is no bias: [`Bias::NONE`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Bias {
    /// How many of the smallest steps of the map's format casters are drawn deeper (`glPolygonOffset` units), from
    /// -1000000000 to 1000000000 depth steps. The default is 0.
    pub raster_constant: i32,
    /// How much deeper casters are drawn, in their own depth slopes a texel (`glPolygonOffset` factor), from -100 to 100.
    /// The default is 0.
    pub raster_slope: f32,
    /// A lookup moves so far toward the light, from 0 to 1000 metres. The default is 0.
    pub constant: f32,
    /// How far a lookup moves toward the light, from 0 to 100 texels of the view, times the tangent of the angle between
    /// normal and light. The default is 0.
    pub slope: f32,
    /// The largest tangent that counts for `slope` and `bend`, from 0 to 10000; it is 2 in opengl-tutorial 16
    /// (0.01 / 0.005). The default is 8.
    pub slope_limit: f32,
    /// A receiver's surface is taken to bend so far from its plane, toward the light, for each texel that a comparison
    /// lies beside the receiver; from 0 to 100 texels of the view, over the cosine of the angle between normal and light.
    /// A comparison with the receiver's own texel counts as 0.7 texels away. The default is 0.5.
    pub bend: f32,
    /// How far a lookup moves along the receiver's normal, in reaches of the filter, from 0 to 100. Without
    /// `receiver_plane`, 1 is the smallest that is exact for the filter's kernel on a flat receiver. The default is 0.
    pub normal: f32,
    /// Whether each texel is compared with the depth that the receiver's own plane has at the texel's centre, instead of
    /// the receiver's depth. A flat receiver then needs next to no other bias. The default is true.
    pub receiver_plane: bool,
    /// Which faces of casters are drawn. The default is [`CasterFaces::Both`].
    pub casters: CasterFaces,
    /// What is stored of the surfaces that a ray of light meets. The default is [`DepthLayer::First`].
    pub depth_layer: DepthLayer,
    /// How far behind the first surface [`DepthLayer::Dual`] stores at most, from 0 to 1000 metres; for
    /// [`DepthLayer::Midpoint`] and [`DepthLayer::Second`], what is stored behind it where there is no second. The default
    /// is 0.05.
    pub depth_layer_limit: f32,
    /// The cosine of the angle between normal and light up to which light fades in, from 0 to 1. Surfaces that face away
    /// from the light are dark without a lookup; where smooth shading still lights them, the facets show unless it fades.
    /// The default is 0.
    pub terminator: f32,
}

/// Which faces of casters are drawn into the maps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum CasterFaces {
    /// All faces.
    Both,
    /// Those that face the light.
    Front,
    /// Those that face away from it; wants closed casters.
    Back,
}

/// What is stored of the surfaces that a ray of light meets. All but the first need casters drawn twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum DepthLayer {
    /// The first surface.
    First,
    /// The second surface (Wang & Molnar 1994).
    Second,
    /// The depth half-way between the two (Woo 1992).
    Midpoint,
    /// The depth half-way between the two, but at most [`Bias::depth_layer_limit`] behind the first (Weiskopf & Ertl
    /// 2003).
    Dual,
}

/// What plans depend on, of a bias.
pub(crate) type PlanBias = [f32; 5];

/// What is uploaded with each frame, of a bias.
pub(crate) type FrameBias = [f32; 7];

/// The numbers of a bias, by what depends on them.
pub(crate) struct BiasNumbers {
    pub plan: PlanBias,
    pub frame: FrameBias,
}

impl Default for Bias {
    fn default() -> Self {
        Self {
            raster_constant: 0,
            raster_slope: 0.0,
            constant: 0.0,    // rounding is known, and stood off by itself
            slope: 0.0,       // what is flat needs none
            slope_limit: 8.0, // 83°; steeper walls get next to no light
            bend: 0.5,        // bends between triangles: docs/decisions/0028
            normal: 0.0,      // it moves the lookup aside, and shadows shrink
            receiver_plane: true,
            casters: CasterFaces::Both,
            depth_layer: DepthLayer::First,
            depth_layer_limit: 0.05, // what stands on a ground this deep inside of it has its shadow yet
            terminator: 0.0,
        }
    }
}

impl Bias {
    /// The numbers, by what depends on them. The other fields choose pipelines and maps. Every field is named, so that a
    /// new one finds its place.
    pub(crate) fn numbers(&self) -> BiasNumbers {
        let Self {
            raster_constant: _,
            raster_slope: _,
            constant,
            slope,
            slope_limit,
            bend,
            normal,
            receiver_plane: _,
            casters: _,
            depth_layer: _,
            depth_layer_limit,
            terminator,
        } = *self;
        BiasNumbers {
            plan: [constant, slope, slope_limit, bend, normal],
            frame: [constant, slope, slope_limit, bend, normal, terminator, depth_layer_limit],
        }
    }

    /// No bias of any kind.
    pub const NONE: Self = Self {
        raster_constant: 0,
        raster_slope: 0.0,
        constant: 0.0,
        slope: 0.0,
        slope_limit: 2.0,
        bend: 0.0,
        normal: 0.0,
        receiver_plane: false,
        casters: CasterFaces::Both,
        depth_layer: DepthLayer::First,
        depth_layer_limit: 0.05,
        terminator: 0.0,
    };
}

impl Bias {
    /// Whether every value is in its range.
    pub(super) fn validate(&self) -> Result<(), SettingsError> {
        let Self {
            raster_constant,
            raster_slope,
            constant,
            slope,
            slope_limit,
            bend,
            normal,
            receiver_plane: _,
            casters: _,
            depth_layer: _,
            depth_layer_limit,
            terminator,
        } = self;
        RASTER_CONSTANT.check(*raster_constant)?;
        RASTER_SLOPE.check(*raster_slope)?;
        CONSTANT.check(*constant)?;
        SLOPE.check(*slope)?;
        SLOPE_LIMIT.check(*slope_limit)?;
        BEND.check(*bend)?;
        NORMAL.check(*normal)?;
        DEPTH_LAYER_LIMIT.check(*depth_layer_limit)?;
        TERMINATOR.check(*terminator)
    }
}

pub(crate) const KEYS: &[Key] = &[
    RECEIVER_PLANE,
    CONSTANT,
    SLOPE,
    SLOPE_LIMIT,
    BEND,
    NORMAL,
    RASTER_CONSTANT,
    RASTER_SLOPE,
    CASTERS,
    DEPTH_LAYER,
    DEPTH_LAYER_LIMIT,
    TERMINATOR,
];

const BASE: Key = Key { costs: &[Cost::Plan, Cost::Frame], ..Key::of(Group::Bias) };

const RECEIVER_PLANE: Key = Key {
    name: "bias.receiver_plane",
    label: "receiver's plane",
    help: "Each texel is compared with the depth that the receiver's own plane has there. \
           A flat receiver then needs next to no other bias.",
    source: "Dou et al. 2014",
    costs: &[Cost::Plan, Cost::Shader],
    ..BASE
};

const CONSTANT: Key = Key {
    name: "bias.constant",
    label: "constant",
    help: "How far a lookup moves toward the light, whatever the slope. \
           More of it detaches shadows from what casts them.",
    source: "opengl-tutorial 16; with the receiver's plane, Dou et al. 2014",
    unit: "metres",
    values: Values::number(0.0, 1e3, [0.0, 0.2]),
    ..BASE
};

const SLOPE: Key = Key {
    name: "bias.slope",
    label: "slope",
    help: "How far a lookup moves toward the light, times the tangent of the angle between normal and light. \
           More of it detaches shadows on slopes.",
    source: "opengl-tutorial 16",
    unit: "texels",
    values: Values::number(0.0, 100.0, [0.0, 10.0]),
    ..BASE
};

const SLOPE_LIMIT: Key = Key {
    name: "bias.slope_limit",
    label: "steepest slope",
    help: "The largest tangent that counts for `bias.slope` and `bias.bend`. \
           Less of it leaves acne on steep walls, more of it detaches their shadows.",
    source: "opengl-tutorial 16, where it is 2",
    values: Values::number(0.0, 1e4, [0.0, 40.0]),
    ..BASE
};

const BEND: Key = Key {
    name: "bias.bend",
    label: "bend",
    help: "How far the surface is taken to bend toward the light for each texel that a comparison lies beside the \
           receiver, over the cosine of the angle between normal and light. \
           Less of it leaves acne where triangles meet, more of it lets light in at contacts.",
    unit: "texels",
    values: Values::number(0.0, 100.0, [0.0, 2.0]),
    ..BASE
};

const NORMAL: Key = Key {
    name: "bias.normal",
    label: "along the normal",
    help: "How far a lookup moves along the receiver's normal. Without the receiver's plane, 1 is the smallest that \
           is exact for the filter's kernel on a flat receiver. More of it makes all shadows smaller.",
    source: "Holbert 2011",
    values: Values::number(0.0, 100.0, [0.0, 4.0]),
    ..BASE
};

const RASTER_CONSTANT: Key = Key {
    name: "bias.raster_constant",
    label: "raster constant",
    help: "How many of the smallest steps of the map's format casters are drawn deeper. \
           More of it detaches shadows.",
    source: "glPolygonOffset, units; Ferko 2010",
    unit: "depth steps",
    costs: &[Cost::Casters],
    values: Values::Whole {
        min: -1_000_000_000,
        max: 1_000_000_000,
        only: &[],
        slide: [-16, 16],
        logarithmic: false,
    },
    ..BASE
};

const RASTER_SLOPE: Key = Key {
    name: "bias.raster_slope",
    label: "raster slope",
    help: "How much deeper casters are drawn, in their own depth slopes a texel. \
           More of it detaches shadows on slopes.",
    source: "glPolygonOffset, factor; Ferko 2010",
    costs: &[Cost::Casters],
    values: Values::number(-100.0, 100.0, [-8.0, 8.0]),
    ..BASE
};

const CASTERS: Key = Key {
    name: "bias.casters",
    label: "faces",
    help: "Which faces of casters are drawn into the maps.",
    source: "opengl-tutorial 16",
    costs: &[Cost::Casters],
    values: Values::Choice(&[
        Choice { name: "both", label: "both", help: "All of them.", source: "" },
        Choice { name: "front", label: "front", help: "Those that face the light.", source: "" },
        Choice {
            name: "back",
            label: "back",
            help: "Those that face away. Closed things need no other bias; open ones shadow themselves.",
            source: "opengl-tutorial 16",
        },
    ]),
    ..BASE
};

const DEPTH_LAYER: Key = Key {
    name: "bias.depth_layer",
    label: "depth layer",
    help: "What is stored of the surfaces that a ray of light meets. All but the first draw casters twice.",
    costs: &[Cost::Casters, Cost::Maps],
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

const DEPTH_LAYER_LIMIT: Key = Key {
    name: "bias.depth_layer_limit",
    label: "depth layer's limit",
    help: "The most that a dual layer is stored behind the first surface; for the others, how far behind it where \
           there is no second. More of it lets light in under what is thin.",
    source: "Weiskopf & Ertl 2003",
    unit: "metres",
    costs: &[Cost::Frame],
    values: Values::number(0.0, 1e3, [0.0, 1.0]),
    ..BASE
};

const TERMINATOR: Key = Key {
    name: "bias.terminator",
    label: "terminator",
    help: "The cosine of the angle between normal and light up to which light fades in. It hides the facets of \
           smooth things where they turn away from the light, and darkens what is lit from the side.",
    costs: &[Cost::Frame],
    values: Values::number(0.0, 1.0, [0.0, 1.0]),
    ..BASE
};
