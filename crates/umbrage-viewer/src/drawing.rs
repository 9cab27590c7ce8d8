//! A world on the device, drawn with one or two settings into textures that a window shows.

mod blit;
mod coming;
mod side;
mod texture;

use std::sync::Arc;

use eframe::{egui, egui_wgpu, wgpu};
use umbrage::{Exact, Settings, ShadowPlan};
use umbrage_render::{
    ComingPicture, Drawn, Frame, Gpu, MapLook, RayCasters, RenderError, Renderer, Show, ViewLoad,
};
use umbrage_scene::Scene;

use crate::timings::PassTimes;

use blit::Blit;
use side::Side;
use texture::EguiTexture;

pub use coming::Coming;

/// The pictures of a world: one, or two beside each other.
pub struct Drawing {
    gpu: Gpu,
    window: egui_wgpu::RenderState,
    sides: Vec<Side>,
    map: EguiTexture,
    /// Copies pictures to the screen; where absent, egui does.
    blit: Option<Blit>,
}

impl std::fmt::Debug for Drawing {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Drawing").field("sides", &self.sides.len()).finish_non_exhaustive()
    }
}

impl Drawing {
    /// Uploads a scene, to be drawn once for each of `settings`, of which there is at least one.
    ///
    /// # Errors
    /// As [`Renderer::new`].
    pub fn new(
        gpu: &Gpu,
        window: &egui_wgpu::RenderState,
        scene: &Arc<Scene>,
        settings: &[Settings],
    ) -> Result<Self, RenderError> {
        // With rays the renderer would make the casters itself, and the window wait for them.
        let first = Settings { exact: Exact::Off, ..settings.first().cloned().unwrap_or_default() };
        let mut drawing = Self {
            gpu: gpu.clone(),
            window: window.clone(),
            sides: vec![Side::new(Renderer::new(gpu, scene, first)?)],
            map: EguiTexture::default(),
            blit: Blit::new(window),
        };
        drawing.set_settings(settings)?;
        Ok(drawing)
    }

    /// Returns how many sides there are: one or two.
    pub fn sides(&self) -> usize {
        self.sides.len()
    }

    /// Draws as many sides as there are settings from now on.
    ///
    /// # Errors
    /// As [`Renderer::set_settings`]; the sides before the one that fails have their new settings then.
    pub fn set_settings(&mut self, settings: &[Settings]) -> Result<(), RenderError> {
        for (i, wanted) in settings.iter().enumerate() {
            match self.sides.get_mut(i) {
                None => {
                    let renderer = self.sides[0].beside(wanted.clone())?;
                    self.sides.push(Side::new(renderer));
                }
                Some(side) => side.set_settings(wanted)?,
            }
        }
        for side in self.sides.drain(settings.len().max(1)..) {
            side.free(&self.window);
        }
        Ok(())
    }

    /// Returns whether a side's settings ask for rays, and there are no casters for them yet.
    pub fn wants_ray_casters(&self) -> bool {
        self.sides.iter().any(|side| side.asks_for_rays() && !side.has_ray_casters())
    }

    /// Returns whether rays are traced on some side.
    pub fn traces(&self) -> bool {
        self.sides.iter().any(Side::traces)
    }

    /// Hands over what rays go through, to all sides.
    ///
    /// # Errors
    /// As [`Renderer::set_ray_casters`]; then maps alone answer.
    pub fn set_ray_casters(&mut self, casters: &RayCasters) -> Result<(), RenderError> {
        self.sides[0].set_ray_casters(casters)
    }

    /// Shows a frame on a side. Returns whether it had to be drawn.
    ///
    /// # Errors
    /// As [`Renderer::draw`]; then the picture stays as it was.
    pub fn draw(&mut self, side: usize, frame: &Frame) -> Result<bool, RenderError> {
        let window = self.blit.is_none().then_some(&self.window);
        self.sides[side].draw(frame, window)
    }

    /// Draws the first side's frame from another camera, and waits for it. Returns how long that took, milliseconds, and
    /// the size of the picture, pixels; `None` before the first picture.
    ///
    /// # Errors
    /// As [`Renderer::render`].
    #[cfg(not(target_arch = "wasm32"))]
    pub fn time_alone(
        &mut self,
        camera: &umbrage_scene::Camera,
    ) -> Result<Option<(f64, [u32; 2])>, RenderError> {
        self.sides[0].time_alone(camera)
    }

