//! A world as its BVH sees it: moved and scaled into the cube from −1 to 1, so that f32 is as good for worlds of
//! millimetres as for those of a thousand kilometres, wherever they stand.
//!
//! Rays are cut where they enter the cube, in f64: however far away the eye or a lamp is, what is walked in f32 begins near
//! the world.

use glam::{DVec3, Vec3A};

use crate::Ray;

/// How much larger than its triangle a leaf of the BVH is, in the cube. The BVH is walked in f32: it must not miss what the
/// f64 test would hit. A ray begins within 2⁻²⁴ of where it should, its direction is off by as much on each axis and it
/// is at most 2√3 long, and each slab is met within 3 · 2⁻²⁴ of the length: 20 · 2⁻²⁴ in all, and a half more.
pub(crate) const MARGIN: f32 = 16.0 * f32::EPSILON;

/// Where the cube stands in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct UnitBox {
    pub centre: DVec3,
    /// Half the side of the cube, metres.
    pub size: f64,
}

/// A ray as the BVH is walked by it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Walk {
    pub ray: obvhs::ray::Ray,
    /// The distance along the ray at which the walk begins.
    start: f64,
    /// Steps in the cube for each multiple of the ray's direction.
    steps: f64,
}

impl UnitBox {
    /// The cube around some corners.
    pub fn around<'a>(corners: impl IntoIterator<Item = &'a DVec3>) -> Self {
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for corner in corners {
            (min, max) = (min.min(*corner), max.max(*corner));
        }
        // Halves, so that the largest numbers do not overflow.
        let (centre, size) = (min * 0.5 + max * 0.5, (max * 0.5 - min * 0.5).max_element());
        let is_some = size.is_finite() && size > 0.0;
        Self {
            centre: if centre.is_finite() { centre } else { DVec3::ZERO },
            size: if is_some { size } else { 1.0 },
        }
    }

    /// Where a point of the world lies in the cube.
    pub fn inside(&self, point: DVec3) -> Vec3A {
        ((point - self.centre) / self.size).as_vec3a()
    }

    /// The walk of a ray from `from` to `to`, in multiples of its direction. `None` where it passes by the cube, or is not
    /// finite.
    pub fn walk(&self, ray: &Ray, from: f64, to: f64) -> Option<Walk> {
        let half = self.size * (1.0 + 4.0 * f64::from(MARGIN));
        let (mut start, mut end) = (from, to);
        let origin = ray.origin - self.centre;
        for axis in 0..3 {
            let (origin, direction) = (origin[axis], ray.direction[axis]);
            if direction == 0.0 {
                if origin.abs() > half {
                    return None;
                }
                continue;
            }
            let (a, b) = ((-half - origin) / direction, (half - origin) / direction);
            (start, end) = (start.max(a.min(b)), end.min(a.max(b)));
        }
        // NaN is not less.
        let is_met = start <= end && start.is_finite();
        let length = ray.direction.length();
        let (origin, direction) = (self.inside(ray.at(start)), (ray.direction / length).as_vec3a());
        if !(is_met && origin.is_finite() && direction.is_finite()) {
            return None;
        }
        let ray = obvhs::ray::Ray::new(origin, direction, 0.0, f32::INFINITY);
        let mut walk = Walk { ray, start, steps: length / self.size };
        walk.ray.tmax = walk.walked(end);
        Some(walk)
    }
}

impl Walk {
    /// How far along the walk all is met that is nearer than a distance along the ray.
    pub fn walked(&self, distance: f64) -> f32 {
        let steps = (distance - self.start) * self.steps;
        (steps * (1.0 + f64::from(MARGIN)) + f64::from(MARGIN)) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_lie_within_the_cube_and_rays_begin_where_they_enter_it() {
        for scale in [1e-30, 1e-3, 1.0, 1e6, 1e30] {
            let corners = [DVec3::new(2.0, 3.0, 4.0) * scale, DVec3::new(4.0, 3.5, 4.0) * scale];
            let cube = UnitBox::around(&corners);
            assert!(corners.iter().all(|corner| cube.inside(*corner).abs().max_element() <= 1.0), "{cube:?}");
            let far = Ray::new(DVec3::new(1e9, 3.25, 4.0) * scale, DVec3::NEG_X * 7.0);
            let walk = cube.walk(&far, 0.0, f64::INFINITY).expect("it meets the cube");
            assert!((walk.ray.origin - Vec3A::X).length() < 1e-5, "{walk:?}");
            assert!((walk.ray.tmax - 2.0).abs() < 1e-4, "{walk:?}");
            let beside = Ray::new(DVec3::new(1e9, 30.0, 4.0) * scale, DVec3::NEG_X);
            assert!(cube.walk(&beside, 0.0, f64::INFINITY).is_none(), "{scale}");
            assert!(cube.walk(&far, 0.0, scale).is_none(), "it ends before the cube");
        }
        let nowhere = UnitBox::around(&[]);
        assert!(nowhere.walk(&Ray::new(DVec3::NAN, DVec3::X), 0.0, 1.0).is_none());
    }
}
