//! From a scene's descriptions to what the planner wants.

use umbrage::{Bounds, Camera, Light, Projection};
use umbrage_scene::{LightKind, Scene};

use crate::error::RenderError;
use crate::frame::Lamp;

/// The planner's camera for a scene's, in a picture of `aspect` (width over height).
///
/// # Errors
/// When the camera's transform is not rigid, or its lens or range is degenerate.
pub fn camera(camera: &umbrage_scene::Camera, aspect: f32) -> Result<Camera, RenderError> {
    let projection = match camera.lens {
        umbrage_scene::Lens::Perspective { fov_y } => Projection::Perspective { fov_y, aspect },
        umbrage_scene::Lens::Orthographic { half_height } => Projection::Orthographic { half_height, aspect },
    };
    Ok(Camera::new(camera.world_from_camera, projection, camera.near, camera.far)?)
}

/// A scene's light as it is at a time.
///
/// # Errors
/// When it cannot shine: a direction without length, a spot of no angle, no range.
pub fn lamp(light: &umbrage_scene::Light, seconds: f32) -> Result<Lamp, RenderError> {
    let world_from_light = light.world_from_light_at(seconds);
    let (position, direction) = (world_from_light.w_axis.truncate(), -world_from_light.z_axis.truncate());
    let (shadows, cone) = match light.kind {
        LightKind::Directional => (Light::directional(direction)?, [0.0; 2]),
        LightKind::Spot { inner, outer, range } => {
            let outer = outer.min(WIDEST_HALF_ANGLE);
            (Light::spot(position, direction, outer, range)?, [inner.min(outer), outer])
        }
        LightKind::Point { range } => (Light::point(position, range)?, [0.0; 2]),
    };
    let strength = if light.kind == LightKind::Directional { SUN_LIGHT } else { light.intensity };
    Ok(Lamp { light: shadows, colour: light.colour * strength, cone })
}

/// A file's spot may shine on half of the world; no one map holds that, and the last tenth of a degree is given up.
pub(crate) const WIDEST_HALF_ANGLE: f32 = std::f32::consts::FRAC_PI_2 - 1e-3;

/// The light of any sun on a surface that faces it, before tone mapping. Pictures are exposed for it.
const SUN_LIGHT: f32 = 2.6;

/// The boxes of everything in a scene at a time.
pub fn bounds(scene: &Scene, seconds: f32) -> Bounds {
    let parts = crate::draws::PartTable::new(scene);
    parts.bounds_at(scene, seconds)
}
