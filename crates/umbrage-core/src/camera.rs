//! The camera whose picture gets shadows, and the corners of the slices that splits cut from it.

use std::ops::Range;

use glam::{DVec3, Mat4, Vec3};

use crate::error::CameraError;

/// A projection says how a camera's rays run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// The camera is a pinhole.
    Perspective {
        /// The whole vertical field of view, radians, between 0 and π.
        fov_y: f32,
        /// The picture's width over its height.
        aspect: f32,
    },
    /// All rays of the camera are parallel.
    Orthographic {
        /// Half the height of the visible box, metres.
        half_height: f32,
        /// The picture's width over its height.
        aspect: f32,
    },
}

/// A camera in world space. Its axes are perpendicular unit vectors and 0 < near < far, always.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    world_from_view: Mat4,
    projection: Projection,
    near: f32,
    far: f32,
}

/// Axes may be this far from unit length, and their products from zero.
const RIGID_TOLERANCE: f32 = 1e-3;

impl Camera {
    /// Makes a camera from its rigid transform (columns right, up, back, eye) and its depth range in metres.
    ///
    /// # Errors
    /// When the transform is not rigid, the range is not 0 < near < far, or the projection is degenerate.
    pub fn new(
        world_from_view: Mat4,
        projection: Projection,
        near: f32,
        far: f32,
    ) -> Result<Self, CameraError> {
        let [x, y, z, eye] =
            [world_from_view.x_axis, world_from_view.y_axis, world_from_view.z_axis, world_from_view.w_axis];
        let is_unit = |v: glam::Vec4| (v.truncate().length() - 1.0).abs() < RIGID_TOLERANCE && v.w == 0.0;
        let is_right = |a: glam::Vec4, b: glam::Vec4| a.truncate().dot(b.truncate()).abs() < RIGID_TOLERANCE;
        let rigid = [x, y, z].into_iter().all(is_unit) && is_right(x, y) && is_right(y, z) && is_right(z, x);
        if !rigid || !eye.is_finite() || eye.w != 1.0 {
            return Err(CameraError::NotRigid);
        }
        if !(near > 0.0 && near < far && far.is_finite()) {
            return Err(CameraError::DepthRange { near, far });
        }
        let aspect = match projection {
            Projection::Perspective { fov_y, aspect } => {
                if !(fov_y > 0.0 && fov_y < std::f32::consts::PI) {
                    return Err(CameraError::FieldOfView(fov_y));
                }
                aspect
            }
            Projection::Orthographic { half_height, aspect } => {
                if !(half_height > 0.0 && half_height.is_finite()) {
                    return Err(CameraError::HalfHeight(half_height));
                }
                aspect
            }
        };
        if !(aspect > 0.0 && aspect.is_finite()) {
            return Err(CameraError::Aspect(aspect));
        }
        Ok(Self { world_from_view, projection, near, far })
    }

    /// Makes a camera at `eye` that looks at `target`, with `up` as near to its up as can be.
    ///
    /// # Errors
    /// As [`Self::new`]; [`CameraError::NotRigid`] when `eye` is `target`, or `up` is along the view.
    pub fn looking(
        eye: Vec3,
        target: Vec3,
        up: Vec3,
        projection: Projection,
        near: f32,
        far: f32,
    ) -> Result<Self, CameraError> {
        let forward = (target - eye).try_normalize().ok_or(CameraError::NotRigid)?;
        let right = forward.cross(up).try_normalize().ok_or(CameraError::NotRigid)?;
        let up = right.cross(forward);
        let world_from_view =
            Mat4::from_cols(right.extend(0.0), up.extend(0.0), (-forward).extend(0.0), eye.extend(1.0));
        Self::new(world_from_view, projection, near, far)
    }

    /// The matrix from view to world space: columns right, up, back and eye.
    pub fn world_from_view(&self) -> Mat4 {
        self.world_from_view
    }

    /// The matrix from world to view space.
    pub fn view_from_world(&self) -> Mat4 {
        self.world_from_view.inverse()
    }

    /// Returns the same camera in a world whose origin is moved to `origin`: what it sees there is what it saw.
    #[must_use]
    pub fn relative_to(&self, origin: DVec3) -> Self {
        let eye = (self.eye().as_dvec3() - origin).as_vec3();
        Self { world_from_view: Mat4 { w_axis: eye.extend(1.0), ..self.world_from_view }, ..*self }
    }

