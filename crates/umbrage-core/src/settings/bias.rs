//! What keeps surfaces from shadowing themselves: which faces are drawn, what is stored of them, and how far a lookup
//! stands off. Ten ways and what each costs: `docs/decisions/0015-biases.md`.

use crate::SettingsError;
use crate::check::check;
use crate::schema::bias;

/// What keeps surfaces from shadowing themselves. Zero everywhere is no bias.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Bias {
    /// Raster: least depth steps of the map's format (`glPolygonOffset` units).
    pub raster_constant: i32,
    /// Raster: times the caster's depth slope a texel (`glPolygonOffset` factor).
    pub raster_slope: f32,
    /// Toward the light at lookup, metres.
    pub constant: f32,
    /// Toward the light at lookup, in texels of the view, times the tangent of the angle between normal and light.
    pub slope: f32,
    /// The largest tangent that `slope` is multiplied with; 2 in opengl-tutorial 16 (0.01 / 0.005).
    pub slope_limit: f32,
    /// Along the receiver's normal at lookup; without `receiver_plane`, 1 is the least that is exact for the filter's
    /// kernel on a flat receiver.
    pub normal: f32,
    /// Whether each texel is compared with the depth that the receiver's own plane has at the texel's centre, instead of
    /// the receiver's depth. A flat receiver then needs next to no other bias.
    pub receiver_plane: bool,
    /// Which faces of casters are drawn.
    pub casters: CasterFaces,
    /// What is stored, of the first surface that the light meets and of the second.
    pub depth_layer: DepthLayer,
    /// For [`DepthLayer::Dual`], the most that is stored behind the first surface; for [`DepthLayer::Midpoint`] and
    /// [`DepthLayer::Second`], what is stored behind it where there is no second, metres.
    pub depth_layer_limit: f32,
    /// Cosine of the angle between normal and light up to which light fades in, 0 to 1. Surfaces that are turned away from
    /// the light are dark without a lookup; where smooth shading still lights them, the facets show unless it fades.
    pub terminator: f32,
}

/// Which faces of casters are drawn into the maps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum CasterFaces {
    /// All.
    Both,
    /// Those turned to the light.
    Front,
    /// Those turned away; wants closed casters.
    Back,
}

/// What is stored of the surfaces that a ray of light meets. All but the first need casters drawn twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum DepthLayer {
    /// The first.
    First,
    /// The second (Wang & Molnar 1994).
    Second,
    /// Half-way between the two (Woo 1992).
    Midpoint,
    /// Half-way between the two, but at most [`Bias::depth_layer_limit`] behind the first (Weiskopf & Ertl 2003).
    Dual,
}

impl Default for Bias {
    fn default() -> Self {
        Self {
            raster_constant: 0,
            raster_slope: 0.0,
            constant: 0.002,   // rounding of depth over a few kilometres in 32 bits
            slope: 0.5,        // bends between triangles: docs/decisions/0017
            slope_limit: 16.0, // 86°; steeper walls get next to no light
            normal: 0.0,       // it moves the lookup aside, and shadows downsample
            receiver_plane: true,
            casters: CasterFaces::Both,
            depth_layer: DepthLayer::First,
            depth_layer_limit: 0.05, // what stands on a ground this deep inside of it has its shadow yet
            terminator: 0.0,
        }
    }
}

impl Bias {
    /// No bias at all.
    pub const NONE: Self = Self {
        raster_constant: 0,
        raster_slope: 0.0,
        constant: 0.0,
        slope: 0.0,
        slope_limit: 2.0,
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
            normal,
            receiver_plane: _,
            casters: _,
            depth_layer: _,
            depth_layer_limit,
            terminator,
        } = self;
        check(&bias::RASTER_CONSTANT, *raster_constant)?;
        check(&bias::RASTER_SLOPE, *raster_slope)?;
        check(&bias::CONSTANT, *constant)?;
        check(&bias::SLOPE, *slope)?;
        check(&bias::SLOPE_LIMIT, *slope_limit)?;
        check(&bias::NORMAL, *normal)?;
        check(&bias::DEPTH_LAYER_LIMIT, *depth_layer_limit)?;
        check(&bias::TERMINATOR, *terminator)
    }
}
