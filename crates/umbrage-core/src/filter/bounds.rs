//! What keeps the bounds of moments from acne, and from leaking?

use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::values::Values;

pub(super) const MIN_STANDARD_DEVIATION: Key = Key {
    name: "filter.min_standard_deviation",
    label: "min deviation",
    help: "No standard deviation of depth is taken to be smaller. \
           Less of it is acne, more of it lets light in at contacts.",
    source: "Donnelly & Lauritzen 2006",
    unit: "metres",
    costs: &[Cost::Shader],
    values: Values::number(0.0, 10.0, [0.0, 0.5]),
    ..Key::of(Group::Filter)
};

pub(super) const LIGHT_BLEED_REDUCTION: Key = Key {
    name: "filter.light_bleed_reduction",
    label: "bleed reduction",
    help: "The share of light that is taken for leaked. More of it hides leaks, and makes penumbrae narrower.",
    source: "Lauritzen 2007",
    costs: &[Cost::Shader],
    values: Values::number(0.0, 0.99, [0.0, 0.99]),
    ..Key::of(Group::Filter)
};

/// The variance that a standard deviation in metres is, in squares of a map's depth.
pub(super) fn variance(standard_deviation: f32, depth_metres: f32) -> f32 {
    (standard_deviation / depth_metres.max(f32::MIN_POSITIVE)).powi(2)
}