    /// Returns the longest side of a picture that the device can draw, pixels.
    pub fn max_side_px(&self) -> u32 {
        self.gpu.device.limits().max_texture_dimension_2d
    }

    /// Draws another picture of a side's frame to be read back, beside the one that is shown; `None` before the first
    /// picture.
    ///
    /// # Errors
    /// As [`Renderer::show`].
    pub fn request(&mut self, side: usize, show: Show) -> Result<Option<ComingPicture>, RenderError> {
        self.sides[side].request(show)
    }

    /// Requests the visibility of one light and the shadow maps of a side's picture; `None` before the first picture.
    ///
    /// # Errors
    /// As [`Renderer::show`].
    pub fn ask(&mut self, side: usize, light: usize) -> Result<Option<Coming>, RenderError> {
        self.sides[side].ask(light)
    }

    /// Requests a side's picture as it is shown, to be saved; `None` before the first picture.
    ///
    /// # Errors
    /// As [`Drawn::coming_picture`].
    pub fn request_picture(&self, side: usize) -> Result<Option<ComingPicture>, RenderError> {
        self.sides[side].drawn().map(Drawn::coming_picture).transpose()
    }

    /// Draws another frame with a side's settings, beside the one that is shown, and requests its picture.
    ///
    /// # Errors
    /// As [`Renderer::draw`].
    pub fn request_frame(&mut self, side: usize, frame: &Frame) -> Result<ComingPicture, RenderError> {
        self.sides[side].request_frame(frame)
    }

    /// Returns the shape that covers a rectangle of the screen with a side's picture.
    pub fn picture(&self, side: usize, rect: egui::Rect) -> Option<egui::Shape> {
        let side = self.sides.get(side)?;
        if let Some(blit) = &self.blit {
            return Some(blit.shape(&self.window, &side.texture()?, rect));
        }
        let whole = egui::Rect::from_min_max(egui::Pos2::ZERO, egui::pos2(1.0, 1.0));
        Some(egui::Shape::image(side.id()?, rect, whole, egui::Color32::WHITE))
    }

    /// Returns the shadow plan of a side's picture.
    pub fn plan(&self, side: usize) -> Option<&ShadowPlan> {
        Some(self.sides.get(side)?.drawn()?.plan())
    }

    /// Returns what was drawn into each view of a side's plan.
    pub fn loads(&self, side: usize) -> &[ViewLoad] {
        self.sides.get(side).and_then(Side::drawn).map_or(&[], Drawn::loads)
    }

    /// Returns the size of a side's shadow maps and of what is made of them, bytes.
    pub fn bytes(&self, side: usize) -> u64 {
        self.sides.get(side).map_or(0, Side::bytes)
    }

    /// Returns the size of the casters that a side's rays go through, bytes; 0 where maps alone answer. Both sides have the same.
    pub fn occluder_bytes(&self, side: usize) -> u64 {
        self.sides.get(side).map_or(0, Side::occluder_bytes)
    }

    /// Returns the shadow map of a view of a side, as a picture of `side_px` pixels a side. Where the maps are not those of
    /// the picture any more, it is the one of before; `None` where there is none.
    ///
    /// # Errors
    /// As [`Renderer::map_picture`].
    pub fn map(
        &mut self,
        side: usize,
        view: usize,
        look: MapLook,
        side_px: u32,
    ) -> Result<Option<egui::TextureId>, RenderError> {
        let picture = self.sides[side].map_picture(view, look, side_px)?;
        Ok(picture.map_or(self.map.id(), |picture| Some(self.map.show(&self.window, &picture))))
    }

    /// Lets requested pictures come. A browser does that by itself.
    pub fn poll(&self) {
        // A lost device is reported by its callback.
        let _ = self.gpu.device.poll(wgpu::PollType::Poll);
    }

    /// Returns the times of a side's frames that came since the last call.
    pub fn times(&mut self, side: usize) -> Vec<PassTimes> {
        self.sides.get_mut(side).map(Side::times).unwrap_or_default()
    }
}

impl Drop for Drawing {
    fn drop(&mut self) {
        for side in self.sides.drain(..) {
            side.free(&self.window);
        }
        std::mem::take(&mut self.map).free(&self.window);
    }
}
