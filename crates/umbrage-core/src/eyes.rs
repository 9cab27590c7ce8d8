//! Which camera sees all that two eyes see? One plan for it serves both, and a receiver has the same view whichever eye looks.
//!
//! The eyes look the same way, from two places. The camera stands between them, so far behind that both lie in its frustum; its
//! sides are as steep as those of either. So each eye's frustum lies in it.

use glam::{DVec3, Mat4};

use crate::camera::{Camera, Projection};
use crate::error::CameraError;

/// Axes of two eyes may differ by so much: a display's halves are never glued on quite straight.
const PARALLEL_TOLERANCE: f32 = 1e-4;

impl Camera {
    /// Makes the camera that sees all that two eyes see: what a plan is made for that serves both. It stands behind them, by about
    /// the distance between them, and view depths, the shadow distance among them, count from there.
    ///
    /// # Errors
    /// When an eye is not a perspective camera, or their axes are not parallel.
    pub fn of_eyes(eyes: [&Self; 2]) -> Result<Self, CameraError> {
        let [one, other] = eyes;
        let axes = |eye: &Self| [0, 1, 2].map(|i| eye.world_from_view().col(i).truncate());
        let are_parallel =
            axes(one).into_iter().zip(axes(other)).all(|(a, b)| (a - b).length() < PARALLEL_TOLERANCE);
        let (Some(first), Some(second), true) = (sides(one), sides(other), are_parallel) else {
            return Err(CameraError::Eyes);
        };
        let [right, up, back] = axes(one).map(|axis| axis.as_dvec3());
        let apart = other.eye().as_dvec3() - one.eye().as_dvec3();
        // Where the other eye is, along right, up and forward.
        let [x, y, z] = [right, up, -back].map(|axis| axis.dot(apart));
        let steepest: [f64; 4] = std::array::from_fn(|i| match i % 2 {
            0 => first[i].min(second[i]),
            _ => first[i].max(second[i]),
        });
        let [left, right_side, down, up_side] = steepest;
        // Behind the nearer of both, so far that both lie in the frustum; a little more for what f32 rounds.
        let behind = 1.001 * (x.abs() / (right_side - left)).max(y.abs() / (up_side - down))
            + 1e-4 * f64::from(one.near());
        let depth = behind - z.min(0.0);
        // The middle of where it may stand.
        let aside = |other: f64, low: f64, high: f64| 0.5 * (other - (low + high) * behind);
        let (aside_x, aside_y) = (aside(x, left, right_side), aside(y, down, up_side));
        let eye = one.eye().as_dvec3() + right * aside_x + up * aside_y + back * depth;
        let depths = [depth, depth + z];
        let near = depths[0] + f64::from(one.near());
        let near = near.min(depths[1] + f64::from(other.near()));
        let far = (depths[0] + f64::from(one.far())).max(depths[1] + f64::from(other.far()));
        let world_from_view = with_eye(one.world_from_view(), eye);
        Self::with_sides(
            world_from_view,
            steepest.map(|side| (side * (1.0 + 1e-5)) as f32),
            near as f32,
            far as f32,
        )
    }
}

fn with_eye(world_from_view: Mat4, eye: DVec3) -> Mat4 {
    Mat4 { w_axis: eye.as_vec3().extend(1.0), ..world_from_view }
}

/// The tangents of the angles to the left, right, lower and upper sides of a perspective picture.
fn sides(camera: &Camera) -> Option<[f64; 4]> {
    match camera.projection() {
        Projection::Perspective { .. } => {
            let (half_height, half_width) = camera.half_extents(1.0);
            let [x, y] = camera.centre().map(f64::from);
            let of = |half: f64, centre: f64| [half * (-1.0 - centre), half * (1.0 - centre)];
            let ([left, right], [down, up]) = (of(half_width, x), of(half_height, y));
            Some([left, right, down, up])
        }
        Projection::Orthographic { .. } => None,
    }
}
