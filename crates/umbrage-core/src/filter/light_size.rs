//! The size of lights, where a filter makes penumbrae.

use crate::error::SettingsError;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::values::Values;

/// The size that lights have which say none of their own.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct LightSize {
    /// The whole angle that a sun is seen under, from 0 to 180 degrees; 0 is a point. The default is 0.53, our sun's.
    pub sun_degrees: f32,
    /// The diameter of spots and points, from 0 to 10000 metres; 0 is a point. The default is 0.1.
    pub punctual_metres: f32,
}

impl Default for LightSize {
    fn default() -> Self {
        Self { sun_degrees: 0.53, punctual_metres: 0.1 } // our sun, and a bulb with its shade
    }
}

impl LightSize {
    pub(super) fn validate(&self) -> Result<(), SettingsError> {
        let Self { sun_degrees, punctual_metres } = self;
        SUN_DEGREES.check(*sun_degrees)?;
        PUNCTUAL_METRES.check(*punctual_metres)
    }
}

const BASE: Key = Key { costs: &[Cost::Frame], ..Key::of(Group::Filter) };

pub(super) const SUN_DEGREES: Key = Key {
    name: "filter.light.sun_degrees",
    label: "sun's size",
    help: "The whole angle that a sun is seen under, where it has no size of its own; 0 is a point, \
           and our sun has 0.53. A larger one makes wider penumbrae.",
    unit: "degrees",
    values: Values::number(0.0, 180.0, [0.0, 10.0]),
    ..BASE
};

pub(super) const PUNCTUAL_METRES: Key = Key {
    name: "filter.light.punctual_metres",
    label: "size of spots and points",
    help: "The diameter of spots and points that have no size of their own; 0 is a point. \
           A larger one makes wider penumbrae.",
    unit: "metres",
    values: Values::number(0.0, 1e4, [0.0, 2.0]),
    ..BASE
};
