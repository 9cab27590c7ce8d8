//! Which shadows are looked for on screen, where a map's bias has lost them? The last centimetres between a thing and what
//! it stands on: a march through the camera's own depth, toward the light.

use crate::error::SettingsError;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::{Absent, Key};
use crate::schema::values::{POSITIVE, Values};

/// Contact shadows: how far and how closely a receiver looks toward the light in the camera's depth buffer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Contact {
    /// The march toward the light is so long, more than 0 and at most 100 metres. What casts from farther away is the maps'
    /// business. The default is 0.3.
    pub length: f32,
    /// The number of steps that it is looked in, from 1 to 64 steps. What is thinner on screen than a step may be missed. The
    /// default is 16.
    pub steps: u32,
    /// Things are taken to be so deep behind what the camera sees of them, more than 0 and at most 100 metres. The default
    /// is 0.1.
    pub thickness: f32,
}

impl Default for Contact {
    fn default() -> Self {
        Self {
            length: 0.3,    // a map's bias is some texels, and its texels are centimetres near the eye
            steps: 16,      // 2 cm each: a contact seen from 10 m at 1080 lines has such pixels
            thickness: 0.1, // as thick as what stands about in rooms; more darkens what is behind a post
        }
    }
}

impl Contact {
    /// The most steps a march may have.
    pub const MAX_STEPS: u32 = 64;

    /// Whether every value is in its range.
    pub(crate) fn validate(&self) -> Result<(), SettingsError> {
        let Self { length, steps, thickness } = *self;
        LENGTH.check(length)?;
        STEPS.check(steps)?;
        THICKNESS.check(thickness)
    }
}

pub(crate) const KEYS: &[Key] = &[CONTACT, LENGTH, STEPS, THICKNESS];

const BASE: Key = Key { source: "Bend Studio 2023", costs: &[Cost::Shader], ..Key::of(Group::Contact) };

const CONTACT: Key = Key {
    name: "contact",
    label: "contact shadows",
    help: "Shadows from the camera's depth, for the last centimetres that a map's bias loses. \
           They need that depth before shading, and march through it at every pixel.",
    values: Values::Table,
    absent: Some(Absent { means: "no shadows from the camera's depth", start: "{}" }),
    ..BASE
};

const LENGTH: Key = Key {
    name: "contact.length",
    label: "length",
    help: "How far is looked toward the light. What casts from farther away is the maps' business. \
           With more of it each step is longer, and thin things are missed.",
    unit: "metres",
    values: Values::ratio(POSITIVE, 100.0, [0.01, 10.0]),
    ..BASE
};

const STEPS: Key = Key {
    name: "contact.steps",
    label: "steps",
    help: "In how many steps is looked. What is thinner on screen than a step may be missed; each costs a lookup.",
    unit: "steps",
    values: Values::whole(1, Contact::MAX_STEPS as i64),
    ..BASE
};

const THICKNESS: Key = Key {
    name: "contact.thickness",
    label: "thickness",
    help: "How deep things are taken to be behind what the camera sees of them. \
           More of it darkens what lies behind posts.",
    unit: "metres",
    values: Values::ratio(POSITIVE, 100.0, [0.01, 10.0]),
    ..BASE
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Settings;

    #[test]
    fn the_default_is_valid_and_off() {
        assert_eq!(Contact::default().validate(), Ok(()));
        assert_eq!(Settings::default().contact, None);
    }

    #[test]
    fn a_value_out_of_range_is_named() {
        let key = |contact| match (Settings { contact: Some(contact), ..Settings::default() }).validate() {
            Err(SettingsError::OutOfRange { key, .. }) => key,
            other => panic!("expected a value out of range, got {other:?}"),
        };
        let default = Contact::default;
        assert_eq!(key(Contact { length: 0.0, ..default() }), "contact.length");
        assert_eq!(key(Contact { length: f32::NAN, ..default() }), "contact.length");
        assert_eq!(key(Contact { steps: 0, ..default() }), "contact.steps");
        assert_eq!(key(Contact { steps: 65, ..default() }), "contact.steps");
        assert_eq!(key(Contact { thickness: f32::INFINITY, ..default() }), "contact.thickness");
    }

    #[cfg(feature = "serde")]
    #[test]
    fn one_key_is_enough_to_have_contact_shadows() {
        let settings: Settings = toml::from_str("contact.length = 0.5").unwrap();
        assert_eq!(settings.contact, Some(Contact { length: 0.5, ..Contact::default() }));
        assert!(!toml::to_string(&Settings::default()).unwrap().contains("contact"), "absent where off");
    }
}
