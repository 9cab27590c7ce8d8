//! Light space: where a light's rays are parallel to z, whatever the light.
//!
//! A sun needs a rotation alone: x is right, y is up on the map, z grows along its travel, all in metres. The rays of a
//! punctual light spread from its apex; after the projection x / d, y / d, −1 / d, where d is the depth along its axis,
//! they are parallel too (Zhang et al. 2006, §3.1: the light's post-perspective space). So whatever is fitted, clipped or
//! warped in light space is done for every light at once, and the result is one matrix.
//!
//! Sums are in f64: a world of kilometres in texels of centimetres needs more than f32 holds.

use glam::{DVec2, DVec3, DVec4};

/// The axes of a light, unit and perpendicular, in world space; and where its rays come from, unless they are parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LightSpace {
    /// Right on the map.
    pub right: DVec3,
    /// Up on the map.
    pub up: DVec3,
    /// The direction in which a sun's light travels; the axis of a spot, or of a face of a point light's cube.
    pub axis: DVec3,
    /// The apex of a punctual light, in world space; `None` for a sun.
    pub apex: Option<DVec3>,
}

/// How the rays of one view run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rays {
    /// The rays are parallel, as a sun's: depth is stored evenly.
    Parallel,
    /// The rays spread from an apex, as those of a spot or of a face of a point light's cube: depth is stored as 1 / d.
    FromApex {
        /// The apex, in world space.
        apex: DVec3,
    },
}

impl LightSpace {
    /// The axes of a light along unit `axis`, with the map's up as near to `up` as can be. Where the two are within 8° of
    /// parallel, world Y stands in for `up`, or world Z.
    pub fn new(axis: DVec3, up: DVec3) -> Self {
        let usable = |up: &DVec3| axis.dot(*up).abs() <= 0.99;
        let up = [up, DVec3::Y].into_iter().find(usable).unwrap_or(DVec3::Z);
        let right = axis.cross(up).normalize_or(axis.any_orthonormal_vector());
        Self { right, up: right.cross(axis), axis, apex: None }
    }

    /// The same axes for rays that spread from `apex`.
    #[must_use]
    pub fn with_apex(self, apex: DVec3) -> Self {
        Self { apex: Some(apex), ..self }
    }

    /// How the rays run.
    pub fn rays(&self) -> Rays {
        match self.apex {
            None => Rays::Parallel,
            Some(apex) => Rays::FromApex { apex },
        }
    }

    /// The same light, rotated about its axis so that what was `side`, a unit vector on the map, is right.
    pub fn rotated(&self, side: DVec2) -> Self {
        let Self { right, up, .. } = *self;
        Self { right: right * side.x + up * side.y, up: up * side.x - right * side.y, ..*self }
    }

    /// A point of the world in light space. What lies behind an apex has no place there.
    pub fn to_light(self, point: DVec3) -> DVec3 {
        let from = point - self.apex.unwrap_or_default();
        let rotated = DVec3::new(self.right.dot(from), self.up.dot(from), self.axis.dot(from));
        match self.apex {
            None => rotated,
            Some(_) => DVec3::new(rotated.x, rotated.y, -1.0) / rotated.z,
        }
    }

    /// The inverse of [`Self::to_light`].
    pub fn to_world(self, point: DVec3) -> DVec3 {
        let rotated = |p: DVec3| self.right * p.x + self.up * p.y + self.axis * p.z;
        match self.apex {
            None => rotated(point),
            Some(apex) => apex - rotated(point.truncate().extend(1.0)) / point.z,
        }
    }

    /// How fast the place in light space changes along a direction of the world, at a point of it: metres of light space
    /// a metre.
    pub fn direction_at(&self, point: DVec3, direction: DVec3) -> DVec2 {
        let rotated = DVec2::new(self.right.dot(direction), self.up.dot(direction));
        match self.apex {
            None => rotated,
            Some(apex) => {
                let place = self.to_light(point).truncate();
                (rotated - place * self.axis.dot(direction)) / self.axis.dot(point - apex)
            }
        }
    }

    /// z of light space at a distance in metres along the axis, from the world's origin for a sun and else from the apex.
    pub fn z_at(&self, metres: f64) -> f64 {
        if self.apex.is_some() { -1.0 / metres } else { metres }
    }

    /// The inverse of [`Self::z_at`].
    pub fn metres_at(&self, z: f64) -> f64 {
        if self.apex.is_some() { -1.0 / z } else { z }
    }

    /// The rows x, y, z and w of the matrix from world to light space.
    pub fn rows(&self) -> [DVec4; 4] {
        let apex = self.apex.unwrap_or_default();
        let row = |axis: DVec3| axis.extend(-axis.dot(apex));
        match self.apex {
            None => [row(self.right), row(self.up), row(self.axis), DVec4::W],
            Some(_) => [row(self.right), row(self.up), DVec4::NEG_W, row(self.axis)],
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DMat4;
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn axes_are_perpendicular_for_every_light_even_along_its_up() {
        for axis in [
            DVec3::NEG_Y,
            DVec3::Y,
            DVec3::Z,
            DVec3::X,
            DVec3::new(0.6, -0.8, 0.0),
            DVec3::new(1e-9, -1.0, 0.0),
        ] {
            for up in [DVec3::Y, DVec3::Z, DVec3::ZERO, axis] {
                let light = LightSpace::new(axis, up);
                for (a, b) in [(light.right, light.up), (light.up, light.axis), (light.axis, light.right)] {
                    assert!(
                        a.dot(b).abs() < 1e-8 && (a.length() - 1.0).abs() < 1e-8,
                        "{axis} with up {up}: {light:?}"
                    );
                }
            }
        }
    }

    proptest! {
        #[test]
        fn rays_are_parallel_to_z_and_points_come_back(
            apex in prop::option::of(prop::array::uniform3(-50.0f64..50.0)), axis in prop::array::uniform3(-1.0f64..1.0),
            (x, y) in (-3.0f64..3.0, -3.0f64..3.0), (near, more) in (0.5f64..90.0, 0.1f64..90.0),
        ) {
            let axis = DVec3::from(axis).normalize_or(DVec3::X);
            let axes = LightSpace::new(axis, DVec3::Y);
            let light = apex.map_or(axes, |apex| axes.with_apex(DVec3::from(apex)));
            let [p, q] = [near, near + more].map(|metres| light.to_world(DVec3::new(x, y, light.z_at(metres))));
            let (there, further) = (light.to_light(p), light.to_light(q));
            prop_assert!((there.truncate() - DVec2::new(x, y)).length() < 1e-9, "{there}");
            prop_assert!((there - further).truncate().length() < 1e-9 && there.z < further.z, "{there} {further}");
            prop_assert!((light.metres_at(there.z) - near).abs() < 1e-6, "{there}");
            let toward = light.apex.map_or(axis, |apex| (p - apex).normalize_or_zero());
            prop_assert!((q - p).normalize_or_zero().distance(toward) < 1e-6, "along a ray");
            let by_matrix = DMat4::from_cols_array_2d(&light.rows().map(|row| row.to_array())).transpose().project_point3(p);
            prop_assert!(by_matrix.distance(there) < 1e-6, "{by_matrix}, not {there}");
            let step = DVec3::new(0.3, -0.4, 0.2) * 1e-5;
            let moved = (light.to_light(p + step) - there).truncate();
            prop_assert!(moved.distance(light.direction_at(p, step)) < 1e-9, "{moved}");
        }
    }
}
