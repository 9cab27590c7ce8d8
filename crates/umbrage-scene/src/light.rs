//! What lights a world, as `KHR_lights_punctual` describes it.

use glam::{Mat4, Vec3};

use crate::Motion;
use crate::camera::world_from_looking;

/// A light and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// What the file or the world calls it.
    pub name: String,
    /// Where it stands at time 0. Rigid: the light shines down its own −Z.
    pub world_from_light: Mat4,
    /// Linear RGB, 0 to 1.
    pub colour: Vec3,
    /// Lux for directional lights, candela for spot and point lights: a surface that faces one of `intensity` candela
    /// at `distance` gets `intensity / distance²` lux. [`crate::worlds`] says what is bright.
    pub intensity: f32,
    /// Its shape.
    pub kind: LightKind,
    /// How it moves from where it stands at time 0.
    pub motion: Motion,
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
            motion: Motion::Still,
        }
    }

    /// A white cone of light from `eye` towards `target`, both in world space. At full strength to `inner_radians` from
    /// the middle of the cone, dark from `outer_radians` on (half angles, 0 ≤ inner < outer < π/2), and dark beyond
    /// `range` metres.
    pub fn spot(
        name: &str,
        eye: Vec3,
        target: Vec3,
        inner_radians: f32,
        outer_radians: f32,
        range: f32,
        candela: f32,
    ) -> Self {
        Self {
            name: name.to_owned(),
            world_from_light: world_from_looking(eye, target),
            colour: Vec3::ONE,
            intensity: candela,
            kind: LightKind::Spot { inner: inner_radians, outer: outer_radians, range },
            motion: Motion::Still,
        }
    }

    /// A white light that shines from `position`, in world space, in all directions; dark beyond `range` metres.
    pub fn point(name: &str, position: Vec3, range: f32, candela: f32) -> Self {
        Self {
            name: name.to_owned(),
            world_from_light: Mat4::from_translation(position),
            colour: Vec3::ONE,
            intensity: candela,
            kind: LightKind::Point { range },
            motion: Motion::Still,
        }
    }

    /// Where it stands `seconds` after the start; exactly [`Self::world_from_light`] at 0.
    pub fn world_from_light_at(&self, seconds: f32) -> Mat4 {
        self.motion.moved(self.world_from_light, seconds)
    }

    /// The unit direction in which the light shines at time 0, in world space.
    pub fn direction(&self) -> Vec3 {
        -self.world_from_light.z_axis.truncate()
    }

    /// Where the light stands at time 0, in world space; without meaning for a directional light.
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

    #[test]
    fn a_spot_stands_at_its_eye_and_shines_at_its_target() {
        let spot = Light::spot("s", Vec3::new(1.0, 6.0, 0.0), Vec3::X, 0.1, 0.2, 9.0, 5.0);
        assert_eq!(spot.position(), Vec3::new(1.0, 6.0, 0.0));
        assert!((spot.direction() - Vec3::NEG_Y).length() < 1e-6, "{}", spot.direction());
        assert_eq!(spot.kind, LightKind::Spot { inner: 0.1, outer: 0.2, range: 9.0 });
    }

    #[test]
    fn a_point_light_stands_where_it_was_told() {
        assert_eq!(Light::point("p", Vec3::ONE, 4.0, 2.0).position(), Vec3::ONE);
    }
}
