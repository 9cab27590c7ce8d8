//! Which camera sees all that two eyes see? One plan for it serves both, and a receiver has the same view whichever eye looks.
//!
//! The eyes look the same way, from two places. The camera stands between them, so far behind that both lie in its frustum, and the
//! rays to the corners of both pictures lie between its sides. So each eye's frustum lies in it.

use glam::{DMat3, DVec2, DVec3, Mat4};

use crate::camera::{Camera, Projection};
use crate::error::CameraError;

/// Axes of two eyes may differ by so much: a display's halves are never glued on quite straight.
const PARALLEL_TOLERANCE: f32 = 1e-4;

impl Camera {
    /// Makes the camera that sees all that two eyes see: what a plan is made for that serves both. It stands behind them, by about
    /// the distance between them over the width of their pictures at a view depth of 1 (the difference of the tangents to the right and to
    /// the left), and view depths, the shadow distance among them, count from there.
    ///
    /// # Errors
    /// When an eye is not a perspective camera, or their axes are not parallel.
    pub fn of_eyes(eyes: [&Self; 2]) -> Result<Self, CameraError> {
        let [one, other] = eyes;
        let is_perspective = |eye: &&Self| matches!(eye.projection(), Projection::Perspective { .. });
        if !eyes.iter().all(is_perspective) || !are_parallel(one, other) {
            return Err(CameraError::Eyes);
        }
        // Right, up and back of the one eye are the axes in what follows.
        let world_from_axes = DMat3::from_mat4(one.world_from_view().as_dmat4());
        let axes_from_world = world_from_axes.inverse();
        let rays = eyes.map(|eye| rays(eye).map(|ray| axes_from_world * ray));
        let tangents = || rays.iter().flatten().map(|ray| ray.truncate() / -ray.z);
        let low = tangents().reduce(DVec2::min).unwrap_or_default();
        let high = tangents().reduce(DVec2::max).unwrap_or_default();
        let apart = axes_from_world * (other.eye().as_dvec3() - one.eye().as_dvec3());
        // Behind the nearer of both, so far that both lie in the frustum; a little more for what f32 rounds.
        let behind =
            1.001 * (apart.truncate().abs() / (high - low)).max_element() + 1e-4 * f64::from(one.near());
        let depth = behind + apart.z.max(0.0);
        // The middle of where it may stand.
        let aside = 0.5 * (apart.truncate() - (low + high) * behind);
        let eye = one.eye().as_dvec3() + world_from_axes * aside.extend(depth);
        let depths = [depth, depth - apart.z];
        let ends = |i: usize| {
            let along = rays[i].map(|ray| -ray.z);
            let near = f64::from(eyes[i].near()) * along.into_iter().fold(f64::INFINITY, f64::min);
            let far = f64::from(eyes[i].far()) * along.into_iter().fold(0.0, f64::max);
            [depths[i] + near, depths[i] + far]
        };
        let [[near, far], [other_near, other_far]] = [ends(0), ends(1)];
        Self::with_sides(
            Mat4 { w_axis: eye.as_vec3().extend(1.0), ..one.world_from_view() },
            [low.x, high.x, low.y, high.y].map(|side| (side * (1.0 + 1e-5)) as f32),
            near.min(other_near) as f32,
            far.max(other_far) as f32,
        )
    }
}

fn are_parallel(one: &Camera, other: &Camera) -> bool {
    let axes = |eye: &Camera| [0, 1, 2].map(|i| eye.world_from_view().col(i).truncate());
    axes(one).into_iter().zip(axes(other)).all(|(a, b)| (a - b).length() < PARALLEL_TOLERANCE)
}

/// What leads from an eye to the corners of its picture, at a view depth of 1, in world space.
fn rays(eye: &Camera) -> [DVec3; 4] {
    let [a, b, c, d, ..] = eye.slice_corners(1.0..1.0);
    [a, b, c, d].map(|corner| corner - eye.eye().as_dvec3())
}
