//! What does a shadow do to the picture?

use crate::error::SettingsError;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::kind::Kind;
use crate::schema::values::{Choice, Values};

/// What a shadow does to the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields))]
pub enum Shade {
    /// The light adds less.
    Absence {
        /// The share of the light that a shadow takes away, from 0 to 1. The default is 1.
        #[cfg_attr(feature = "serde", serde(default = "full_darkness"))]
        darkness: f32,
    },
    /// The lit picture is mixed with a colour (Ferko 2010, listing 4.9).
    Colour {
        /// The colour of shadows, four numbers from 0 to 1: linear red, green and blue, and in alpha how much of the lit
        /// picture it replaces.
        shadow_colour: [f32; 4],
        /// The share of the light that a shadow takes away, from 0 to 1. The default is 1.
        #[cfg_attr(feature = "serde", serde(default = "full_darkness"))]
        darkness: f32,
    },
}

#[cfg(feature = "serde")]
fn full_darkness() -> f32 {
    1.0
}

impl Shade {
    /// The shade's name, as `shade.kind` of a settings file has it.
    pub fn kind(&self) -> &'static str {
        self.row().choice.name
    }

    /// The rows of the shade's own numbers in the schema, in a panel's order.
    pub fn keys(&self) -> &'static [Key] {
        self.row().keys
    }

    /// The shade of a kind's name, with numbers to start from; `None` where no shade is called so.
    pub fn of_kind(kind: &str) -> Option<Self> {
        Some(match kind {
            "absence" => Self::Absence { darkness: 1.0 },
            // Half of the lit picture in a shadow's own blue.
            "colour" => Self::Colour { shadow_colour: [0.0, 0.0, 0.1, 0.5], darkness: 1.0 },
            _ => return None,
        })
    }

    /// The share of the light that a shadow takes away, from 0 to 1.
    pub fn darkness(&self) -> f32 {
        match self {
            Self::Absence { darkness } | Self::Colour { darkness, .. } => *darkness,
        }
    }

    fn row(&self) -> &'static Kind {
        match self {
            Self::Absence { .. } => &ABSENCE,
            Self::Colour { .. } => &COLOUR,
        }
    }

    /// Whether every value is in its range.
    pub(super) fn validate(&self) -> Result<(), SettingsError> {
        DARKNESS.check(self.darkness())?;
        match self {
            Self::Absence { darkness: _ } => Ok(()),
            Self::Colour { shadow_colour, darkness: _ } => {
                shadow_colour.iter().try_for_each(|channel| SHADOW_COLOUR.check(*channel))
            }
        }
    }
}

/// What the schema has of every shade, in the order of `shade.kind`.
pub(crate) const KINDS: &[&Kind] = &[&ABSENCE, &COLOUR];

const ABSENCE: Kind = Kind {
    choice: Choice {
        name: "absence",
        label: "absence of light",
        help: "The light adds less.",
        source: "Ferko 2010, \"absence of light\"",
    },
    keys: &[DARKNESS],
};

const COLOUR: Kind = Kind {
    choice: Choice {
        name: "colour",
        label: "colour",
        help: "The lit picture is mixed with a colour.",
        source: "Ferko 2010, listing 4.9",
    },
    keys: &[DARKNESS, SHADOW_COLOUR],
};

/// The row of `shade.kind`.
pub(crate) const KIND: Key = Key {
    name: "shade.kind",
    label: "kind",
    help: "What a shadow does to the picture.",
    values: Values::Choice(&[ABSENCE.choice, COLOUR.choice]),
    ..BASE
};

const BASE: Key = Key { costs: &[Cost::Frame], ..Key::of(Group::Shade) };

const DARKNESS: Key = Key {
    name: "shade.darkness",
    label: "darkness",
    help: "How much of the light a shadow takes away: 1 is all of it.",
    source: "opengl-tutorial 16, where it is 0.5",
    values: Values::number(0.0, 1.0, [0.0, 1.0]),
    ..BASE
};

const SHADOW_COLOUR: Key = Key {
    name: "shade.shadow_colour",
    label: "colour",
    help: "The colour of shadows, in linear red, green and blue. Alpha is how much of the lit picture it replaces.",
    source: "Ferko 2010, listing 4.9",
    values: Values::Colour,
    ..BASE
};
