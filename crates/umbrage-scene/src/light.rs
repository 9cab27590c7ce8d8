//! What lights a world, as `KHR_lights_punctual` describes it.

use glam::{Mat4, Vec3};

use crate::camera::world_from_looking;

/// A light and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// What the file or the world calls it.
    pub name: String,
    /// Rigid: the light shines down its own −Z.
    pub world_from_light: Mat4,
    /// Linear RGB, 0 to 1.
    pub colour: Vec3,
    /// Lux for directional lights, candela for spot and point lights.
    pub intensity: f32,
    /// Its shape.
    pub kind: LightKind,
}

/// The shapes of light that glTF knows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// Parallel rays, as from the sun.
    Directional,
    /// A cone; half angles in radians, range in metres (infinite where the file gives none).
    Spot {
        /// Half the angle inside which the light is at full strength, radians.
        inner: f32,
        /// Half the angle outside which there is no light, radians.
        outer: f32,
        /// Reach, metres.
        range: f32,
    },
    /// All directions; range in metres (infinite where the file gives none).
    Point {
        /// Reach, metres.
        range: f32,
    },
}

impl Light {
    /// A sun whose light travels along `direction` (any length), with white light of `intensity` lux.
    pub fn sun(direction: Vec3, intensity: f32) -> Self {
        Self {
            name: "sun".to_owned(),
            world_from_light: world_from_looking(Vec3::ZERO, direction),
            colour: Vec3::ONE,
            intensity,
            kind: LightKind::Directional,
        }
    }

    /// The unit direction in which the light shines, in world space.
    pub fn direction(&self) -> Vec3 {
        -self.world_from_light.z_axis.truncate()
    }

    /// Where the light stands, in world space; without meaning for a directional light.
    pub fn position(&self) -> Vec3 {
        self.world_from_light.w_axis.truncate()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sun_shines_the_way_it_was_told_even_straight_down() {
        for direction in [Vec3::NEG_Y, Vec3::new(0.3, -1.0, -0.4), Vec3::X] {
            let along = Light::sun(direction, 1.0).direction();
            assert!((along - direction.normalize_or_zero()).length() < 1e-6, "{direction} gave {along}");
        }
    }
}
