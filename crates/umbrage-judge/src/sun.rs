//! The light: a sun, which is a direction, and perhaps a disc in the sky.

use glam::{DVec3, Vec3};

/// A directional light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// Unit, in world space.
    pub to_light: DVec3,
}

impl Sun {
    /// Light that travels along `direction`, of any length but zero.
    pub fn along(direction: Vec3) -> Self {
        Self { to_light: (-direction.as_dvec3()).normalize_or(DVec3::Y) }
    }

    /// A direction to a point of the sun's disc, unit. `x` and `y` are on the unit disc; `half_angle` is half the angle
    /// that the sun is seen under, radians (0.00463 for ours).
    pub fn to_point(&self, half_angle: f64, x: f64, y: f64) -> DVec3 {
        let (right, up) = self.to_light.any_orthonormal_pair();
        (self.to_light + (right * x + up * y) * half_angle.tan()).normalize_or(self.to_light)
    }
}
