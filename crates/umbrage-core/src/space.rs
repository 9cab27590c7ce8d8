//! Light space: where a light's rays are parallel to z, whatever the light.
//!
//! A sun needs a turn alone: x is right, y is up on the map, z grows along its travel, all in metres. The rays of a spot
//! spread from its tip; after the projection x / d, y / d, −1 / d, where d is the depth along its axis, they are parallel
//! too (Zhang et al. 2006, §3.1: the light's post-perspective space). So whatever is fitted, clipped or warped in light
//! space is done for every light at once, and the result is one matrix.
//!
//! Sums are in f64: a world of kilometres in texels of centimetres needs more than f32 holds.

use glam::{DMat4, DVec2, DVec3, DVec4};

/// The axes of a light, unit and perpendicular, in world space; and where its rays come from, unless they are parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSpace {
    /// Right on the map.
    pub right: DVec3,
    /// Up on the map.
    pub up: DVec3,
    /// The way the light travels; for a spot, its axis.
    pub along: DVec3,
    /// The tip of a spot, in world space.
    pub tip: Option<DVec3>,
}

impl LightSpace {
    /// Axes for a light that travels along unit `along`, with the map's up as near to `up` as can be. Where the two are
    /// within 8° of parallel, world Y stands in for `up`, or world Z.
    pub fn new(along: DVec3, up: DVec3) -> Self {
        let usable = |up: &DVec3| along.dot(*up).abs() <= 0.99;
        let up = [up, DVec3::Y].into_iter().find(usable).unwrap_or(DVec3::Z);
        let right = along.cross(up).normalize_or(along.any_orthonormal_vector());
        Self { right, up: right.cross(along), along, tip: None }
    }

    /// The same for rays that spread from `tip`.
    #[must_use]
    pub fn from_tip(self, tip: DVec3) -> Self {
        Self { tip: Some(tip), ..self }
    }

    /// The same turned about its axis, so that what was `side`, a unit vector on the map, is right.
    pub(crate) fn turned(&self, side: DVec2) -> Self {
        let Self { right, up, .. } = *self;
        Self { right: right * side.x + up * side.y, up: up * side.x - right * side.y, ..*self }
    }

    /// A point of the world in light space. What lies behind a spot's tip has no place there.
    pub fn to_light(&self, point: DVec3) -> DVec3 {
        let from = point - self.tip.unwrap_or_default();
        let turned = DVec3::new(self.right.dot(from), self.up.dot(from), self.along.dot(from));
        match self.tip {
            None => turned,
            Some(_) => DVec3::new(turned.x, turned.y, -1.0) / turned.z,
        }
    }

    /// The inverse of [`Self::to_light`].
    pub fn to_world(&self, point: DVec3) -> DVec3 {
        let turned = |p: DVec3| self.right * p.x + self.up * p.y + self.along * p.z;
        match self.tip {
            None => turned(point),
            Some(tip) => tip - turned(point.truncate().extend(1.0)) / point.z,
        }
    }

    /// How a direction of the world looks at a point of it: metres of light space a metre.
    pub(crate) fn direction_at(&self, point: DVec3, direction: DVec3) -> DVec2 {
        let turned = DVec2::new(self.right.dot(direction), self.up.dot(direction));
        match self.tip {
            None => turned,
            Some(tip) => {
                let place = self.to_light(point).truncate();
                (turned - place * self.along.dot(direction)) / self.along.dot(point - tip)
            }
        }
    }

    /// z of light space at a depth in metres along the axis: from the world's origin for a sun, from the tip for a spot.
    pub(crate) fn z_at(&self, metres: f64) -> f64 {
        if self.tip.is_some() { -1.0 / metres } else { metres }
    }

    /// The inverse of [`Self::z_at`].
    pub(crate) fn metres_at(&self, z: f64) -> f64 {
        if self.tip.is_some() { -1.0 / z } else { z }
    }

    /// World to light space, rows x, y, z, w.
    pub(crate) fn rows(&self) -> [DVec4; 4] {
        let tip = self.tip.unwrap_or_default();
        let row = |axis: DVec3| axis.extend(-axis.dot(tip));
        match self.tip {
            None => [row(self.right), row(self.up), row(self.along), DVec4::W],
            Some(_) => [row(self.right), row(self.up), DVec4::NEG_W, row(self.along)],
        }
    }

