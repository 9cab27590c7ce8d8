//! How a map is read: which filter, and in the files below the numbers of each.

mod kinds;
pub(crate) mod moments;
pub(crate) mod points;
pub(crate) mod soft;

use super::{Group, Key, Values};

pub(super) const KEYS: &[Key] = &[KIND, PCF_SIZE, OPTIMISED_SIZE];

const BASE: Key = Key::of(Group::Filter);

const KIND: Key = Key {
    name: "filter.kind",
    label: "kind",
    help: "How a map is read. Each kind has its own numbers.",
    values: Values::Choice(kinds::KINDS),
    ..BASE
};

pub(crate) const PCF_SIZE: Key = Key {
    name: "filter.size",
    label: "size",
    help: "Lookups a side, one texel apart. More of them make softer edges, and cost their square.",
    source: "Reeves, Salesin & Cook 1987",
    unit: "lookups",
    kinds: &["pcf"],
    values: Values::Whole { least: 1, most: 9, only: &[1, 3, 5, 7, 9], slide: [1, 9], logarithmic: false },
    wanted: "1, 3, 5, 7 or 9 lookups a side",
    ..BASE
};

pub(crate) const OPTIMISED_SIZE: Key = Key {
    name: "filter.size",
    label: "size",
    help: "Texels a side of the bell. A larger one makes softer edges, of 4, 9 or 16 lookups.",
    source: "Castaño 2013",
    unit: "texels",
    kinds: &["optimised"],
    values: Values::Whole { least: 3, most: 7, only: &[3, 5, 7], slide: [3, 7], logarithmic: false },
    wanted: "3, 5 or 7 texels a side",
    ..BASE
};
