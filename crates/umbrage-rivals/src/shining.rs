//! A light of a view, homogeneous: one formula then serves suns and lamps.

use glam::{DVec3, DVec4};
use umbrage_render::{FrameLight, RenderError};
use umbrage_scene::{Light, LightKind, Pose};

/// A light that can be used, where it stands in a pose.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shining {
    /// Its place in the world and 1, or the unit direction to a sun and 0.
    pub place: DVec4,
    /// The unit direction in which it shines.
    pub axis: DVec3,
    /// The cosine of the half angle of a spot's cone, and −2 for what shines all around.
    pub cos_outer: f64,
    /// The distance at which it ends, metres.
    pub range: f64,
    /// The distance nearer than which nothing casts, metres.
    pub near: f64,
}

impl Shining {
    pub fn at(light: &Light, pose: &Pose) -> Result<Self, RenderError> {
        // A light that maps could not be planned for is refused in the same words.
        FrameLight::at(light, pose)?;
        let world_from_light = light.world_from_light_in(pose);
        let place = world_from_light.w_axis.truncate().as_dvec3().extend(1.0);
        let axis = -world_from_light.z_axis.truncate().as_dvec3().normalize_or(DVec3::Z);
        let near = f64::from(light.near.max(0.0));
        let around = Self { place, axis, cos_outer: -2.0, range: f64::INFINITY, near };
        Ok(match light.kind {
            LightKind::Directional => Self { place: (-axis).extend(0.0), ..around },
            LightKind::Spot { inner: _, outer, range } => {
                Self { cos_outer: f64::from(outer).cos(), range: f64::from(range), ..around }
            }
            LightKind::Point { range } => Self { range: f64::from(range), ..around },
        })
    }

    /// Whether its rays are parallel.
    pub fn is_sun(&self) -> bool {
        self.place.w == 0.0
    }

    /// Its place relative to the eye.
    pub fn from(&self, eye: DVec3) -> DVec4 {
        self.place - eye.extend(0.0) * self.place.w
    }
}
