//! What a view shows: the depth of the first surface of every pixel, drawn as the renderer of maps draws it.

use std::sync::Arc;
use web_time::Duration;

use umbrage_render::umbrage::{Filter, Settings};
use umbrage_render::{Frame, Gpu, RenderError, Renderer, Show};
use umbrage_scene::Scene;

use crate::rival::View;

/// A renderer that is asked for depth and nothing else.
#[derive(Debug)]
pub(crate) struct Receivers {
    renderer: Renderer,
}

impl Receivers {
    pub fn new(gpu: &Gpu, scene: &Scene) -> Result<Self, RenderError> {
        // What casts no shadow gets no levels of detail either.
        let mut scene = scene.clone();
        scene.instances.iter_mut().for_each(|instance| instance.casts = false);
        let none = Settings { splits: 1, resolution: 16, filter: Filter::Hard {}, ..Settings::default() };
        let mut renderer = Renderer::new(gpu, &scene, none)?;
        renderer.patience = Duration::ZERO;
        Ok(Self { renderer })
    }

    /// Draws the depth of a view, 1 near to 0 where there is nothing.
    pub fn depth(&mut self, view: &View<'_>) -> Result<wgpu::TextureView, RenderError> {
        let frame = Frame::of(view.camera, &[], &Arc::clone(view.pose), view.size, Show::Nothing)?;
        self.renderer.depth(&frame)
    }

    /// The milliseconds of the last view on the device, once it is done; `None` without timestamps.
    pub fn milliseconds(&mut self) -> Option<f64> {
        let mut last = None;
        while let Some(times) = self.renderer.pass_times() {
            last = Some(times.iter().sum());
        }
        last
    }
}
