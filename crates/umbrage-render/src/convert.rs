//! From a scene's descriptions to what the planner wants.

use glam::Vec3;
use umbrage::{Bounds, Camera, Light, Projection};
use umbrage_scene::{LightKind, Scene};

use crate::error::RenderError;

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

/// The first directional light of a scene: the way it travels, and its colour. `None` where there is none.
pub fn sun(scene: &Scene) -> Option<(Light, Vec3)> {
    let sun = scene.lights.iter().find(|light| light.kind == LightKind::Directional)?;
    Some((Light::directional(sun.direction()).ok()?, sun.colour))
}

/// The boxes of everything in a scene at a time.
pub fn bounds(scene: &Scene, seconds: f32) -> Bounds {
    let parts = crate::draws::PartTable::new(scene);
    parts.bounds_at(scene, seconds)
}
