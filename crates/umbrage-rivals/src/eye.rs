//! The camera of a view as matrices of f64 that begin at the eye: so nothing depends on where in the world it stands.

use glam::{DMat4, DVec3, DVec4};
use umbrage_render::RenderError;
use umbrage_render::umbrage::{Camera, Projection};

/// A camera that can be used, for a picture of some size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Eye {
    /// Where it stands in the world.
    pub place: DVec3,
    /// To the right edge of the picture: at depth 1 of a perspective camera, at every depth of parallel rays.
    pub right: DVec3,
    /// To the upper edge, likewise.
    pub up: DVec3,
    /// The unit direction of view.
    pub forward: DVec3,
    /// The view depths of the nearest and the farthest thing that is visible, metres.
    pub depths: [f64; 2],
    pub is_parallel: bool,
}

impl Eye {
    pub fn new(camera: &umbrage_scene::Camera, [width, height]: [u32; 2]) -> Result<Self, RenderError> {
        let aspect = f64::from(width) / f64::from(height.max(1));
        let checked: Camera = umbrage_render::camera(camera, aspect as f32)?;
        let (half_height, is_parallel) = match checked.projection() {
            Projection::Perspective { fov_y, .. } => ((0.5 * f64::from(fov_y)).tan(), false),
            Projection::Orthographic { half_height, .. } => (f64::from(half_height), true),
        };
        let axis = |v: glam::Vec4| v.truncate().as_dvec3().normalize_or_zero();
        let matrix = &camera.world_from_camera;
        Ok(Self {
            place: camera.eye().as_dvec3(),
            right: axis(matrix.x_axis) * half_height * aspect,
            up: axis(matrix.y_axis) * half_height,
            forward: -axis(matrix.z_axis),
            depths: [f64::from(camera.near), f64::from(camera.far)],
            is_parallel,
        })
    }

    /// A ball around the near plane, relative to the eye: centre and radius, metres.
    pub fn near_plane(&self) -> (DVec3, f64) {
        let near = self.depths[0];
        if self.is_parallel {
            (self.forward * near, (self.right + self.up).length())
        } else {
            (DVec3::ZERO, near * (self.forward + self.right + self.up).length())
        }
    }

    /// A ball around all that parallel rays see, relative to the eye: centre and radius, metres.
    pub fn seen(&self) -> (DVec3, f64) {
        let [near, far] = self.depths;
        let half = 0.5 * (far - near) * self.forward;
        (0.5 * (near + far) * self.forward, (half + self.right + self.up).length())
    }

    /// Its place relative to itself and 1, or the unit direction toward it and 0 where its rays are parallel.
    pub fn homogeneous(&self) -> DVec4 {
        if self.is_parallel { (-self.forward).extend(0.0) } else { DVec4::W }
    }

    /// Clip space of positions in world axes that are relative to the eye. Depth is reversed, and that of a perspective camera is
    /// near / depth, which is 0 at infinity: what is infinitely far is within it.
    pub fn clip_from_eye(&self) -> DMat4 {
        let Self { right, up, forward, depths: [near, far], is_parallel, place: _ } = *self;
        let across = |axis: DVec3| (axis / axis.length_squared()).extend(0.0);
        let rows = if is_parallel {
            let depth = (forward / (near - far)).extend(far / (far - near));
            [across(right), across(up), depth, DVec4::W]
        } else {
            [across(right), across(up), DVec4::W * near, forward.extend(0.0)]
        };
        DMat4::from_cols(rows[0], rows[1], rows[2], rows[3]).transpose()
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use umbrage_scene::{Camera, Lens};

    use super::*;

    #[test]
    fn what_is_infinitely_far_is_at_depth_0_and_what_is_near_at_1() {
        let camera =
            Camera::looking("c", Vec3::new(2e5, 3.0, 1.0), Vec3::new(2e5, 2.0, -7.0), 1.0, 0.5, 90.0);
        let eye = Eye::new(&camera, [200, 100]).unwrap();
        let clip = |point: DVec4| eye.clip_from_eye() * point;
        assert_eq!(clip(eye.forward.extend(0.0)).z, 0.0);
        let near = clip((eye.forward * 0.5).extend(1.0));
        assert!((near.z / near.w - 1.0).abs() < 1e-12, "{near}");
        let corner = clip(((eye.forward + eye.right + eye.up) * 7.0).extend(1.0));
        assert!(
            (corner.x / corner.w - 1.0).abs() < 1e-9 && (corner.y / corner.w - 1.0).abs() < 1e-9,
            "{corner}"
        );
    }

    #[test]
    fn parallel_rays_have_depths_from_1_to_0_between_their_ends() {
        let camera = Camera::looking("c", Vec3::Y, Vec3::ZERO, 1.0, 0.5, 90.0);
        let eye =
            Eye::new(&Camera { lens: Lens::Orthographic { half_height: 4.0 }, ..camera }, [80, 40]).unwrap();
        for (depth, wanted) in [(0.5, 1.0), (90.0, 0.0)] {
            let clip = eye.clip_from_eye() * (eye.forward * depth + eye.right - eye.up).extend(1.0);
            assert!(
                (clip.z - wanted).abs() < 1e-12 && (clip.x - 1.0).abs() < 1e-9 && (clip.y + 1.0).abs() < 1e-9,
                "{clip}"
            );
        }
    }
}
