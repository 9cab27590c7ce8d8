//! One side of the picture: a renderer with its settings, and the frame that is shown.

use std::collections::VecDeque;

use eframe::{egui, egui_wgpu, wgpu};
use umbrage::Settings;
use umbrage_render::{ComingPicture, Drawn, Frame, MapLook, RenderError, Renderer};

use super::texture::EguiTexture;
use crate::timings::PassTimes;

/// Frames whose times may be on their way at once; of more, the newest are lost.
const PENDING: usize = 3;

/// One side.
pub struct Side {
    renderer: Renderer,
    /// What is on the screen; `None` before the first picture.
    shown: Option<Shown>,
    /// Whether that must be drawn anew, whatever the next frame is.
    is_outdated: bool,
    /// egui's name for the picture, where egui puts it on the screen.
    egui_texture: EguiTexture,
    /// A place for each frame whose times have not come: how long planning took, milliseconds, or `None` where its times are
    /// not wanted.
    awaited: VecDeque<Option<f64>>,
}

/// A frame, and what came of drawing it.
struct Shown {
    frame: Frame,
    drawn: Drawn,
    texture: wgpu::TextureView,
}

impl Side {
    /// Returns a side on which nothing was drawn yet.
    pub fn new(renderer: Renderer) -> Self {
        Self {
            renderer,
            shown: None,
            is_outdated: true,
            egui_texture: EguiTexture::default(),
            awaited: VecDeque::new(),
        }
    }

    /// Returns a renderer of the same scene with other settings.
    pub fn beside(&self, settings: Settings) -> Result<Renderer, RenderError> {
        self.renderer.beside(settings)
    }

    pub fn set_settings(&mut self, settings: &Settings) -> Result<(), RenderError> {
        self.renderer.set_settings(settings.clone())?;
        self.is_outdated = true;
        Ok(())
    }

    /// Shows a frame, and returns whether it had to be drawn. `window` is where egui puts pictures on the screen.
    pub fn draw(
        &mut self,
        frame: &Frame,
        window: Option<&egui_wgpu::RenderState>,
    ) -> Result<bool, RenderError> {
        if !self.is_outdated && self.frame() == Some(frame) {
            return Ok(false);
        }
        let drawn = self.renderer.draw(frame)?;
        let texture = self.renderer.shown()?;
        if let Some(window) = window {
            self.egui_texture.show(window, &texture);
        }
        self.awaited.push_back(Some(drawn.plan_milliseconds));
        self.shown = Some(Shown { frame: frame.clone(), drawn, texture });
        self.is_outdated = false;
        Ok(true)
    }

    /// Draws the frame from another camera and waits: how long it took, milliseconds, and its size.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn time_alone(
        &mut self,
        camera: &umbrage_scene::Camera,
    ) -> Result<Option<(f64, [u32; 2])>, RenderError> {
        let Some(frame) = self.frame().cloned() else { return Ok(None) };
        self.is_outdated = true;
        let size = [frame.width, frame.height];
        // Times that nobody asked for would be taken for this frame's.
        while self.renderer.pass_times().is_some() {}
        self.awaited.clear();
        let camera = umbrage_render::camera(camera, frame.width as f32 / frame.height as f32)?;
        let times = self.renderer.render(&Frame { camera, ..frame })?.times;
        Ok(Some((times.frame, size)))
    }

    /// Draws a frame that is not shown, to be read back.
    pub fn request(&mut self, frame: &Frame) -> Result<ComingPicture, RenderError> {
        self.renderer.draw(frame)?;
        self.awaited.push_back(None);
        self.renderer.coming_picture()
    }

    /// The frame that is shown.
    pub fn frame(&self) -> Option<&Frame> {
        self.shown.as_ref().map(|shown| &shown.frame)
    }

    /// What came of drawing it.
    pub fn drawn(&self) -> Option<&Drawn> {
        self.shown.as_ref().map(|shown| &shown.drawn)
    }

    /// The picture on the screen.
    pub fn texture(&self) -> Option<&wgpu::TextureView> {
        self.shown.as_ref().map(|shown| &shown.texture)
    }

    /// egui's id of it, where egui puts it on the screen.
    pub fn id(&self) -> Option<egui::TextureId> {
        self.egui_texture.id()
    }

    pub fn bytes(&self) -> u64 {
        self.renderer.shadows().bytes()
    }

    pub fn map_picture(
        &mut self,
        view: usize,
        look: MapLook,
        side_px: u32,
    ) -> Result<wgpu::TextureView, RenderError> {
        self.renderer.map_picture(view, look, side_px)
    }

    pub fn times(&mut self) -> Vec<PassTimes> {
        let mut times = Vec::new();
        while let Some([casters, filter, shade]) = self.renderer.pass_times() {
            if let Some(Some(plan)) = self.awaited.pop_front() {
                times.push([plan, casters, filter, shade]);
            }
        }
        // As many as the device's clock keeps; without timestamps none ever come.
        self.awaited.truncate(PENDING);
        times
    }

    pub fn free(self, window: &egui_wgpu::RenderState) {
        self.egui_texture.free(window);
    }
}
