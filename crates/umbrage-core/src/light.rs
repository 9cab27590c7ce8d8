//! What shines. A plan may hold several lights; each makes its own shadow views.

use glam::Vec3;

use crate::LightError;

/// A light that casts shadows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Light {
    /// Parallel rays, as from the sun. Made by [`Light::directional`].
    Directional {
        /// Unit direction in which the light travels, in world space.
        direction: Vec3,
    },
}

impl Light {
    /// A sun whose light travels along `direction`, of any length.
    ///
    /// # Errors
    /// When `direction` is zero or not finite.
    pub fn directional(direction: Vec3) -> Result<Self, LightError> {
        // In f64, which holds the square of every f32.
        let unit = direction.as_dvec3().try_normalize().ok_or(LightError::Direction(direction.to_array()))?;
        Ok(Self::Directional { direction: unit.as_vec3() })
    }

    /// Unit direction toward the light, in world space; for a directional light the same everywhere.
    pub fn direction_to_light(&self) -> Vec3 {
        match self {
            Self::Directional { direction } => -*direction,
        }
    }

    /// How many shadow views it needs when the camera's depth is cut into `splits`.
    pub fn views(&self, splits: u32) -> u32 {
        match self {
            Self::Directional { .. } => splits,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_direction_of_any_length_will_do() {
        for length in [1e-30, 1.0, 1e38] {
            let light = Light::directional(Vec3::new(0.6, -0.8, 0.0) * length);
            let to_light = light.map(|light| light.direction_to_light());
            assert!(
                to_light.is_ok_and(|d| (d - Vec3::new(-0.6, 0.8, 0.0)).length() < 1e-6),
                "{length}: {light:?}"
            );
        }
    }
}
