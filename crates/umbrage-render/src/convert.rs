//! From a scene's descriptions to what the planner wants.

use umbrage::{Bounds, Camera, Projection};
use umbrage_scene::{Pose, Scene};

use crate::draws::PartTable;
use crate::error::RenderError;

/// Converts a scene's camera to the planner's, in a picture of `aspect` (width over height).
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

/// Returns the boxes of everything in a scene, in a pose of it.
pub fn bounds(scene: &Scene, pose: &Pose) -> Bounds {
    PartTable::new(scene).into_bounds_in(&scene.instances, pose)
}
