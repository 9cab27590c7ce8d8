//! Shadows from the camera's depth.

use super::{Absent, Group, Key, Values};
use crate::contact::Contact;

pub(super) const KEYS: &[Key] = &[CONTACT, LENGTH, STEPS, THICKNESS];

const BASE: Key = Key { source: "Bend Studio 2023", ..Key::of(Group::Contact) };
/// Every length but 0 and less.
const POSITIVE: f64 = f32::MIN_POSITIVE as f64;

const CONTACT: Key = Key {
    name: "contact",
    label: "contact shadows",
    help: "Shadows from the camera's depth, for the last centimetres that a map's bias loses. \
           They need that depth before shading, and march through it at every pixel.",
    values: Values::Table,
    wanted: "a table of settings",
    absent: Some(Absent { means: "no shadows from the camera's depth", start: "{}" }),
    ..BASE
};

pub(crate) const LENGTH: Key = Key {
    name: "contact.length",
    label: "length",
    help: "How far is looked toward the light. What casts from farther away is the maps' business. \
           With more of it each step is longer, and thin things are missed.",
    unit: "metres",
    values: Values::ratio(POSITIVE, 100.0, [0.01, 10.0]),
    wanted: "more than 0, at most 100 metres",
    ..BASE
};

pub(crate) const STEPS: Key = Key {
    name: "contact.steps",
    label: "steps",
    help: "In how many steps is looked. What is thinner on screen than a step may be missed; each costs a lookup.",
    unit: "steps",
    values: Values::whole(1, Contact::MAX_STEPS as i64),
    wanted: "from 1 to 64",
    ..BASE
};

pub(crate) const THICKNESS: Key = Key {
    name: "contact.thickness",
    label: "thickness",
    help: "How deep things are taken to be behind what the camera sees of them. \
           More of it darkens what lies behind posts.",
    unit: "metres",
    values: Values::ratio(POSITIVE, 100.0, [0.01, 10.0]),
    wanted: "more than 0, at most 100 metres",
    ..BASE
};
