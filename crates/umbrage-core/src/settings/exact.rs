//! A map answers to within a texel. Where that is not enough, a ray through the casters' triangles answers exactly.

use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::values::{Choice, Values};

/// Which receivers are traced instead of looked up, where the host has handed over its casters' triangles. Without them all are
/// looked up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Exact {
    /// None: maps alone answer. This is the default.
    #[default]
    Off,
    /// Those around which the texels of a map disagree, or nearly do; the map answers for the others.
    Undecided,
    /// All.
    Always,
}

/// The row of `exact`.
pub(crate) const EXACT: Key = Key {
    name: "exact",
    label: "exact",
    help: "Which receivers are traced through the casters' triangles, where a host has handed them over. A ray has no error of a \
           map; it costs time, and triangles memory. With pcss a ray goes to each point of the light; with other filters \
           shadows are hard.",
    source: "Hertel, Hormann and Westermann 2009",
    costs: &[Cost::Shader],
    values: Values::Choice(&[
        Choice { name: "off", label: "off", help: "None: maps alone answer.", source: "" },
        Choice {
            name: "undecided",
            label: "undecided",
            help: "Those around which the texels of a map disagree: along the edges of shadows, and on what bends in a texel.",
            source: "Hertel, Hormann and Westermann 2009",
        },
        Choice {
            name: "always",
            label: "always",
            help: "All: what maps are measured against, at several times the cost.",
            source: "",
        },
    ]),
    ..Key::of(Group::Filter)
};
