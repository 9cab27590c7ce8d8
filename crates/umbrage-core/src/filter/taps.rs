//! How many points are compared?

use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::values::Values;

/// The points of filters that have as many as they like.
pub(super) const TAPS: Key = Key {
    name: "filter.taps",
    label: "points",
    help: "How many points are compared. More of them leave less noise, and cost a lookup each.",
    unit: "points",
    costs: &[Cost::Shader],
    values: Values::whole(1, 64),
    ..Key::of(Group::Filter)
};
