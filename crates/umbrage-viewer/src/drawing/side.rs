//! One side of the picture: a renderer with its settings, and the frame that is shown.

use std::collections::VecDeque;
use std::time::Duration;

use eframe::{egui, egui_wgpu, wgpu};
use umbrage::{Exact, Settings};
use umbrage_render::{ComingPicture, Drawn, Frame, MapLook, RayCasters, RenderError, Renderer, Show};

use super::coming::Coming;
use super::texture::EguiTexture;
use crate::timings::PassTimes;

/// Frames whose times may be on their way at once; of more, the newest are lost.
const PENDING: usize = 3;

/// One side.
pub struct Side {
    renderer: Renderer,
    /// What is on the screen; `None` before the first picture.
    shown: Option<Shown>,
    /// egui's name for the picture, where egui puts it on the screen.
    egui_texture: EguiTexture,
    /// A place for each frame whose times have not come: how long planning took, milliseconds, or `None` where its times are
    /// not wanted.
    awaited: VecDeque<Option<f64>>,
}

/// A frame that was drawn with some settings; it owns its picture as long as that is shown.
struct Shown {
    frame: Frame,
    settings: Settings,
    /// Whether rays were traced for it.
    traces: bool,
    drawn: Drawn,
}

/// A window waits no longer for levels of detail before its first picture.
const PATIENCE: Duration = Duration::from_millis(300);

impl Side {
    /// Returns a side on which nothing was drawn yet.
    pub fn new(mut renderer: Renderer) -> Self {
        renderer.patience = renderer.patience.min(PATIENCE);
        Self { renderer, shown: None, egui_texture: EguiTexture::default(), awaited: VecDeque::new() }
    }

    /// Returns a renderer of the same scene with other settings.
    pub fn beside(&self, settings: Settings) -> Result<Renderer, RenderError> {
        self.renderer.beside(settings)
    }

    pub fn set_settings(&mut self, settings: &Settings) -> Result<(), RenderError> {
        self.renderer.set_settings(settings.clone())
    }

    /// Returns whether the settings ask for rays.
    pub fn asks_for_rays(&self) -> bool {
        self.renderer.shadows().settings().exact != Exact::Off
    }

    /// Returns whether there is something to trace for them.
    pub fn has_ray_casters(&self) -> bool {
        self.renderer.has_ray_casters()
    }

    /// Returns whether rays are traced.
    pub fn traces(&self) -> bool {
        self.asks_for_rays() && self.has_ray_casters()
    }

    /// Hands over what rays go through, to this side and those beside it.
    pub fn set_ray_casters(&mut self, casters: &RayCasters) -> Result<(), RenderError> {
        self.renderer.set_ray_casters(casters)
    }

    /// Shows a frame, and returns whether it had to be drawn. `window` is where egui puts pictures on the screen.
    pub fn draw(
        &mut self,
        frame: &Frame,
        window: Option<&egui_wgpu::RenderState>,
    ) -> Result<bool, RenderError> {
        let (settings, traces) = (self.renderer.shadows().settings(), self.traces());
        let is_wanted =
            |shown: &Shown| shown.frame == *frame && shown.settings == *settings && shown.traces == traces;
        if self.shown.as_ref().is_some_and(is_wanted) {
            return Ok(false);
        }
        let settings = settings.clone();
        let drawn = self.renderer.draw(frame)?;
        let texture = drawn.shown()?;
        if let Some(window) = window {
            self.egui_texture.show(window, &texture);
        }
        self.awaited.push_back(Some(drawn.plan_milliseconds()));
        self.shown = Some(Shown { frame: frame.clone(), settings, traces, drawn });
        Ok(true)
    }

    /// Draws the frame from another camera and waits: how long it took, milliseconds, and its size.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn time_alone(
        &mut self,
        camera: &umbrage_scene::Camera,
    ) -> Result<Option<(f64, [u32; 2])>, RenderError> {
        let Some(Shown { frame, .. }) = &self.shown else { return Ok(None) };
        let size = [frame.width, frame.height];
        let camera = umbrage_render::camera(camera, frame.width as f32 / frame.height as f32)?;
        let frame = Frame { camera, ..frame.clone() };
        // Times that nobody asked for would be taken for this frame's.
        while self.renderer.pass_times().is_some() {}
        self.awaited.clear();
        Ok(Some((self.renderer.render(&frame)?.times.frame, size)))
    }

    /// Draws another picture of what is shown, to be read back: from its own shadow maps, where there are any.
    pub fn request(&mut self, show: Show) -> Result<Option<ComingPicture>, RenderError> {
        let beside = self.beside_shown(show)?;
        beside.map(|beside| beside.coming_picture()).transpose()
    }

    /// Draws another frame, whose times nobody wants, and requests its picture.
    pub fn request_frame(&mut self, frame: &Frame) -> Result<ComingPicture, RenderError> {
        let drawn = self.renderer.draw(frame)?;
        self.awaited.push_back(None);
        drawn.coming_picture()
    }

    /// Requests the visibility of a light, and the shadow maps that it was read from.
    pub fn ask(&mut self, light: usize) -> Result<Option<Coming>, RenderError> {
        let Some(beside) = self.beside_shown(Show::Visibility(light))? else { return Ok(None) };
        // Not every device copies depth.
        let maps = self.renderer.coming_maps(&beside).ok();
        Ok(Some(Coming::new(beside.plan().clone(), beside.coming_picture()?, maps)))
    }

    /// Draws another picture of what is shown, whose times nobody wants; `None` before the first one.
    fn beside_shown(&mut self, show: Show) -> Result<Option<Drawn>, RenderError> {
        let Some(Shown { frame, drawn, .. }) = &self.shown else { return Ok(None) };
        let beside = if !drawn.plan().views().is_empty() && self.renderer.has_maps_of(drawn) {
            self.renderer.show(drawn, &show)?
        } else {
            self.renderer.draw(&Frame { show, ..frame.clone() })?
        };
        self.awaited.push_back(None);
        Ok(Some(beside))
    }

    /// Returns what came of drawing the frame that is shown.
    pub fn drawn(&self) -> Option<&Drawn> {
        self.shown.as_ref().map(|shown| &shown.drawn)
    }

    /// Returns the picture on the screen.
    pub fn texture(&self) -> Option<wgpu::TextureView> {
        // One that cannot be shown was refused when it was drawn.
        self.drawn()?.shown().ok()
    }

    /// egui's id of it, where egui puts it on the screen.
    pub fn id(&self) -> Option<egui::TextureId> {
        self.egui_texture.id()
    }

    pub fn bytes(&self) -> u64 {
        self.renderer.shadows().bytes()
    }

    pub fn occluder_bytes(&self) -> u64 {
        self.renderer.shadows().occluder_bytes()
    }

    /// Returns the shadow map of a view as a picture; `None` where the maps are not those of what is shown any more.
    pub fn map_picture(
        &mut self,
        view: usize,
        look: MapLook,
        side_px: u32,
    ) -> Result<Option<wgpu::TextureView>, RenderError> {
        let Some(Shown { drawn, .. }) = &self.shown else { return Ok(None) };
        if !self.renderer.has_maps_of(drawn) {
            return Ok(None);
        }
        self.renderer.map_picture(drawn, view, look, side_px).map(Some)
    }

    pub fn times(&mut self) -> Vec<PassTimes> {
        let mut times = Vec::new();
        while let Some([deform, casters, filter, shade]) = self.renderer.pass_times() {
            if let Some(Some(plan)) = self.awaited.pop_front() {
                times.push([plan, deform, casters, filter, shade]);
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
