//! The camera whose picture gets shadows, and the corners of the slices that splits cut from it.

use std::ops::Range;

use glam::{DVec3, Mat4, Vec3, Vec4};

use crate::error::CameraError;

/// A projection says how a camera's rays run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// All rays meet in the eye.
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
    /// Where its direction of view lies in the picture, NDC.
    centre: [f32; 2],
    near: f32,
    far: f32,
}

/// Axes may be this far from unit length, and their products from zero.
const RIGID_TOLERANCE: f32 = 1e-3;

impl Camera {
    /// Makes a camera from its rigid transform (columns right, up, back, eye) and its depth range in metres. The far plane of a
    /// perspective camera may be infinitely far: with [`f32::INFINITY`] as `far`, shadows end at the shadow distance of the settings, or
    /// else at the distance from the eye to the farthest corner of the world's bounds, rounded up by at most 6 %.
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
        let is_unit = |v: Vec4| (v.truncate().length() - 1.0).abs() < RIGID_TOLERANCE && v.w == 0.0;
        let is_right = |a: Vec4, b: Vec4| a.truncate().dot(b.truncate()).abs() < RIGID_TOLERANCE;
        let rigid = [x, y, z].into_iter().all(is_unit) && is_right(x, y) && is_right(y, z) && is_right(z, x);
        if !rigid || !eye.is_finite() || eye.w != 1.0 {
            return Err(CameraError::NotRigid);
        }
        let may_be_unbounded = matches!(projection, Projection::Perspective { .. });
        if !(near > 0.0 && near < far && near.is_finite() && (far.is_finite() || may_be_unbounded)) {
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
        Ok(Self { world_from_view, projection, centre: [0.0; 2], near, far })
    }

    /// Returns the same camera with its direction of view at another place of the picture than the middle, NDC: by up to a pixel where
    /// frames are jittered for temporal anti-aliasing, by more where the picture is a part of a larger one.
    ///
    /// Texels that hold still ([`Fit::Stable`](crate::Fit::Stable)) may move with a jitter. Plan for the camera without it, and no more
    /// is lost than a part of a pixel along the border.
    ///
    /// # Errors
    /// When the place is not within the picture.
    pub fn with_centre(self, centre: [f32; 2]) -> Result<Self, CameraError> {
        if !centre.iter().all(|place| place.abs() < 1.0) {
            return Err(CameraError::Centre(centre));
        }
        Ok(Self { centre, ..self })
    }

    /// Makes a perspective camera of the tangents of the angles to the left, right, lower and upper sides of its picture. Those to the left
    /// and down are negative. Head-mounted displays give the angles, radians, from which tangents are taken:
    ///
    /// ```
    /// # use glam::Mat4;
    /// # use umbrage_core::{Camera, CameraError};
    /// // As OpenXR's `XrFovf` has them.
    /// let (angle_left, angle_right, angle_up, angle_down) = (-0.94f32, 0.79, 0.85, -0.85);
    /// let sides = [angle_left, angle_right, angle_down, angle_up].map(f32::tan);
    /// let camera = Camera::with_sides(Mat4::IDENTITY, sides, 0.1, f32::INFINITY)?;
    /// # Ok::<(), CameraError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Self::new`], and [`CameraError::Sides`] when the direction of view is not within the picture, or sides are exchanged.
    pub fn with_sides(
        world_from_view: Mat4,
        [left, right, down, up]: [f32; 4],
        near: f32,
        far: f32,
    ) -> Result<Self, CameraError> {
        if !(left < 0.0 && right > 0.0 && down < 0.0 && up > 0.0) {
            return Err(CameraError::Sides([left, right, down, up]));
        }
        let centre = [-(left + right) / (right - left), -(down + up) / (up - down)];
        let fov_y = 2.0 * (0.5 * (up - down)).atan();
        let projection = Projection::Perspective { fov_y, aspect: (right - left) / (up - down) };
        Self::new(world_from_view, projection, near, far)?.with_centre(centre)
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
        Self::facing(eye, target - eye, up, projection, near, far)
    }

    /// Makes a camera at `eye` that looks along `forward`, of any length, with `up` as near to its up as can be.
    ///
    /// # Errors
    /// As [`Self::new`]; [`CameraError::NotRigid`] when `forward` is zero, or `up` is along it.
    pub fn facing(
        eye: Vec3,
        forward: Vec3,
        up: Vec3,
        projection: Projection,
        near: f32,
        far: f32,
    ) -> Result<Self, CameraError> {
        let forward = forward.try_normalize().ok_or(CameraError::NotRigid)?;
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

    /// Returns where the direction of view lies in the picture, NDC. It is the middle, but for [`Self::with_centre`].
    pub fn centre(&self) -> [f32; 2] {
        self.centre
    }

    /// The nearest visible view depth, metres.
    pub fn near(&self) -> f32 {
        self.near
    }

    /// The farthest visible view depth, metres; infinite where there is none.
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
        let ([x, y], (n, f)) = (self.centre, (self.near, self.far));
        match self.projection {
            Projection::Perspective { fov_y, aspect } => {
                let height = 1.0 / (0.5 * fov_y).tan();
                let (at_eye, at_far) = if f.is_finite() { (n / (f - n), n * f / (f - n)) } else { (0.0, n) };
                Mat4::from_cols(
                    Vec4::new(height / aspect, 0.0, 0.0, 0.0),
                    Vec4::new(0.0, height, 0.0, 0.0),
                    Vec4::new(-x, -y, at_eye, -1.0),
                    Vec4::new(0.0, 0.0, at_far, 0.0),
                )
            }
            Projection::Orthographic { half_height, aspect } => Mat4::from_cols(
                Vec4::new(1.0 / (half_height * aspect), 0.0, 0.0, 0.0),
                Vec4::new(0.0, 1.0 / half_height, 0.0, 0.0),
                Vec4::new(0.0, 0.0, 1.0 / (f - n), 0.0),
                Vec4::new(x, y, f / (f - n), 1.0),
            ),
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
            Projection::Perspective { .. } if f == f32::INFINITY => n / depth,
            Projection::Perspective { .. } => n / (f - n) * (f / depth - 1.0),
            Projection::Orthographic { .. } => (f - depth) / (f - n),
        }
    }

    /// Half the height and half the width, metres at view depth `depth`, of the smallest picture around the direction of view that
    /// shows all.
    pub(crate) fn widest_half_extents(&self, depth: f64) -> (f64, f64) {
        let [x, y] = self.centre.map(|place| 1.0 + f64::from(place.abs()));
        let (half_height, half_width) = self.half_extents(depth);
        (half_height * y, half_width * x)
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
        let axis = |v: Vec4| v.truncate().as_dvec3();
        let (right, up, back) = (
            axis(self.world_from_view.x_axis),
            axis(self.world_from_view.y_axis),
            axis(self.world_from_view.z_axis),
        );
        let eye = self.eye().as_dvec3();
        let [x, y] = self.centre.map(f64::from);
        std::array::from_fn(|i| {
            let depth = if i < 4 { depths.start } else { depths.end };
            let (half_height, half_width) = self.half_extents(depth);
            let to_right = half_width * (if matches!(i % 4, 1 | 2) { 1.0 } else { -1.0 } - x);
            let to_top = half_height * (if i % 4 >= 2 { 1.0 } else { -1.0 } - y);
            eye - back * depth + right * to_right + up * to_top
        })
    }
}

#[cfg(test)]
mod tests;
