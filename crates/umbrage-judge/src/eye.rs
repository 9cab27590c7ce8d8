//! A camera as rays: one through every point of its picture.

use glam::{DVec3, Vec3};
use umbrage_scene::{Camera, Lens};

use crate::Ray;

/// An eye is a scene's camera together with the size of the picture it takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eye {
    /// Width of the picture, in pixels.
    pub width: u32,
    /// Height of the picture, in pixels.
    pub height: u32,
    /// View depth of the nearest thing that is visible, in metres.
    pub near: f64,
    /// View depth of the farthest thing that is visible, in metres.
    pub far: f64,
    position: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    /// Half the height of what is seen: at depth 1 for a perspective camera, at every depth for parallel rays.
    half_height: f64,
    is_parallel: bool,
}

impl Eye {
    /// Makes the eye of a camera with a picture of `width` × `height` pixels, each at least 1.
    pub fn new(camera: &Camera, width: u32, height: u32) -> Self {
        let axis = |v: glam::Vec4| v.truncate().as_dvec3().normalize_or_zero();
        let (half_height, is_parallel) = match camera.lens {
            Lens::Perspective { fov_y } => ((0.5 * f64::from(fov_y)).tan(), false),
            Lens::Orthographic { half_height } => (f64::from(half_height), true),
        };
        Self {
            width,
            height,
            near: f64::from(camera.near),
            far: f64::from(camera.far),
            position: camera.eye().as_dvec3(),
            right: axis(camera.world_from_camera.x_axis),
            up: axis(camera.world_from_camera.y_axis),
            forward: -axis(camera.world_from_camera.z_axis),
            half_height,
            is_parallel,
        }
    }

    /// Returns the ray through a point of the picture, given in pixels from its upper left corner: centres of pixels are
    /// at halves. Distances along the ray are view depths.
    pub fn ray(&self, x: f64, y: f64) -> Ray {
        let across = (2.0 * x - f64::from(self.width)) / f64::from(self.height) * self.half_height;
        let down = (2.0 * y - f64::from(self.height)) / f64::from(self.height) * self.half_height;
        let aside = self.right * across - self.up * down;
        if self.is_parallel {
            Ray::new(self.position + aside, self.forward)
        } else {
            Ray::new(self.position, self.forward + aside)
        }
    }

    /// Returns the size of a pixel, in metres, on a surface that faces the camera at a view depth in metres.
    pub fn pixel_metres(&self, depth: f64) -> f64 {
        let height = 2.0 * self.half_height / f64::from(self.height);
        if self.is_parallel { height } else { height * depth }
    }

    /// Projects a world-space point into the picture: x and y in pixels, and its view depth in metres. `None` outside the
    /// picture, or nearer than `near` or farther than `far`.
    pub fn project(&self, point: DVec3) -> Option<(f64, f64, f64)> {
        let from_eye = point - self.position;
        let depth = from_eye.dot(self.forward);
        let half = if self.is_parallel { self.half_height } else { self.half_height * depth };
        let (width, height) = (f64::from(self.width), f64::from(self.height));
        let x = 0.5 * (width + height * from_eye.dot(self.right) / half);
        let y = 0.5 * (height - height * from_eye.dot(self.up) / half);
        let is_seen = depth >= self.near
            && depth <= self.far
            && (0.0..width).contains(&x)
            && (0.0..height).contains(&y);
        is_seen.then_some((x, y, depth))
    }
}

/// Returns the same camera moved a little, for the `repeat`th repeat of a measurement: by up to a two-thousandth of its
/// far distance along each of its axes, which is of the order of a texel. Repeat 0 is the camera itself. Moves follow the
/// R3 sequence (Roberts, 2018), so that any number of them is spread evenly.
pub fn jittered(camera: &Camera, repeat: u32) -> Camera {
    /// The reciprocal powers of the real root of x⁴ = x + 1.
    const STEPS: [f64; 3] = [0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_970_1];
    let axes =
        [camera.world_from_camera.x_axis, camera.world_from_camera.y_axis, camera.world_from_camera.z_axis];
    let shift: Vec3 = axes
        .into_iter()
        .zip(STEPS)
        .map(|(axis, step)| axis.truncate() * (((0.5 + step * f64::from(repeat)).fract() - 0.5) as f32))
        .sum();
    let mut moved = camera.clone();
    moved.world_from_camera.w_axis += (shift * camera.far * 1e-3).extend(0.0);
    moved
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(lens: Lens) -> Camera {
        let camera =
            Camera::looking("c", Vec3::new(1.0, 2.0, 3.0), Vec3::new(4.0, 1.0, -9.0), 1.0, 0.5, 100.0);
        Camera { lens, ..camera }
    }

    #[test]
    fn points_on_a_pixels_ray_project_back_to_the_pixel_at_their_depth() {
        for lens in [Lens::Perspective { fov_y: 1.0 }, Lens::Orthographic { half_height: 20.0 }] {
            let eye = Eye::new(&camera(lens), 64, 36);
            for (x, y, depth) in [(0.5, 0.5, 1.0), (63.5, 20.25, 50.0), (32.0, 18.0, 99.0)] {
                let (u, v, z) = eye.project(eye.ray(x, y).at(depth)).expect("in sight");
                assert!((u - x).abs() + (v - y).abs() + (z - depth).abs() < 1e-5, "{lens:?}: {u} {v} {z}");
            }
            assert_eq!(eye.project(eye.ray(32.0, 18.0).at(0.4)), None, "nearer than near");
            assert_eq!(eye.project(eye.ray(70.0, 18.0).at(10.0)), None, "beside the picture");
        }
    }

    #[test]
    fn jittered_cameras_are_near_each_other_and_all_different() {
        let camera = camera(Lens::Perspective { fov_y: 1.0 });
        assert_eq!(jittered(&camera, 0), camera);
        for i in 1..64 {
            let moved = jittered(&camera, i).eye().distance(camera.eye());
            assert!(moved > 1e-4 && moved < 0.09, "repeat {i} moved by {moved} m");
        }
    }
}
