//! What lights a world, as `KHR_lights_punctual` describes it.

use glam::{DMat4, Mat4, Vec3};

use crate::camera::world_from_looking;
use crate::rigid::rigid;
use crate::{Motion, Pose};

/// A light of a scene, with its place and its motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// The name that the file or the world gives the light.
    pub name: String,
    /// The light's rigid transform at time 0: the light shines down its own −Z.
    pub world_from_light: Mat4,
    /// The colour as linear RGB, each 0 to 1.
    pub colour: Vec3,
    /// The intensity, in lux for directional lights and in candela for spot and point lights: a surface that faces a light of
    /// `intensity` candela at `distance` gets `intensity / distance²` lux. [`crate::worlds`] says what is bright.
    pub intensity: f32,
    /// The kind of the light.
    pub kind: LightKind,
    /// The distance from a spot or point light, in metres, nearer than which nothing casts a shadow: a lamp stands inside
    /// its bulb. It is half the side of a cube around a point light, along the world's axes, and a depth along a spot's axis.
    /// 0 where the file says nothing.
    pub near: f32,
    /// The motion of the light from where it stands at time 0.
    pub motion: Motion,
}

/// The kinds of light that glTF knows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// The light's rays are parallel, as those of the sun.
    Directional,
    /// The light shines within a cone.
    Spot {
        /// Half the angle of the inner cone, in radians, within which the light is at full strength.
        inner: f32,
        /// Half the angle of the outer cone, in radians, outside which there is no light.
        outer: f32,
        /// The distance at which light ends, in metres; infinite where the file gives none.
        range: f32,
    },
    /// The light shines in all directions.
    Point {
        /// The distance at which light ends, in metres; infinite where the file gives none.
        range: f32,
    },
}

impl Light {
    /// Makes a sun whose light travels along `direction`, of any length, with white light of `intensity` lux.
    pub fn sun(direction: Vec3, intensity: f32) -> Self {
        Self {
            name: "sun".to_owned(),
            world_from_light: world_from_looking(Vec3::ZERO, direction),
            colour: Vec3::ONE,
            intensity,
            kind: LightKind::Directional,
            near: 0.0,
            motion: Motion::Still,
        }
    }

    /// Makes a white spot light at `eye` that shines towards `target`, both in world space. It is at full strength to
    /// `inner_radians` from the middle of the cone and dark from `outer_radians` on (half angles, 0 ≤ inner < outer < π/2),
    /// and dark beyond `range` metres.
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
            near: 0.0,
            motion: Motion::Still,
        }
    }

    /// Makes a white light that shines from `position`, in world space, in all directions, and is dark beyond `range` metres.
    pub fn point(name: &str, position: Vec3, range: f32, candela: f32) -> Self {
        Self {
            name: name.to_owned(),
            world_from_light: Mat4::from_translation(position),
            colour: Vec3::ONE,
            intensity: candela,
            kind: LightKind::Point { range },
            near: 0.0,
            motion: Motion::Still,
        }
    }

    /// Returns where the light stands in a pose; exactly [`Self::world_from_light`] at 0 s where no rig moves it. It is rigid
    /// even where the rig's nodes are scaled.
    pub fn world_from_light_in(&self, pose: &Pose) -> Mat4 {
        match self.motion {
            Motion::Node { node, node_from_thing } => {
                let moved = pose.world_from_node(node) * node_from_thing.as_dmat4();
                let place = DMat4::from_translation(moved.w_axis.truncate());
                rigid(moved).unwrap_or(place).as_mat4()
            }
            Motion::Still | Motion::Rotation { .. } | Motion::Skin { .. } => {
                self.motion.moved(self.world_from_light, pose)
            }
        }
    }

    /// Returns whether the light shines in a pose: it does not while the node that it hangs on is hidden.
    pub fn is_visible_in(&self, pose: &Pose) -> bool {
        match self.motion {
            Motion::Node { node, .. } | Motion::Skin { node } => pose.is_visible(node),
            Motion::Still | Motion::Rotation { .. } => true,
        }
    }

    /// Returns the unit direction in which the light shines at time 0, in world space.
    pub fn direction(&self) -> Vec3 {
        -self.world_from_light.z_axis.truncate()
    }

    /// Returns the light's position at time 0, in world space; it has no meaning for a directional light.
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
