//! The matrix of a map: from world space to the clip space of one view.
//!
//! x and y come from light space, through the homography of the map's plane, to −1…1 over the rectangle. Depth is reversed,
//! 1 on the near plane and 0 on the far one, and linear in light-space z along every ray; a warp scales it by a factor that
//! is constant along each ray.
//!
//! Reversed, since a float is finest near 0: light-space z of a punctual light is −1 / d, and the step from one float to the
//! next is then the same share of d at every distance, wherever the near plane lies. Near 1 it would grow with d² / near.

use std::ops::Range;

use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};

use crate::homography::Homography;
use crate::space::LightSpace;

/// How a map is projected.
pub(crate) struct LightProjection {
    /// The light's axes, rotated as the homography says.
    pub space: LightSpace,
    pub homography: Homography,
    /// The corners of the rectangle that the map covers, after the homography.
    pub min: DVec2,
    pub max: DVec2,
    /// From the near plane to the far one along the light's axis, metres.
    pub depths: Range<f64>,
}

impl LightProjection {
    /// The rows x, y, z and w of the clip matrix.
    pub fn rows(&self) -> [DVec4; 4] {
        let Self { space, homography, min, max, depths } = self;
        let [x, y, z, w] = space.rows();
        let perspective = homography.perspective_matrix();
        let [u, v, weight] = [0, 1, 2].map(|i| {
            let row = perspective.row(i);
            x * row.x + y * row.y + w * row.z
        });
        let crop = |row: DVec4, low: f64, high: f64| (row * 2.0 - weight * (high + low)) / (high - low);
        let (near, far) = (space.z_at(depths.start), space.z_at(depths.end));
        let reversed = (w * far - z) / (far - near);
        [crop(u, min.x, max.x), crop(v, min.y, max.y), reversed / self.greatest_scale(), weight]
    }

    /// The clip matrix.
    pub fn clip_from_world(&self) -> DMat4 {
        let [x, y, z, w] = self.rows();
        DMat4::from_cols(x, y, z, w).transpose()
    }

    /// The factor by which the warp scales depth, as a linear function of NDC: see [`crate::ShadowView::depth_scale`].
    pub fn depth_scale(&self) -> DVec3 {
        self.inverse_weight() / self.greatest_scale()
    }

    /// The greatest inverse weight on the map: depth is divided by it, so that no near plane lies beyond 1.
    fn greatest_scale(&self) -> f64 {
        let DVec3 { x, y, z } = self.inverse_weight();
        x.abs() + y.abs() + z
    }

    /// The inverse of the homography's weight as a linear function of NDC: it is the weight of the inverse homography.
    fn inverse_weight(&self) -> DVec3 {
        let (centre, half) = ((self.min + self.max) * 0.5, (self.max - self.min) * 0.5);
        // From NDC to the warped plane, and back.
        let to_plane = DMat3::from_cols(DVec3::X * half.x, DVec3::Y * half.y, centre.extend(1.0));
        (self.homography.perspective_matrix().inverse() * to_plane).row(2)
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    /// The uvz of a point of the world on a map without a warp.
    fn uvz(projection: &LightProjection, world: Vec3) -> Vec3 {
        let ndc = projection.clip_from_world().project_point3(world.as_dvec3()).as_vec3();
        Vec3::new(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y, ndc.z)
    }

    #[test]
    fn the_tutorials_sun_gives_v5() {
        // Its depth is not reversed. lightInvDir (0.5, 2, 2), looking at the origin from there, ortho ±10 and −10…20 ahead of it.
        let to_light = DVec3::new(0.5, 2.0, 2.0);
        let space = LightSpace::new(-to_light.normalize_or_zero(), DVec3::Y);
        let start = space.to_light(to_light).z;
        let projection = LightProjection {
            space,
            homography: Homography::IDENTITY,
            min: DVec2::splat(-10.0),
            max: DVec2::splat(10.0),
            depths: start - 10.0..start + 20.0,
        };
        for (world, wanted) in [
            (Vec3::ZERO, Vec3::new(0.5, 0.5, 1.0 - 0.429076044)),
            (Vec3::X, Vec3::new(0.548507125, 0.508444007, 1.0 - 0.423273456)),
            (Vec3::Y, Vec3::new(0.5, 0.464112972, 1.0 - 0.40586569)),
            (Vec3::Z, Vec3::new(0.487873219, 0.533776026, 1.0 - 0.40586569)),
            (Vec3::new(3.0, -2.0, 5.0), Vec3::new(0.584887469, 0.765986208, 1.0 - 0.342037216)),
        ] {
            let got = uvz(&projection, world);
            assert!((got - wanted).abs().max_element() < 1e-6, "{world}: {got}, not {wanted}");
        }
    }

    #[test]
    fn the_tutorials_spot_gives_v5b() {
        let apex = DVec3::new(5.0, 20.0, 20.0);
        // It looks along the negative of lightInvDir (0.5, 2, 2), with a whole angle of 45° and depths 2…50.
        let axis = -DVec3::new(0.5, 2.0, 2.0).normalize_or_zero();
        let side = 22.5f64.to_radians().tan();
        let projection = LightProjection {
            space: LightSpace::new(axis, DVec3::Y).with_apex(apex),
            homography: Homography::IDENTITY,
            min: DVec2::splat(-side),
            max: DVec2::splat(side),
            depths: 2.0..50.0,
        };
        for (world, wanted) in [
            (Vec3::ZERO, Vec3::new(0.5, 0.5, 1.0 - 0.96913431)),
            (Vec3::X, Vec3::new(0.541019876, 0.507140644, 1.0 - 0.96869204)),
            (Vec3::Y, Vec3::new(0.5, 0.469086778, 1.0 - 0.967332264)),
            (Vec3::Z, Vec3::new(0.489553945, 0.529094797, 1.0 - 0.967332264)),
        ] {
            let got = uvz(&projection, world);
            assert!((got - wanted).abs().max_element() < 1e-6, "{world}: {got}, not {wanted}");
        }
    }
}
