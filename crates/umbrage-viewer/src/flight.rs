//! Where the camera is and how the pointer and keys move it: flying, or in orbit around its target.
//!
//! World space, metres, radians. `yaw` 0 looks along −Z and grows to the left; `pitch` grows upward. The horizon stays
//! level.

use glam::{Mat4, Quat, Vec2, Vec3};
use umbrage_scene::Camera;

/// The largest pitch of a view, radians: a little less than straight up or down, where yaw would lose its meaning.
const STEEPEST: f32 = std::f32::consts::FRAC_PI_2 - 0.01;

/// How far a drag over the height of the picture rotates the view, radians.
const ROTATION_PER_HEIGHT: f32 = 2.0;

/// How the camera answers the pointer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Motion {
    /// Dragging rotates the view; keys and the wheel move the eye.
    #[default]
    Fly,
    /// Dragging moves the eye around the target; the wheel zooms.
    Orbit,
}

/// A camera that the pointer and keys move.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    /// How it answers the pointer.
    pub motion: Motion,
    /// Its position, world space.
    pub eye: Vec3,
    yaw: f32,
    pitch: f32,
    /// The distance from the eye to the target, metres.
    pub distance: f32,
    /// The speed at which keys move it, metres a second.
    pub speed: f32,
    /// The scene's camera that gives it lens, depth range and name.
    lens: Camera,
}

impl Motion {
    /// Returns the motion that is not this one.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::Fly => Self::Orbit,
            Self::Orbit => Self::Fly,
        }
    }
}

impl Flight {
    /// Starts at a camera of a scene, with a target that lies `reach` metres ahead.
    pub fn at(camera: &Camera, reach: f32) -> Self {
        let forward = camera.forward();
        let nearest = 2.0 * camera.near;
        let distance = reach.clamp(nearest, camera.far.max(nearest));
        Self {
            motion: Motion::Fly,
            eye: camera.eye(),
            yaw: (-forward.x).atan2(-forward.z),
            pitch: forward.y.clamp(-1.0, 1.0).asin().clamp(-STEEPEST, STEEPEST),
            distance,
            speed: 0.4 * distance,
            lens: camera.clone(),
        }
    }

    /// Returns the flight `elsewhere`, which answers the pointer as this one does.
    #[must_use]
    pub fn moved_to(&self, elsewhere: Self) -> Self {
        Self { motion: self.motion, ..elsewhere }
    }

    /// Returns the direction of view, a unit vector in world space.
    pub fn forward(&self) -> Vec3 {
        self.rotation() * Vec3::NEG_Z
    }

    /// Returns the point that it looks at and orbits, world space.
    pub fn target(&self) -> Vec3 {
        self.eye + self.forward() * self.distance
    }

    fn rotation(&self) -> Quat {
        Quat::from_rotation_y(self.yaw) * Quat::from_rotation_x(self.pitch)
    }

    /// Returns it as a camera of a scene.
    pub fn camera(&self) -> Camera {
        let world_from_camera = Mat4::from_rotation_translation(self.rotation(), self.eye);
        Camera { world_from_camera, ..self.lens.clone() }
    }

    /// Rotates the view, or orbits, after a drag of `by` heights of the picture.
    pub fn drag(&mut self, by: Vec2) {
        match self.motion {
            Motion::Fly => self.rotate(-by * ROTATION_PER_HEIGHT),
            Motion::Orbit => {
                let target = self.target();
                self.rotate(-by * ROTATION_PER_HEIGHT);
                self.eye = target - self.forward() * self.distance;
            }
        }
    }

    fn rotate(&mut self, by: Vec2) {
        self.yaw = (self.yaw + by.x) % std::f32::consts::TAU;
        self.pitch = (self.pitch + by.y).clamp(-STEEPEST, STEEPEST);
    }

    /// Moves the eye sideways so that the target follows a drag of `by` heights of the picture.
    pub fn pan(&mut self, by: Vec2) {
        let rotation = self.rotation();
        self.eye += (rotation * Vec3::new(-by.x, by.y, 0.0)) * self.distance;
    }

    /// Moves ahead, or in orbit nearer to the target, by `notches` of the wheel.
    pub fn zoom(&mut self, notches: f32) {
        match self.motion {
            Motion::Fly => self.eye += self.forward() * self.speed * 0.25 * notches,
            Motion::Orbit => {
                let target = self.target();
                let (near, far) = (2.0 * self.lens.near, self.lens.far);
                self.distance = (self.distance * 0.9f32.powf(notches)).clamp(near, far.max(near));
                self.eye = target - self.forward() * self.distance;
            }
        }
    }

    /// Moves for `seconds` in the direction of the keys: right, up and ahead, each from −1 to 1.
    pub fn fly(&mut self, keys: Vec3, seconds: f32) {
        let rotation = self.rotation();
        let direction = rotation * Vec3::new(keys.x, 0.0, -keys.z) + Vec3::Y * keys.y;
        self.eye += direction * self.speed * seconds;
    }

    /// Takes position and rotation of a point of a camera path.
    pub fn follow(&mut self, world_from_camera: Mat4) {
        let camera = Camera { world_from_camera, ..self.lens.clone() };
        *self = Self { motion: self.motion, speed: self.speed, ..Self::at(&camera, self.distance) };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flight() -> Flight {
        let camera =
            Camera::looking("c", Vec3::new(1.0, 2.0, 3.0), Vec3::new(5.0, 1.0, -4.0), 1.0, 0.1, 100.0);
        Flight::at(&camera, 8.0)
    }

    #[test]
    fn a_camera_comes_back_as_it_went_in() {
        let camera =
            Camera::looking("c", Vec3::new(1.0, 2.0, 3.0), Vec3::new(5.0, 1.0, -4.0), 1.0, 0.1, 100.0);
        let back = Flight::at(&camera, 8.0).camera();
        assert!(back.world_from_camera.abs_diff_eq(camera.world_from_camera, 1e-5), "{back:?}");
        assert_eq!((back.lens, back.near, back.far), (camera.lens, camera.near, camera.far));
    }

    #[test]
    fn a_camera_that_sees_next_to_no_depth_can_be_flown() {
        let camera = Camera::looking("c", Vec3::ZERO, Vec3::X, 1.0, 1.0, 1.5);
        let mut flight = Flight { motion: Motion::Orbit, ..Flight::at(&camera, 100.0) };
        flight.zoom(3.0);
        assert!(flight.camera().world_from_camera.is_finite() && flight.distance == 2.0, "{flight:?}");
    }

    #[test]
    fn in_orbit_the_eye_moves_and_what_it_looks_at_stays() {
        let mut flight = Flight { motion: Motion::Orbit, ..flight() };
        let (eye, target) = (flight.eye, flight.target());
        flight.drag(Vec2::new(0.3, 0.1));
        flight.zoom(2.0);
        assert!(flight.target().distance(target) < 1e-4, "{:?}", flight.target());
        assert!(flight.eye.distance(eye) > 1.0);
        assert!((flight.distance - 8.0 * 0.81).abs() < 1e-4);
    }

    #[test]
    fn flying_ahead_goes_where_it_looks_and_dragging_rotates_on_the_spot() {
        let mut flight = flight();
        let (eye, forward) = (flight.eye, flight.forward());
        flight.fly(Vec3::Z, 0.5);
        assert!((flight.eye - eye).abs_diff_eq(forward * flight.speed * 0.5, 1e-4));
        let eye = flight.eye;
        flight.drag(Vec2::new(0.0, -10.0));
        assert_eq!(flight.eye, eye);
        assert!(flight.pitch <= STEEPEST && flight.forward().y > 0.99, "up, and never over");
    }
}
