//! Which box of the world does a sun's one map hold, where it is said by hand?

use glam::DVec3;

use crate::error::SettingsError;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::{Absent, Key};
use crate::schema::values::{POSITIVE, Values};

/// A light box is what the map of a sun holds under [`Fit::World`](crate::Fit::World), instead of the whole world: a box whose
/// axis is the light's. It is what tutorials give to `glOrtho`. What lies beside it or behind it is lit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct LightBox {
    /// The x of the point that the box is measured from, from -1000000000 to 1000000000 metres. The default is 0.
    pub x: f32,
    /// The y of that point, from -1000000000 to 1000000000 metres. The default is 0.
    pub y: f32,
    /// The z of that point, from -1000000000 to 1000000000 metres. The default is 0.
    pub z: f32,
    /// Half of the width, more than 0 and at most 1000000000 metres. The default is 10.
    pub half_width: f32,
    /// Half of the height, along the world's up as the light sees it, more than 0 and at most 1000000000 metres. The default is
    /// 10.
    pub half_height: f32,
    /// How far behind the point, along the light's way, the box begins, from -1000000000 to 1000000000 metres; what is less
    /// than 0 lies toward the light. The default is -10.
    pub near: f32,
    /// How deep the box is along the light's way, more than 0 and at most 1000000000 metres. The default is 30.
    pub depth_range: f32,
}

impl Default for LightBox {
    /// The box of opengl-tutorial 16.
    fn default() -> Self {
        Self { x: 0.0, y: 0.0, z: 0.0, half_width: 10.0, half_height: 10.0, near: -10.0, depth_range: 30.0 }
    }
}

impl LightBox {
    /// The point that the box is measured from, in world space.
    pub(crate) fn centre(&self) -> DVec3 {
        DVec3::new(self.x.into(), self.y.into(), self.z.into())
    }

    /// Whether every value is in its range.
    pub(crate) fn validate(&self) -> Result<(), SettingsError> {
        let Self { x, y, z, half_width, half_height, near, depth_range } = *self;
        X.check(x)?;
        Y.check(y)?;
        Z.check(z)?;
        HALF_WIDTH.check(half_width)?;
        HALF_HEIGHT.check(half_height)?;
        NEAR.check(near)?;
        DEPTH_RANGE.check(depth_range)
    }
}

pub(crate) const KEYS: &[Key] = &[LIGHT_BOX, X, Y, Z, HALF_WIDTH, HALF_HEIGHT, NEAR, DEPTH_RANGE];

const BASE: Key = Key { source: "opengl-tutorial 16", costs: &[Cost::Plan], ..Key::of(Group::Maps) };
const PLACE: Key = Key { unit: "metres", values: Values::number(-1e9, 1e9, [-100.0, 100.0]), ..BASE };
const SIZE: Key = Key { unit: "metres", values: Values::ratio(POSITIVE, 1e9, [1.0, 10_000.0]), ..BASE };

const LIGHT_BOX: Key = Key {
    name: "light_box",
    label: "light box",
    help: "The box that a sun's map holds under `fit = \"world\"`, along the light's axis. \
           What lies beside it or behind it is lit; a smaller one has finer texels.",
    values: Values::Table,
    absent: Some(Absent { means: "the box of the whole world", start: "{}" }),
    ..BASE
};

const X: Key = Key {
    name: "light_box.x",
    label: "x",
    help: "The x of the point that the box is measured from.",
    ..PLACE
};
const Y: Key = Key {
    name: "light_box.y",
    label: "y",
    help: "The y of the point that the box is measured from.",
    ..PLACE
};
const Z: Key = Key {
    name: "light_box.z",
    label: "z",
    help: "The z of the point that the box is measured from.",
    ..PLACE
};

const HALF_WIDTH: Key = Key {
    name: "light_box.half_width",
    label: "half width",
    help: "Half of the box's width, across the light. Texels grow with it.",
    ..SIZE
};

const HALF_HEIGHT: Key = Key {
    name: "light_box.half_height",
    label: "half height",
    help: "Half of the box's height, along the world's up as the light sees it. Texels grow with it.",
    ..SIZE
};

const NEAR: Key = Key {
    name: "light_box.near",
    label: "near",
    help: "How far behind the point the box begins, along the light's way; less than 0 is toward the light. \
           What is nearer to the light casts only where casters are flattened.",
    ..PLACE
};

const DEPTH_RANGE: Key = Key {
    name: "light_box.depth_range",
    label: "depth range",
    help: "How deep the box is along the light's way. What lies deeper is lit; more of it makes steps of depth coarser.",
    ..SIZE
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Fit, Settings};

    #[test]
    fn a_box_that_no_map_holds_is_named() {
        let of = |light_box| Settings { fit: Fit::World, light_box: Some(light_box), ..Settings::default() };
        assert_eq!(of(LightBox::default()).validate(), Ok(()));
        let beyond = [2e9, -2e9, f32::NAN, f32::INFINITY];
        let none = [0.0, -1.0, 2e9, f32::NAN];
        type Set = fn(&mut LightBox) -> &mut f32;
        let fields: [(&str, Set, [f32; 4]); 7] = [
            ("light_box.x", |it| &mut it.x, beyond),
            ("light_box.y", |it| &mut it.y, beyond),
            ("light_box.z", |it| &mut it.z, beyond),
            ("light_box.half_width", |it| &mut it.half_width, none),
            ("light_box.half_height", |it| &mut it.half_height, none),
            ("light_box.near", |it| &mut it.near, beyond),
            ("light_box.depth_range", |it| &mut it.depth_range, none),
        ];
        for (name, field, bad) in fields {
            for value in bad {
                let mut light_box = LightBox::default();
                *field(&mut light_box) = value;
                let refused = of(light_box).validate();
                assert!(
                    matches!(refused, Err(SettingsError::OutOfRange { key, .. }) if key == name),
                    "{name} of {value}: {refused:?}"
                );
            }
        }
    }
}
