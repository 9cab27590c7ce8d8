//! A picture to take: from where, when, how large, and by which lights.

use std::sync::Arc;

use umbrage_render::{Frame, RenderError, Show};
use umbrage_scene::{Camera, Pose};

/// A shot is a picture to take.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// The camera.
    pub camera: Camera,
    /// The lights, at most 16. The shadows of each are judged.
    pub lights: Vec<umbrage_scene::Light>,
    /// How the scene stands: where what moves is, and how it is bent.
    pub pose: Arc<Pose>,
    /// The width of the picture, in pixels.
    pub width: u32,
    /// The height of the picture, in pixels.
    pub height: u32,
}

impl Shot {
    /// Makes the frame that shows the shot, with one sample a pixel.
    ///
    /// # Errors
    /// When the camera or a light cannot be used; the error names it.
    pub fn frame(&self, show: Show) -> Result<Frame, RenderError> {
        let Self { camera, lights, pose, width, height } = self;
        Frame::of(camera, lights, pose, [*width, *height], show)
    }
}
