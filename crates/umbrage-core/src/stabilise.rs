//! Keeping shadow edges still while the camera moves: a sphere of constant size, moved by whole texels.
//!
//! The sphere around a slice, computed in view space, does not depend on where the camera is or looks, so a map fitted
//! to it never changes size; its centre is rounded to whole texels of light space, so that every texel stays the same
//! piece of the world. Ferko 2010 §3.4 ("shaking") names the problem; Valient, *Stable Rendering of Cascaded Shadow
//! Maps* (ShaderX6, 2008) the cure; the closed form of the smallest sphere is derived, and tested against the corners.

use std::ops::Range;

use crate::camera::{Camera, Projection};

/// A sphere whose centre lies on the view axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sphere {
    /// The view depth of the centre, metres.
    pub depth: f64,
    /// The radius, metres.
    pub radius: f64,
}

/// The smallest sphere around the slice of `camera` between two view depths.
pub(crate) fn bounding_sphere(camera: &Camera, depths: Range<f64>) -> Sphere {
    let (n, f) = (depths.start, depths.end);
    match camera.projection() {
        Projection::Perspective { .. } => {
            let (half_height, half_width) = camera.widest_half_extents(1.0);
            let k2 = half_height * half_height + half_width * half_width;
            if k2 >= (f - n) / (f + n) {
                // The far plane's circle is the sphere's equator.
                Sphere { depth: f, radius: f * k2.sqrt() }
            } else {
                let squares = (f - n).powi(2) + 2.0 * (f * f + n * n) * k2 + ((f + n) * k2).powi(2);
                Sphere { depth: 0.5 * (f + n) * (1.0 + k2), radius: 0.5 * squares.sqrt() }
            }
        }
        Projection::Orthographic { .. } => {
            let (half_height, half_width) = camera.widest_half_extents(n);
            let half_depth = 0.5 * (f - n);
            let radius = (half_height.powi(2) + half_width.powi(2) + half_depth.powi(2)).sqrt();
            Sphere { depth: 0.5 * (f + n), radius }
        }
    }
}

/// The next multiple of a sixteenth of the power of two at or below `size`: rounds up by at most 6 %, and rounding
/// errors of `size` do not reach the result.
pub(crate) fn quantise_up(size: f64) -> f64 {
    let step = size.log2().floor().exp2() / 16.0;
    // Sizes that differ by rounding alone must not fall on two sides of a step.
    ((size / step - 1e-6).ceil() * step).max(f64::MIN_POSITIVE)
}

/// The nearest whole multiple of `texel`.
pub(crate) fn snap(coordinate: f64, texel: f64) -> f64 {
    (coordinate / texel).round() * texel
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec3};
    use proptest::prelude::*;

    use super::*;

    fn camera(fov_degrees: f32, aspect: f32, near: f32, far: f32) -> Camera {
        let projection = Projection::Perspective { fov_y: fov_degrees.to_radians(), aspect };
        Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, near, far).unwrap()
    }

    fn farthest_corner(camera: &Camera, depths: Range<f64>, centre: f64) -> f64 {
        let corners = camera.slice_corners(depths);
        corners.into_iter().map(|p| p.distance(DVec3::new(0.0, 0.0, -centre))).fold(0.0, f64::max)
    }

    #[test]
    fn bounding_spheres_are_those_of_v4() {
        for (near, far, fov, aspect, depth, radius) in [
            (1.0, 10.0, 60.0, 16.0 / 9.0, 10.0, 11.776380),
            (1.0, 10.0, 30.0, 1.0, 6.289764, 5.303320),
            (10.0, 50.0, 45.0, 16.0 / 9.0, 50.0, 42.244168),
            (1.0, 800.0, 60.0, 4.0 / 3.0, 771.333333, 770.333934),
            (0.1, 5.0, 20.0, 1.0, 2.708565, 2.608684),
        ] {
            let sphere = bounding_sphere(&camera(fov, aspect, near, far), f64::from(near)..f64::from(far));
            assert!((sphere.depth - depth).abs() < 2e-6 * depth, "{sphere:?} should be at {depth}");
            assert!((sphere.radius - radius).abs() < 2e-6 * radius, "{sphere:?} should have radius {radius}");
        }
    }

    #[test]
    #[expect(clippy::approx_constant, reason = "the vector quotes them")]
    fn snapping_is_v6() {
        let texel = 2.0 * 12.5 / 2048.0;
        assert_eq!((snap(3.14159, texel), snap(-2.71828, texel)), (3.13720703125, -2.72216796875));
    }

    proptest! {
        #[test]
        fn the_sphere_holds_all_corners_and_no_smaller_one_does(
            fov in 5.0f32..150.0, aspect in 0.3f32..3.0, near in 0.1f32..50.0, depth in 0.1f32..500.0,
        ) {
            let camera = camera(fov, aspect, near, near + depth);
            let depths = f64::from(near)..f64::from(near + depth);
            let sphere = bounding_sphere(&camera, depths.clone());
            let reach = farthest_corner(&camera, depths.clone(), sphere.depth);
            prop_assert!(reach <= sphere.radius * (1.0 + 1e-6), "{} > {}", reach, sphere.radius);
            for shift in [-0.01, 0.01] {
                let moved = farthest_corner(&camera, depths.clone(), sphere.depth * (1.0 + shift));
                prop_assert!(moved >= sphere.radius * (1.0 - 1e-6), "{} < {}", moved, sphere.radius);
            }
        }

        #[test]
        fn quantised_sizes_are_a_little_larger_and_immune_to_rounding(size in 1e-3f64..1e6) {
            let quantised = quantise_up(size);
            prop_assert!(quantised >= size * (1.0 - 1e-6) && quantised <= size * 1.0626, "{}", quantised);
            prop_assert_eq!(quantise_up(quantised), quantised);
            prop_assert_eq!(quantise_up(quantised * (1.0 + 1e-12)), quantised);
        }
    }
}
