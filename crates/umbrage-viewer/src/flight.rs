//! Where the eye is and how people move it: flying, or in orbit around what it looks at.
//!
//! World space, metres, radians. `yaw` 0 looks along −Z and grows to the left; `pitch` grows upward. The horizon stays
//! level.

use glam::{Mat4, Quat, Vec2, Vec3};
use umbrage_scene::Camera;

/// How far from straight up or down a view stays, radians.
const STEEPEST: f32 = std::f32::consts::FRAC_PI_2 - 0.01;

/// Radians for each height of the picture that the pointer is dragged.
const TURN: f32 = 2.0;

/// How the eye answers the pointer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Motion {
    /// Dragging turns the view; keys and the wheel move the eye.
    #[default]
    Fly,
    /// Dragging moves the eye around what it looks at; the wheel goes nearer.
    Orbit,
}

/// A camera that people move.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    /// How it answers.
    pub motion: Motion,
    /// Where it is.
    pub eye: Vec3,
    yaw: f32,
    pitch: f32,
    /// How far away what it looks at is, metres.
    pub distance: f32,
    /// How fast keys move it, metres a second.
    pub speed: f32,
    /// Its lens and depth range, and the name it has.
    lens: Camera,
}

impl Flight {
    /// From a camera of a scene, `reach` metres from what it looks at.
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

    /// At another place that a camera of the scene has; it answers the pointer as before.
    #[must_use]
    pub fn moved_to(&self, elsewhere: Self) -> Self {
        Self { motion: self.motion, ..elsewhere }
    }

    /// The way it looks, unit.
    pub fn forward(&self) -> Vec3 {
        self.rotation() * Vec3::NEG_Z
    }

    /// What it looks at.
    pub fn target(&self) -> Vec3 {
        self.eye + self.forward() * self.distance
    }

    fn rotation(&self) -> Quat {
        Quat::from_rotation_y(self.yaw) * Quat::from_rotation_x(self.pitch)
    }

    /// As a scene's camera.
    pub fn camera(&self) -> Camera {
        let world_from_camera = Mat4::from_rotation_translation(self.rotation(), self.eye);
        Camera { world_from_camera, ..self.lens.clone() }
    }

    /// The pointer was dragged, in heights of the picture.
    pub fn drag(&mut self, by: Vec2) {
        match self.motion {
            Motion::Fly => self.turn(-by * TURN),
            Motion::Orbit => {
                let target = self.target();
                self.turn(-by * TURN);
                self.eye = target - self.forward() * self.distance;
            }
        }
    }

    fn turn(&mut self, by: Vec2) {
        self.yaw = (self.yaw + by.x) % std::f32::consts::TAU;
        self.pitch = (self.pitch + by.y).clamp(-STEEPEST, STEEPEST);
    }

    /// The picture was dragged aside with two fingers or the other button, in heights of the picture: what is looked at
    /// follows.
    pub fn pan(&mut self, by: Vec2) {
        let rotation = self.rotation();
        self.eye += (rotation * Vec3::new(-by.x, by.y, 0.0)) * self.distance;
    }

    /// The wheel turned by `notches`, or two fingers came apart: ahead, or nearer to what is looked at.
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

    /// Keys were held for `seconds`: to the right, upward, and ahead, each from −1 to 1.
    pub fn fly(&mut self, keys: Vec3, seconds: f32) {
        let rotation = self.rotation();
        let way = rotation * Vec3::new(keys.x, 0.0, -keys.z) + Vec3::Y * keys.y;
        self.eye += way * self.speed * seconds;
    }

    /// Takes the place of a point of a path: where it is and how it looks.
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
    fn flying_ahead_goes_where_it_looks_and_dragging_turns_on_the_spot() {
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
