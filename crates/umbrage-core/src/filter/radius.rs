//! How wide is a kernel whose width is given in metres, in texels, or both?

use super::shader::ShaderNumber;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::{Absent, Key};
use crate::schema::values::Values;

/// A radius in a view whose texels have this side, texels: `metres` of the world, no more than `texels`; at least half a
/// texel.
pub(super) fn radius_at(metres: Option<f32>, texels: f32, texel_metres: f32) -> f32 {
    metres.map_or(texels, |metres| (metres / texel_metres.max(f32::MIN_POSITIVE)).min(texels)).max(0.5)
}

/// The numbers that shaders know a radius by.
pub(super) fn numbers(metres: Option<f32>, texels: f32) -> [ShaderNumber; 3] {
    [
        ShaderNumber::bool("UMBRAGE_RADIUS_IN_METRES", metres.is_some()),
        ShaderNumber::f32("UMBRAGE_RADIUS_METRES", metres.unwrap_or_default()),
        ShaderNumber::f32("UMBRAGE_RADIUS_TEXELS", texels),
    ]
}

/// The radius in metres; its help is the filter's.
pub(super) const METRES: Key = Key {
    name: "filter.radius",
    label: "radius",
    unit: "metres",
    costs: &[Cost::Shader],
    values: Values::number(0.0, 1e3, [0.0, 1.0]),
    absent: Some(Absent { means: "the radius in texels", start: "0.1" }),
    ..Key::of(Group::Filter)
};

/// The radius in texels; its help is the filter's.
pub(super) const TEXELS: Key = Key {
    name: "filter.radius_texels",
    label: "radius in texels",
    unit: "texels",
    costs: &[Cost::Plan, Cost::Shader],
    values: Values::number(0.0, 64.0, [0.0, 16.0]),
    ..Key::of(Group::Filter)
};
