//! Which shadows are looked for on screen, where a map's bias has lost them? The last centimetres between a thing and what
//! it stands on: a march through the camera's own depth, toward the light.

use crate::SettingsError;
use crate::check::check;
use crate::schema::contact;

/// Contact shadows: how far a receiver looks toward the light in the camera's depth buffer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Contact {
    /// How far is looked, metres. What casts from farther away is the maps' business.
    pub length: f32,
    /// In how many steps, 1 to 64. What is thinner on screen than a step may be missed.
    pub steps: u32,
    /// How deep things are taken to be behind what the camera sees of them, metres.
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
        check(&contact::LENGTH, length)?;
        check(&contact::STEPS, steps)?;
        check(&contact::THICKNESS, thickness)
    }
}

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
