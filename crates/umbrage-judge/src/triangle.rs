//! Does a ray hit a triangle? Watertight: a ray at a shared edge or corner never slips between its triangles.
//!
//! Source: Woop, Benthin, Wald, *Watertight Ray/Triangle Intersection*, JCGT 2:1, 2013, in f64 throughout. The edge
//! functions of a shared edge are the same numbers with opposite signs, which is what makes it watertight.

use glam::DVec3;

/// A ray is a half-line, prepared for triangle tests.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// The point in world space where the ray begins, in metres.
    pub origin: DVec3,
    /// The direction of the ray. Distances along it are multiples of this vector, which need not be unit.
    pub direction: DVec3,
    /// The axes in the order x, y, z of the ray's own space, in which it runs along z.
    axes: [usize; 3],
    shear: DVec3,
}

impl Ray {
    /// Prepares a ray; `direction` must not be zero.
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        let size = direction.abs();
        let z = if size.x >= size.y && size.x >= size.z {
            0
        } else if size.y >= size.z {
            1
        } else {
            2
        };
        // A negative main direction swaps the others, which keeps the winding.
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let (x, y) = if direction[z] < 0.0 { (y, x) } else { (x, y) };
        let shear = DVec3::new(direction[x] / direction[z], direction[y] / direction[z], 1.0 / direction[z]);
        Self { origin, direction, axes: [x, y, z], shear }
    }

    /// Returns the point at a distance along the ray, in multiples of its direction.
    pub fn at(&self, distance: f64) -> DVec3 {
        self.origin + self.direction * distance
    }

    /// Returns the distance along the ray at which it hits the triangle, from either side; `None` where it misses, or the
    /// triangle lies behind its origin.
    pub fn hit(&self, triangle: &[DVec3; 3]) -> Option<f64> {
        self.meet(triangle).map(|(distance, _)| distance)
    }

    /// How much each corner of a triangle counts where the ray hits it; the first alone where it misses.
    pub(crate) fn weights(&self, triangle: &[DVec3; 3]) -> [f64; 3] {
        self.meet(triangle).map_or([1.0, 0.0, 0.0], |(_, weights)| weights)
    }

    /// The distance, and how much each corner counts there.
    #[inline]
    fn meet(&self, triangle: &[DVec3; 3]) -> Option<(f64, [f64; 3])> {
        let [x, y, z] = self.axes;
        let [a, b, c] = triangle.map(|corner| {
            let from_origin = corner - self.origin;
            let along = from_origin[z];
            let sheared = [from_origin[x] - self.shear.x * along, from_origin[y] - self.shear.y * along];
            (sheared, self.shear.z * along)
        });
        let edge = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
        let (u, v, w) = (edge(c.0, b.0), edge(a.0, c.0), edge(b.0, a.0));
        let (any_negative, any_positive) = (u < 0.0 || v < 0.0 || w < 0.0, u > 0.0 || v > 0.0 || w > 0.0);
        let determinant = u + v + w;
        if any_negative && any_positive || determinant == 0.0 {
            return None;
        }
        let distance = (u * a.1 + v * b.1 + w * c.1) / determinant;
        (distance >= 0.0).then(|| (distance, [u, v, w].map(|edge| edge / determinant)))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const TRIANGLE: [DVec3; 3] = [DVec3::ZERO, DVec3::X, DVec3::Y];

    #[test]
    fn a_ray_along_z_hits_the_triangle_at_its_height_from_both_sides() {
        for (z, direction) in [(3.0, -1.0), (-3.0, 1.0), (3.0, -2.0)] {
            let ray = Ray::new(DVec3::new(0.25, 0.25, z), DVec3::Z * direction);
            assert_eq!(ray.hit(&TRIANGLE), Some(3.0 / f64::abs(direction)));
        }
        assert_eq!(Ray::new(DVec3::new(0.6, 0.6, 3.0), DVec3::NEG_Z).hit(&TRIANGLE), None, "beside it");
        assert_eq!(Ray::new(DVec3::new(0.25, 0.25, 3.0), DVec3::Z).hit(&TRIANGLE), None, "behind");
        assert_eq!(Ray::new(DVec3::new(0.25, 0.25, 3.0), DVec3::X).hit(&TRIANGLE), None, "parallel");
    }

    #[test]
    fn corners_count_the_more_the_nearer_they_are() {
        let ray = Ray::new(DVec3::new(0.25, 0.5, 3.0), DVec3::NEG_Z);
        assert_eq!(ray.weights(&TRIANGLE), [0.25, 0.25, 0.5]);
        let turned = [TRIANGLE[0], TRIANGLE[2], TRIANGLE[1]];
        assert_eq!(ray.weights(&turned), [0.25, 0.5, 0.25], "the other way round");
        let beside = Ray::new(DVec3::new(2.0, 0.5, 3.0), DVec3::NEG_Z);
        assert_eq!(beside.weights(&TRIANGLE), [1.0, 0.0, 0.0]);
    }

    proptest! {
        #[test]
        fn a_ray_through_a_point_of_a_shared_edge_hits_one_of_its_triangles(
            corners in prop::array::uniform4(prop::array::uniform3(-100.0f64..100.0)),
            share in 0.0f64..=1.0, origin in prop::array::uniform3(-200.0f64..200.0),
        ) {
            let [a, b, c, d] = corners.map(DVec3::from_array);
            let on_edge = a.lerp(b, share);
            let origin = DVec3::from_array(origin);
            let ray = Ray::new(origin, on_edge - origin);
            // c and d must lie on opposite sides of the edge as the ray sees it: then the two cover its neighbourhood.
            let side = |p: DVec3| (a - origin).cross(b - origin).dot(p - origin);
            prop_assume!(side(c) * side(d) < -1.0);
            prop_assert!(ray.hit(&[a, b, c]).is_some() || ray.hit(&[b, a, d]).is_some());
        }
    }
}
