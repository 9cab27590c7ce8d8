//! A light of a frame: how it shades, and the shadows that it casts.

use glam::Vec3;
use umbrage::Light;
use umbrage_scene::{LightKind, Pose};

use crate::error::RenderError;

/// A light that shades and casts shadows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameLight {
    /// The light that shadows are planned for.
    pub light: Light,
    /// Linear RGB times the intensity: lux of a sun, on a surface that faces it; candela of a spot or point light.
    pub colour: Vec3,
    /// The angles from a spot's axis at which its light begins to fade, and ends, radians; 0 of other lights.
    pub cone: [f32; 2],
}

impl FrameLight {
    /// Converts a scene's light as it is in a pose.
    ///
    /// # Errors
    /// When it cannot shine: a direction without length, a spot of no angle, no range.
    pub fn at(light: &umbrage_scene::Light, pose: &Pose) -> Result<Self, RenderError> {
        let world_from_light = light.world_from_light_in(pose);
        let (position, direction) = (world_from_light.w_axis.truncate(), -world_from_light.z_axis.truncate());
        // NaN is no distance, and neither is one without end.
        let near = if light.near > 0.0 { light.near.min(f32::MAX) } else { 0.0 };
        let (shadows, cone) = match light.kind {
            LightKind::Directional => (Light::directional(direction)?, [0.0; 2]),
            LightKind::Spot { inner, outer, range } => {
                let outer = outer.min(WIDEST_HALF_ANGLE);
                (Light::spot(position, direction, outer, range)?.with_near(near)?, [inner.min(outer), outer])
            }
            LightKind::Point { range } => (Light::point(position, range)?.with_near(near)?, [0.0; 2]),
        };
        Ok(Self { light: shadows, colour: light.colour * light.intensity, cone })
    }
}

/// A file's spot may shine on half of the world; no one map holds that, and the last tenth of a degree is given up.
pub(crate) const WIDEST_HALF_ANGLE: f32 = std::f32::consts::FRAC_PI_2 - 1e-3;
