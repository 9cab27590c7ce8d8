//! Where is the depth of the view cut?

use super::limits::MAX_SPLITS;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::{Absent, Key};
use crate::schema::values::{Choice, POSITIVE, Values};

/// How cuts are placed. Zhang et al. 2006, eqs. 4–7.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Scheme {
    /// A mix of logarithmic and uniform by λ.
    Practical,
    /// Equal slices.
    Uniform,
    /// Slices of equal ratio.
    Logarithmic,
    /// The distances that are given, in metres.
    Manual,
}

pub(crate) const KEYS: &[Key] = &[SPLITS, SPOT_SPLITS, SCHEME, LAMBDA, SPLIT_BIAS, MANUAL, DISTANCE, NEAR];

const BASE: Key = Key { costs: &[Cost::Plan], ..Key::of(Group::Splits) };

pub(super) const SPLITS: Key = Key {
    name: "splits",
    label: "splits",
    help: "Into how many slices the camera's depth is cut for a sun; 1 is an ordinary shadow map. \
           Each has a map of its own, so memory and drawing grow with them.",
    source: "Zhang et al. 2006, §3; Ferko 2010, listing 4.13",
    costs: &[Cost::Plan, Cost::Maps],
    values: Values::whole(1, MAX_SPLITS as i64),
    ..BASE
};

pub(super) const SPOT_SPLITS: Key = Key {
    name: "spot_splits",
    label: "splits of a spot",
    help: "Into how many slices the depth is cut that a spot light reaches. \
           Each has a map of its own, so memory and drawing grow with them.",
    costs: &[Cost::Plan, Cost::Maps],
    values: Values::whole(1, MAX_SPLITS as i64),
    ..BASE
};

const SCHEME: Key = Key {
    name: "scheme",
    label: "scheme",
    help: "How the cuts are placed.",
    source: "Zhang et al. 2006, eqs. 4–7",
    values: Values::Choice(&[
        Choice {
            name: "practical",
            label: "practical",
            help: "A mix of logarithmic and uniform by λ.",
            source: "Zhang et al. 2006, eq. 6",
        },
        Choice {
            name: "uniform",
            label: "uniform",
            help: "Equal slices. What is near the eye is coarse.",
            source: "Zhang et al. 2006, eq. 5",
        },
        Choice {
            name: "logarithmic",
            label: "logarithmic",
            help: "Slices of equal ratio, the best in theory. The first ones may be too thin to hold anything.",
            source: "Zhang et al. 2006, eq. 4",
        },
        Choice { name: "manual", label: "manual", help: "The distances that are given.", source: "" },
    ]),
    ..BASE
};

pub(super) const LAMBDA: Key = Key {
    name: "lambda",
    label: "λ",
    help: "How the practical scheme mixes its two parts: 0 is uniform, 1 is logarithmic. \
           More of it makes what is near finer, and what is far coarser.",
    source: "Zhang et al. 2006, eq. 6; Ferko 2010, §3.1",
    values: Values::number(0.0, 1.0, [0.0, 1.0]),
    ..BASE
};

pub(super) const SPLIT_BIAS: Key = Key {
    name: "split_bias",
    label: "δ_bias",
    help: "Moves the inner cuts away from the eye. The first slice becomes deeper, and its texels coarser.",
    source: "Zhang et al. 2006, eq. 7",
    unit: "metres",
    values: Values::number(0.0, 1e6, [0.0, 20.0]),
    ..BASE
};

const MANUAL: Key = Key {
    name: "manual",
    label: "distances",
    help: "The inner cuts of the manual scheme, measured from the eye: one fewer than there are splits.",
    unit: "metres",
    values: Values::Distances,
    note: "one less than `splits`",
    ..BASE
};

pub(super) const DISTANCE: Key = Key {
    name: "distance",
    label: "distance",
    help: "How far from the eye there are shadows. \
           A longer distance spreads the same texels over more of the world.",
    unit: "metres",
    values: Values::ratio(POSITIVE, 1e9, [10.0, 10_000.0]),
    absent: Some(Absent { means: "the camera's far", start: "100.0" }),
    ..BASE
};

pub(super) const NEAR: Key = Key {
    name: "near",
    label: "near",
    help: "A virtual near for the cuts; what is nearer still gets shadows. \
           A larger one leaves more texels for what is far, and fewer for what is close.",
    unit: "metres",
    values: Values::ratio(POSITIVE, 1e9, [0.01, 100.0]),
    absent: Some(Absent { means: "the camera's near", start: "1.0" }),
    ..BASE
};