    /// Returns the point of the world that positions on the GPU should be relative to, so that f32 is fine enough for what
    /// this camera sees: the world's origin where that is near, and else the corner of a lattice near the eye.
    ///
    /// The lattice's step is the power of two at 1024 times [`Self::near`]. A position is then rounded by at most
    /// 0.0001 × near where the eye can be close to it, which is a fraction of a pixel; and as the origin moves in whole steps,
    /// and seldom, what is drawn from two neighbouring eyes is rounded alike.
    pub fn local_origin(&self) -> DVec3 {
        let step = (1024.0 * f64::from(self.near)).log2().floor().exp2();
        (self.eye().as_dvec3() / step).round() * step
    }

    /// Returns how the camera projects.
    pub fn projection(&self) -> Projection {
        self.projection
    }

    /// The nearest visible view depth, metres.
    pub fn near(&self) -> f32 {
        self.near
    }

    /// The farthest visible view depth, metres.
    pub fn far(&self) -> f32 {
        self.far
    }

    /// Where the camera stands, in world space.
    pub fn eye(&self) -> Vec3 {
        self.world_from_view.w_axis.truncate()
    }

    /// The unit direction of view, in world space.
    pub fn forward(&self) -> Vec3 {
        -self.world_from_view.z_axis.truncate()
    }

    /// The matrix from view to clip space, with reversed depth: 1 on the near plane, 0 on the far one.
    pub fn clip_from_view(&self) -> Mat4 {
        let (n, f) = (self.near, self.far);
        match self.projection {
            Projection::Perspective { fov_y, aspect } => {
                let y = 1.0 / (0.5 * fov_y).tan();
                Mat4::from_cols_array(&[
                    y / aspect,
                    0.0,
                    0.0,
                    0.0, //
                    0.0,
                    y,
                    0.0,
                    0.0, //
                    0.0,
                    0.0,
                    n / (f - n),
                    -1.0, //
                    0.0,
                    0.0,
                    n * f / (f - n),
                    0.0,
                ])
            }
            Projection::Orthographic { half_height, aspect } => Mat4::from_cols_array(&[
                1.0 / (half_height * aspect),
                0.0,
                0.0,
                0.0, //
                0.0,
                1.0 / half_height,
                0.0,
                0.0, //
                0.0,
                0.0,
                1.0 / (f - n),
                0.0, //
                0.0,
                0.0,
                f / (f - n),
                1.0,
            ]),
        }
    }

    /// The matrix from world to clip space.
    pub fn clip_from_world(&self) -> Mat4 {
        self.clip_from_view() * self.view_from_world()
    }

    /// Returns the camera's reversed clip depth, 1…0, of something at view depth `depth` metres
    /// (Zhang et al. 2006, eq. 8, corrected for n ≠ 1 and reversed).
    pub fn clip_depth(&self, depth: f32) -> f32 {
        let (n, f) = (self.near, self.far);
        match self.projection {
            Projection::Perspective { .. } => n / (f - n) * (f / depth - 1.0),
            Projection::Orthographic { .. } => (f - depth) / (f - n),
        }
    }

    /// Half the height and half the width of what is seen at view depth `depth`, metres.
    pub(crate) fn half_extents(&self, depth: f64) -> (f64, f64) {
        match self.projection {
            Projection::Perspective { fov_y, aspect } => {
                let half = (0.5 * f64::from(fov_y)).tan() * depth;
                (half, half * f64::from(aspect))
            }
            Projection::Orthographic { half_height, aspect } => {
                (f64::from(half_height), f64::from(half_height) * f64::from(aspect))
            }
        }
    }