    /// The matrix that takes the box `min`…`max` of light space to clip space: x, y to −1…1, z to 0…1.
    pub fn clip_from_world(&self, min: DVec3, max: DVec3) -> DMat4 {
        let rows = self.rows();
        let crop = |row: DVec4, low: f64, high: f64| (row * 2.0 - rows[3] * (high + low)) / (high - low);
        DMat4::from_cols(
            crop(rows[0], min.x, max.x),
            crop(rows[1], min.y, max.y),
            (rows[2] - rows[3] * min.z) / (max.z - min.z),
            rows[3],
        )
        .transpose()
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn the_tutorials_sun_gives_v5() {
        // lightInvDir (0.5, 2, 2), looking at the origin from there, ortho ±10 and −10…20 ahead of it.
        let to_light = DVec3::new(0.5, 2.0, 2.0);
        let light = LightSpace::new(-to_light.normalize_or_zero(), DVec3::Y);
        let start = light.to_light(to_light).z;
        let matrix = light
            .clip_from_world(DVec3::new(-10.0, -10.0, start - 10.0), DVec3::new(10.0, 10.0, start + 20.0));
        for (world, uvz) in [
            (Vec3::ZERO, Vec3::new(0.5, 0.5, 0.429076044)),
            (Vec3::X, Vec3::new(0.548507125, 0.508444007, 0.423273456)),
            (Vec3::Y, Vec3::new(0.5, 0.464112972, 0.40586569)),
            (Vec3::Z, Vec3::new(0.487873219, 0.533776026, 0.40586569)),
            (Vec3::new(3.0, -2.0, 5.0), Vec3::new(0.584887469, 0.765986208, 0.342037216)),
        ] {
            let got = uvz_of(&matrix, world);
            assert!((got - uvz).abs().max_element() < 1e-6, "{world}: {got}, not {uvz}");
        }
    }

    #[test]
    fn the_tutorials_spot_gives_v5b() {
        let tip = DVec3::new(5.0, 20.0, 20.0);
        // It looks along the negative of lightInvDir (0.5, 2, 2), with a whole angle of 45° and depths 2…50.
        let along = -DVec3::new(0.5, 2.0, 2.0).normalize_or_zero();
        let light = LightSpace::new(along, DVec3::Y).from_tip(tip);
        let side = 22.5f64.to_radians().tan();
        let (near, far) = (light.z_at(2.0), light.z_at(50.0));
        let matrix = light.clip_from_world(DVec3::new(-side, -side, near), DVec3::new(side, side, far));
        for (world, uvz) in [
            (Vec3::ZERO, Vec3::new(0.5, 0.5, 0.96913431)),
            (Vec3::X, Vec3::new(0.541019876, 0.507140644, 0.96869204)),
            (Vec3::Y, Vec3::new(0.5, 0.469086778, 0.967332264)),
            (Vec3::Z, Vec3::new(0.489553945, 0.529094797, 0.967332264)),
        ] {
            let got = uvz_of(&matrix, world);
            assert!((got - uvz).abs().max_element() < 1e-6, "{world}: {got}, not {uvz}");
        }
    }

    fn uvz_of(matrix: &DMat4, world: Vec3) -> Vec3 {
        let ndc = matrix.project_point3(world.as_dvec3()).as_vec3();
        Vec3::new(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y, ndc.z)
    }

    #[test]
    fn axes_are_perpendicular_for_every_light_even_along_its_up() {
        for along in [
            DVec3::NEG_Y,
            DVec3::Y,
            DVec3::Z,
            DVec3::X,
            DVec3::new(0.6, -0.8, 0.0),
            DVec3::new(1e-9, -1.0, 0.0),
        ] {
            for up in [DVec3::Y, DVec3::Z, DVec3::ZERO, along] {
                let light = LightSpace::new(along, up);
                for (a, b) in [(light.right, light.up), (light.up, light.along), (light.along, light.right)] {
                    assert!(
                        a.dot(b).abs() < 1e-8 && (a.length() - 1.0).abs() < 1e-8,
                        "{along} with up {up}: {light:?}"
                    );
                }
            }
        }
    }

    proptest! {
        #[test]
        fn rays_are_parallel_to_z_and_points_come_back(
            tip in prop::option::of(prop::array::uniform3(-50.0f64..50.0)), along in prop::array::uniform3(-1.0f64..1.0),
            (x, y) in (-3.0f64..3.0, -3.0f64..3.0), (near, more) in (0.5f64..90.0, 0.1f64..90.0),
        ) {
            let along = DVec3::from(along).normalize_or(DVec3::X);
            let axes = LightSpace::new(along, DVec3::Y);
            let light = tip.map_or(axes, |tip| axes.from_tip(DVec3::from(tip)));
            let [p, q] = [near, near + more].map(|metres| light.to_world(DVec3::new(x, y, light.z_at(metres))));
            let (there, further) = (light.to_light(p), light.to_light(q));
            prop_assert!((there.truncate() - DVec2::new(x, y)).length() < 1e-9, "{there}");
            prop_assert!((there - further).truncate().length() < 1e-9 && there.z < further.z, "{there} {further}");
            prop_assert!((light.metres_at(there.z) - near).abs() < 1e-6, "{there}");
            let toward = light.tip.map_or(along, |tip| (p - tip).normalize_or_zero());
            prop_assert!((q - p).normalize_or_zero().distance(toward) < 1e-6, "along a ray");
            let by_matrix = DMat4::from_cols_array_2d(&light.rows().map(|row| row.to_array())).transpose().project_point3(p);
            prop_assert!(by_matrix.distance(there) < 1e-6, "{by_matrix}, not {there}");
            let step = DVec3::new(0.3, -0.4, 0.2) * 1e-5;
            let moved = (light.to_light(p + step) - there).truncate();
            prop_assert!(moved.distance(light.direction_at(p, step)) < 1e-9, "{moved}");
        }
    }
}
