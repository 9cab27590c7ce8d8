//! The depth of what a camera sees, without any shadows: what others begin with who draw shadows in the picture's own pixels.

use super::Renderer;
use crate::error::RenderError;
use crate::frame::{Frame, Show};
use crate::shading::Inputs;

impl Renderer {
    /// Draws the depth of what a frame's camera sees: of solid surfaces, of what masks leave, and of veils where they cover at
    /// least half of their place. The lights and what the frame shows count for nothing.
    ///
    /// It returns a texture of [`wgpu::TextureFormat::Depth32Float`] of the picture's size, which is valid until the next frame.
    /// Depth is [`umbrage::Camera::clip_depth`] of the frame's camera: 1 at its near distance, 0 where nothing is seen. The
    /// time that it took is the last of [`Self::pass_times`]. It does not wait.
    ///
    /// # Errors
    /// As [`Self::draw`].
    pub fn depth(&mut self, frame: &Frame) -> Result<wgpu::TextureView, RenderError> {
        let frame = Frame { lights: Vec::new(), show: Show::Visibility(0), samples: 1, ..frame.clone() };
        let target = self.make_ready(&frame)?;
        let planned = self.plan(&frame)?;
        self.maps = planned.maps;
        let Self { gpu, scene, shadows, shading, timer, .. } = self;
        let mut encoder = gpu.encoder("Renderer::depth");
        let inputs = Inputs { gpu, scene, shadows };
        let depth = shading.see(inputs, &mut encoder, timer, &planned, &frame.show, &target)?;
        timer.resolve(&mut encoder);
        gpu.queue.submit([encoder.finish()]);
        timer.end_frame()?;
        Ok(depth)
    }
}
