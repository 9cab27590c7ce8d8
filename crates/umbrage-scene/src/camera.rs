//! Where a world is seen from: single cameras, and a path that a camera follows.

use glam::{Mat4, Vec3};

/// A camera is a place to see the world from, as a glTF camera node has it. The aspect ratio belongs to the picture, and not
/// to the camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// The name that the file or the world gives the camera.
    pub name: String,
    /// The camera's rigid transform: the columns are right, up, back and eye, in world space.
    pub world_from_camera: Mat4,
    /// The lens, which says how the camera projects.
    pub lens: Lens,
    /// The view depth of the nearest thing that is visible, in metres.
    pub near: f32,
    /// The view depth of the farthest thing that is visible, in metres.
    pub far: f32,
}

/// A lens says how a camera projects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lens {
    /// All rays meet in the eye.
    Perspective {
        /// The whole vertical field of view, in radians.
        fov_y: f32,
    },
    /// The rays are parallel.
    Orthographic {
        /// Half the height of the visible box, in metres.
        half_height: f32,
    },
}

impl Camera {
    /// Makes a perspective camera at `eye` that looks at `target` with world Y up, or world Z where the view is vertical.
    /// `fov_y` is the whole vertical field of view in radians, `near` and `far` are view depths in metres.
    pub fn looking(name: &str, eye: Vec3, target: Vec3, fov_y: f32, near: f32, far: f32) -> Self {
        Self {
            name: name.to_owned(),
            world_from_camera: world_from_looking(eye, target),
            lens: Lens::Perspective { fov_y },
            near,
            far,
        }
    }

    /// Returns where the camera stands, in world space.
    pub fn eye(&self) -> Vec3 {
        self.world_from_camera.w_axis.truncate()
    }

    /// Returns the unit direction of view, in world space.
    pub fn forward(&self) -> Vec3 {
        -self.world_from_camera.z_axis.truncate()
    }
}

/// The rigid transform of an observer at `eye` who looks at `target`: looking down its own −Z, with world Y up, or
/// world Z up where the view is within 8° of vertical. Looks down world −Z where `eye` and `target` coincide.
pub(crate) fn world_from_looking(eye: Vec3, target: Vec3) -> Mat4 {
    let forward = (target - eye).try_normalize().unwrap_or(Vec3::NEG_Z);
    let helper = if forward.y.abs() > 0.99 { Vec3::Z } else { Vec3::Y };
    let right = forward.cross(helper).normalize_or(Vec3::X);
    let up = right.cross(forward);
    Mat4::from_cols(right.extend(0.0), up.extend(0.0), (-forward).extend(0.0), eye.extend(1.0))
}

/// A camera path is a deterministic flight along a Catmull-Rom curve through its keys.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CameraPath {
    /// The places that the curve goes through, evenly spaced in time. The list is empty where a world has no path.
    pub keys: Vec<PathKey>,
}

/// A key is one place on a [`CameraPath`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathKey {
    /// The camera's position, in world space.
    pub eye: Vec3,
    /// The point that the camera looks at, in world space.
    pub target: Vec3,
}

impl CameraPath {
    /// Returns the camera's rigid transform at share `t`, 0 to 1, of the path; `None` for a path without keys.
    pub fn world_from_camera(&self, t: f32) -> Option<Mat4> {
        let last = self.keys.len().checked_sub(1)?;
        let along = t.clamp(0.0, 1.0) * last as f32;
        let segment = (along as usize).min(last.saturating_sub(1));
        let share = along - segment as f32;
        let key = |offset: isize| &self.keys[segment.saturating_add_signed(offset).min(last)];
        let (a, b, c, d) = (key(-1), key(0), key(1), key(2));
        let eye = catmull_rom([a.eye, b.eye, c.eye, d.eye], share);
        let target = catmull_rom([a.target, b.target, c.target, d.target], share);
        Some(world_from_looking(eye, target))
    }
}

/// The uniform Catmull-Rom curve from `p[1]` (share 0) to `p[2]` (share 1).
fn catmull_rom(p: [Vec3; 4], share: f32) -> Vec3 {
    let (t, t2, t3) = (share, share * share, share * share * share);
    0.5 * (2.0 * p[1]
        + (p[2] - p[0]) * t
        + (2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3]) * t2
        + (3.0 * p[1] - p[0] - 3.0 * p[2] + p[3]) * t3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_looking_camera_sees_its_target_straight_ahead() {
        let camera =
            Camera::looking("c", Vec3::new(1.0, 2.0, 3.0), Vec3::new(1.0, 2.0, -7.0), 1.0, 0.1, 10.0);
        assert_eq!(camera.eye(), Vec3::new(1.0, 2.0, 3.0));
        assert!((camera.forward() - Vec3::NEG_Z).length() < 1e-6, "{:?}", camera.forward());
    }

    #[test]
    fn a_path_starts_and_ends_on_its_outer_keys() {
        let key = |x: f32| PathKey { eye: Vec3::new(x, 1.0, 0.0), target: Vec3::new(x, 1.0, -5.0) };
        let path = CameraPath { keys: vec![key(0.0), key(3.0), key(4.0)] };
        let eye_at = |t: f32| path.world_from_camera(t).unwrap().w_axis.truncate();
        assert_eq!(eye_at(0.0), path.keys[0].eye);
        assert!((eye_at(0.5) - path.keys[1].eye).length() < 1e-5, "the middle key is on the path");
        assert!((eye_at(1.0) - path.keys[2].eye).length() < 1e-5, "the last key is on the path");
        assert_eq!(CameraPath::default().world_from_camera(0.5), None);
    }
}
