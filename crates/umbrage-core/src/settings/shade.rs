//! What a shadow does to the picture.

use crate::SettingsError;
use crate::check::check;
use crate::schema::shade;

/// What a shadow does to the picture. `darkness` is 1 where a shadow takes all of the light away, 0 where none.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields))]
pub enum Shade {
    /// The light adds less.
    Absence {
        /// 0 to 1.
        #[cfg_attr(feature = "serde", serde(default = "full_darkness"))]
        darkness: f32,
    },
    /// The lit picture is mixed with a colour (Ferko 2010, listing 4.9).
    Colour {
        /// Linear RGB, and in alpha how much of the lit picture it replaces, 0 to 1.
        shadow_colour: [f32; 4],
        /// 0 to 1.
        #[cfg_attr(feature = "serde", serde(default = "full_darkness"))]
        darkness: f32,
    },
}

#[cfg(feature = "serde")]
fn full_darkness() -> f32 {
    1.0
}

impl Shade {
    /// Its name, as `shade.kind` of a settings file has it.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Absence { .. } => "absence",
            Self::Colour { .. } => "colour",
        }
    }

    /// The shade of this name with numbers to start from.
    pub fn of_kind(kind: &str) -> Option<Self> {
        Some(match kind {
            "absence" => Self::Absence { darkness: 1.0 },
            // Half of the lit picture in a shadow's own blue.
            "colour" => Self::Colour { shadow_colour: [0.0, 0.0, 0.1, 0.5], darkness: 1.0 },
            _ => return None,
        })
    }

    /// Whether every value is in its range.
    pub(super) fn validate(&self) -> Result<(), SettingsError> {
        let (Self::Absence { darkness } | Self::Colour { darkness, .. }) = self;
        check(&shade::DARKNESS, *darkness)?;
        if let Self::Colour { shadow_colour, .. } = self {
            for channel in shadow_colour {
                check(&shade::SHADOW_COLOUR, *channel)?;
            }
        }
        Ok(())
    }
}
