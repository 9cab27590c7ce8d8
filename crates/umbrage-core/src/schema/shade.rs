//! What a shadow does to the picture.

use super::{Choice, Group, Key, Values};

pub(super) const KEYS: &[Key] = &[KIND, DARKNESS, SHADOW_COLOUR];

const BASE: Key = Key::of(Group::Shade);

const KIND: Key = Key {
    name: "shade.kind",
    label: "kind",
    help: "What a shadow does to the picture.",
    values: Values::Choice(&[
        Choice {
            name: "absence",
            label: "absence of light",
            help: "The light adds less.",
            source: "Ferko 2010, \"absence of light\"",
        },
        Choice {
            name: "colour",
            label: "colour",
            help: "The lit picture is mixed with a colour.",
            source: "Ferko 2010, listing 4.9",
        },
    ]),
    ..BASE
};

pub(crate) const DARKNESS: Key = Key {
    name: "shade.darkness",
    label: "darkness",
    help: "How much of the light a shadow takes away: 1 is all of it.",
    source: "opengl-tutorial 16, where it is 0.5",
    values: Values::number(0.0, 1.0, [0.0, 1.0]),
    wanted: "from 0 to 1",
    ..BASE
};

pub(crate) const SHADOW_COLOUR: Key = Key {
    name: "shade.shadow_colour",
    label: "colour",
    help: "The colour of shadows, in linear red, green and blue. Alpha is how much of the lit picture it replaces.",
    source: "Ferko 2010, listing 4.9",
    kinds: &["colour"],
    values: Values::Colour,
    wanted: "four numbers from 0 to 1",
    ..BASE
};
