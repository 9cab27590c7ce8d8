//! Pixels and texels change from one point of the world to the next; this file says by how much.
//!
//! Source: the quotient rule on rows of the projection; no difference quotients, which fail across edges (derived).
//!
//! Space: world, metres; pixels and texels are counted to the right and down.

use glam::{DMat2, DMat4, DVec3, DVec4};

use crate::camera::{Camera, Projection};

/// A projection of the world onto pixels or texels: x is (x · p) / (w · p), and y likewise, for p = (position, 1).
/// Where the raster begins does not matter here.
pub(super) struct Raster {
    x: DVec4,
    y: DVec4,
    w: DVec4,
}

impl Raster {
    pub(super) fn of_camera(camera: &Camera, width: u32, height: u32) -> Self {
        // The camera's own matrices are f32, and lose the picture far from the origin.
        let view_from_world = camera.world_from_view().as_dmat4().inverse();
        let (half_height, half_width) = camera.half_extents(1.0);
        let w = match camera.projection() {
            Projection::Perspective { .. } => -view_from_world.row(2),
            Projection::Orthographic { .. } => DVec4::W,
        };
        Self {
            x: view_from_world.row(0) * (0.5 * f64::from(width) / half_width),
            y: view_from_world.row(1) * (-0.5 * f64::from(height) / half_height),
            w,
        }
    }

    pub(super) fn of_view(clip_from_world: &DMat4, resolution: f64) -> Self {
        Self {
            x: clip_from_world.row(0) * (0.5 * resolution),
            y: clip_from_world.row(1) * (-0.5 * resolution),
            w: clip_from_world.row(3),
        }
    }

    /// Returns the change of x and y, a metre along each of two directions; `None` where w is not positive.
    pub(super) fn jacobian(&self, position: DVec3, (a, b): (DVec3, DVec3)) -> Option<DMat2> {
        let Self { x, y, w } = *self;
        let (x, y) = (gradient(x, w, position), gradient(y, w, position));
        let is_before = w.dot(position.extend(1.0)) > 0.0;
        is_before.then(|| DMat2::from_cols_array(&[x.dot(a), y.dot(a), x.dot(b), y.dot(b)]))
    }

    /// Unit direction to the light: x and y stay along it, and the reversed depth that `depth` gives grows.
    pub(super) fn direction_to_light(&self, depth: DVec4, position: DVec3) -> Option<DVec3> {
        let Self { x, y, w } = *self;
        let ray = gradient(x, w, position).cross(gradient(y, w, position));
        let nearer = gradient(depth, w, position).dot(ray);
        if nearer == 0.0 { None } else { (ray * nearer.signum()).try_normalize() }
    }
}

/// Returns the change of (x · p) / (w · p), a metre along each axis of the world: the quotient rule.
fn gradient(x: DVec4, w: DVec4, position: DVec3) -> DVec3 {
    let p = position.extend(1.0);
    let at = w.dot(p);
    (x.truncate() * at - w.truncate() * x.dot(p)) / (at * at)
}