    /// Returns the eight corners of the slice between two view depths, in world space: the near four counter-clockwise seen
    /// from the eye, from lower left; then the far four likewise.
    pub fn slice_corners(&self, depths: Range<f64>) -> [DVec3; 8] {
        let axis = |v: glam::Vec4| v.truncate().as_dvec3();
        let (right, up, back) = (
            axis(self.world_from_view.x_axis),
            axis(self.world_from_view.y_axis),
            axis(self.world_from_view.z_axis),
        );
        let eye = self.eye().as_dvec3();
        std::array::from_fn(|i| {
            let depth = if i < 4 { depths.start } else { depths.end };
            let (half_height, half_width) = self.half_extents(depth);
            let x = if matches!(i % 4, 1 | 2) { half_width } else { -half_width };
            let y = if i % 4 >= 2 { half_height } else { -half_height };
            eye - back * depth + right * x + up * y
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn perspective(near: f32, far: f32) -> Camera {
        let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
        Camera::looking(Vec3::new(3.0, 2.0, 1.0), Vec3::new(1.0, 0.0, -4.0), Vec3::Y, projection, near, far)
            .unwrap()
    }

    #[test]
    fn the_local_origin_is_the_worlds_own_where_that_is_near_and_else_a_corner_near_the_eye() {
        let camera = perspective(0.1, 100.0);
        assert_eq!(camera.local_origin(), DVec3::ZERO);
        for far in [1e3, -2e5, 1e6f32] {
            let mut moved = camera;
            moved.world_from_view.w_axis += (Vec3::new(far, 0.0, -far)).extend(0.0);
            let origin = moved.local_origin();
            let seen = moved.relative_to(origin);
            // A step of the lattice is 64 m here.
            assert_eq!(origin % 64.0, DVec3::ZERO, "{origin}");
            assert!(seen.eye().length() <= 0.9 * 64.0, "{} from {origin}", seen.eye());
            assert_eq!(seen.eye().as_dvec3() + origin, moved.eye().as_dvec3(), "nothing is rounded");
            assert_eq!(moved.relative_to(DVec3::ZERO), moved);
        }
    }

    #[test]
    fn clip_depth_is_v2_reversed_and_agrees_with_the_matrix() {
        // V2: (n, f, z, reversed depth)
        for (n, f, z, reversed) in [
            (1.0, 800.0, 1.0, 1.0),
            (1.0, 800.0, 10.0, 0.098873592),
            (1.0, 800.0, 267.33333, 0.002493766),
            (1.0, 800.0, 800.0, 0.0),
            (0.1, 100.0, 10.0, 0.009009009),
            (0.1, 100.0, 0.1, 1.0),
            (0.5, 300.0, 5.0, 0.098497496),
        ] {
            let camera = perspective(n, f);
            assert!(
                (camera.clip_depth(z) - reversed).abs() < 1e-6,
                "n {n} f {f} z {z}: {}",
                camera.clip_depth(z)
            );
            let clip = camera.clip_from_view() * glam::Vec4::new(0.0, 0.0, -z, 1.0);
            assert!(
                (clip.z / clip.w - reversed).abs() < 1e-6,
                "the matrix at n {n} f {f} z {z}: {}",
                clip.z / clip.w
            );
        }
    }

    #[test]
    fn slice_corners_are_the_corners_of_clip_space() {
        for projection in [
            Projection::Perspective { fov_y: 1.1, aspect: 1.7 },
            Projection::Orthographic { half_height: 4.0, aspect: 0.5 },
        ] {
            let camera = Camera::looking(Vec3::ONE, Vec3::NEG_X, Vec3::Y, projection, 0.5, 20.0).unwrap();
            let corners =
                camera.slice_corners(0.5..20.0).map(|p| camera.clip_from_world().project_point3(p.as_vec3()));
            let expected = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            for (i, corner) in corners.into_iter().enumerate() {
                let (x, y) = expected[i % 4];
                let z = if i < 4 { 1.0 } else { 0.0 };
                assert!(
                    (corner - Vec3::new(x, y, z)).length() < 1e-4,
                    "corner {i} of {projection:?} is at {corner}"
                );
            }
        }
    }

    #[test]
    fn cameras_that_cannot_see_are_refused_by_name() {
        let make = |fov_y, near, far| {
            Camera::looking(
                Vec3::ZERO,
                Vec3::X,
                Vec3::Y,
                Projection::Perspective { fov_y, aspect: 1.0 },
                near,
                far,
            )
        };
        assert_eq!(make(1.0, 2.0, 1.0), Err(CameraError::DepthRange { near: 2.0, far: 1.0 }));
        assert!(matches!(make(1.0, f32::NAN, 1.0), Err(CameraError::DepthRange { .. })), "NaN is refused");
        assert_eq!(make(4.0, 1.0, 2.0), Err(CameraError::FieldOfView(4.0)));
        let inside_out = Camera::looking(
            Vec3::ZERO,
            Vec3::Y,
            Vec3::Y,
            Projection::Perspective { fov_y: 1.0, aspect: 1.0 },
            1.0,
            2.0,
        );
        assert_eq!(inside_out, Err(CameraError::NotRigid));
    }
}
