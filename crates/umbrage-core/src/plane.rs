//! Planes that bound half-spaces, and the six of a clip matrix.

use glam::{DVec3, Mat4, Vec3};

/// A half-space in world space: a point p lies inside where `normal · p + distance ≥ 0`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// The unit normal, which points inward.
    pub normal: Vec3,
    /// The signed distance of the world's origin, metres: positive where that lies inside.
    pub distance: f32,
}

impl Plane {
    /// The signed distance of `point`, metres: positive inside.
    pub fn signed_distance(&self, point: Vec3) -> f32 {
        self.normal.dot(point) + self.distance
    }

    /// The signed distance of the corner of a box that lies farthest in, metres; of the one farthest out where the two are
    /// exchanged.
    pub(crate) fn farthest_in(&self, min: Vec3, max: Vec3) -> f32 {
        self.signed_distance(Vec3::select(self.normal.cmpge(Vec3::ZERO), max, min))
    }

    /// Gives the six planes of a clip matrix with depth 0…1, forward or reversed: left, right, bottom, top, and the two
    /// depth planes. They are the *rows* of the matrix (Ferko 2010 §1.2.1 says columns, which holds for row vectors). Planes
    /// at infinity have no normal and are left out.
    pub fn of_clip(clip_from_world: &Mat4) -> impl Iterator<Item = Self> {
        let [x, y, z, w] = [0, 1, 2, 3].map(|i| clip_from_world.row(i));
        [w + x, w - x, w + y, w - y, z, w - z].into_iter().filter_map(|row| {
            let length = row.truncate().length();
            (length > 1e-12).then(|| Self { normal: row.truncate() / length, distance: row.w / length })
        })
    }
}

/// The same in f64, for the planner's own sums.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PlaneF64 {
    pub normal: DVec3,
    pub distance: f64,
}

impl PlaneF64 {
    pub fn through(point: DVec3, normal: DVec3) -> Self {
        Self { normal, distance: -normal.dot(point) }
    }

    pub fn signed_distance(&self, point: DVec3) -> f64 {
        self.normal.dot(point) + self.distance
    }

    /// Rounded to f32, and moved outward by `margin` metres. What is farther than any f32 is as far as the largest.
    pub fn widened(&self, margin: f64) -> Plane {
        let distance = (self.distance + margin).clamp(f64::from(f32::MIN), f64::from(f32::MAX));
        Plane { normal: self.normal.as_vec3(), distance: distance as f32 }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{Camera, Projection};

    proptest! {
        #[test]
        fn a_point_is_inside_all_planes_where_it_is_inside_clip_space(
            x in -30.0f32..30.0, y in -30.0f32..30.0, z in -30.0f32..30.0, aspect in 0.5f32..2.0,
        ) {
            let projection = Projection::Perspective { fov_y: 1.2, aspect };
            let camera = Camera::looking(Vec3::ONE, Vec3::new(4.0, 0.0, -9.0), Vec3::Y, projection, 0.5, 40.0).unwrap();
            let matrix = camera.clip_from_world();
            let point = Vec3::new(x, y, z);
            let clip = matrix * point.extend(1.0);
            let margin = [clip.w + clip.x, clip.w - clip.x, clip.w + clip.y, clip.w - clip.y, clip.z, clip.w - clip.z]
                .into_iter().fold(f32::INFINITY, f32::min);
            prop_assume!(margin.abs() > 1e-3);
            let inside = Plane::of_clip(&matrix).all(|plane| plane.signed_distance(point) >= 0.0);
            prop_assert_eq!(inside, margin > 0.0);
        }
    }
}
