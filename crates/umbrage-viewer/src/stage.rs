//! A world on the device, drawn one or two ways into textures that a window shows.

use std::collections::VecDeque;
use std::sync::Arc;

use eframe::{egui, egui_wgpu, wgpu};
use umbrage::{Settings, ShadowPlan};
use umbrage_render::{ComingPicture, Drawn, Frame, Gpu, MapLook, RenderError, Renderer, ViewLoad};
use umbrage_scene::Scene;

use crate::blit::Blit;

/// Frames whose times may be on their way at once; of more, the newest are lost.
const PENDING: usize = 3;

/// Milliseconds of a frame: planning on the CPU; casters, filter and shading on the device.
pub type PassTimes = [f64; 4];

/// A world and how it is drawn.
pub struct Stage {
    scene: Arc<Scene>,
    gpu: Gpu,
    window: egui_wgpu::RenderState,
    sides: Vec<Side>,
    map: Shown,
    blit: Option<Blit>,
}

/// One way to draw it.
struct Side {
    renderer: Renderer,
    /// The picture as a texture, and what egui knows it as where egui puts it on the screen.
    shown: Option<wgpu::TextureView>,
    picture: Shown,
    /// What is in the picture.
    frame: Option<Frame>,
    /// The picture itself: it is held as long as it is shown.
    drawn: Option<Drawn>,
    /// Of frames whose times have not come yet: what planning took, or `None` where times are not wanted.
    awaited: VecDeque<Option<f64>>,
}

impl std::fmt::Debug for Stage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stage").field("scene", &self.scene.name).field("sides", &self.sides.len()).finish()
    }
}

impl Stage {
    /// Uploads a scene.
    ///
    /// # Errors
    /// As [`Renderer::new`].
    pub fn new(
        gpu: &Gpu,
        window: &egui_wgpu::RenderState,
        scene: Arc<Scene>,
        settings: &Settings,
    ) -> Result<Self, RenderError> {
        let renderer = Renderer::new(gpu, &scene, settings.clone())?;
        Ok(Self {
            scene,
            gpu: gpu.clone(),
            window: window.clone(),
            sides: vec![Side::new(renderer)],
            map: Shown::default(),
            blit: Blit::new(window),
        })
    }

    /// What is on it.
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// How many ways it is drawn.
    pub fn sides(&self) -> usize {
        self.sides.len()
    }

    /// Draws it in as many ways as there are settings. What was drawn otherwise before is drawn anew by the next
    /// [`Self::draw`].
    ///
    /// # Errors
    /// As [`Renderer::set_settings`]; then everything stays as it was.
    pub fn set_settings(&mut self, settings: &[Settings]) -> Result<(), RenderError> {
        for (i, wanted) in settings.iter().enumerate() {
            match self.sides.get_mut(i) {
                None => {
                    let renderer = self.sides[0].renderer.beside(wanted.clone())?;
                    self.sides.push(Side::new(renderer));
                }
                Some(side) => {
                    side.renderer.set_settings(wanted.clone())?;
                    side.frame = None;
                }
            }
        }
        for side in self.sides.drain(settings.len().max(1)..) {
            side.picture.free(&self.window);
        }
        Ok(())
    }

    /// Draws a side's frame, unless it is in the picture already. Whether it was drawn.
    ///
    /// # Errors
    /// As [`Renderer::draw`]; then the picture stays as it was.
    pub fn draw(&mut self, side: usize, frame: &Frame) -> Result<bool, RenderError> {
        let side = &mut self.sides[side];
        if side.frame.as_ref() == Some(frame) {
            return Ok(false);
        }
        let drawn = side.renderer.draw(frame)?;
        let shown = drawn.shown()?;
        if self.blit.is_none() {
            side.picture.show(&self.window, &shown);
        }
        side.shown = Some(shown);
        side.awaited.push_back(Some(drawn.plan_milliseconds()));
        side.frame = Some(frame.clone());
        side.drawn = Some(drawn);
        Ok(true)
    }

    /// Draws the first side's picture once more as it is seen from elsewhere, and waits for it: how long that took,
    /// milliseconds, and its size, pixels. `None` before the first picture.
    ///
    /// # Errors
    /// As [`Renderer::render`].
    #[cfg(not(target_arch = "wasm32"))]
    pub fn time_alone(
        &mut self,
        camera: &umbrage_scene::Camera,
    ) -> Result<Option<(f64, [u32; 2])>, RenderError> {
        let side = &mut self.sides[0];
        let Some(frame) = side.frame.clone() else { return Ok(None) };
        side.frame = None;
        let size = [frame.width, frame.height];
        // Times that nobody asked for would be taken for this frame's.
        while side.renderer.pass_times().is_some() {}
        side.awaited.clear();
        let camera = umbrage_render::camera(camera, frame.width as f32 / frame.height as f32)?;
        let times = side.renderer.render(&Frame { camera, ..frame })?.times;
        Ok(Some((times.frame, size)))
    }

    /// Draws something else of a side to be read, beside its picture: from the picture's own maps, where it has any.
    ///
    /// # Errors
    /// As [`Renderer::draw`].
    pub fn ask(&mut self, side: usize, frame: &Frame) -> Result<ComingPicture, RenderError> {
        let Side { renderer, drawn, awaited, .. } = &mut self.sides[side];
        let has_maps = |drawn: &&Drawn| !drawn.plan().views().is_empty() && renderer.has_maps_of(drawn);
        let beside = match drawn.as_ref().filter(has_maps) {
            Some(drawn) => renderer.show(drawn, &frame.show)?,
            None => renderer.draw(frame)?,
        };
        awaited.push_back(None);
        beside.coming_picture()
    }

    /// A side's picture as it is, on its way to be saved.
    ///
    /// # Errors
    /// When nothing was drawn yet.
    pub fn picture_to_save(&mut self, side: usize) -> Result<Option<ComingPicture>, RenderError> {
        self.sides[side].drawn.as_ref().map(Drawn::coming_picture).transpose()
    }

    /// What covers a rectangle of the screen with a side's picture.
    pub fn picture(&self, side: usize, rect: egui::Rect) -> Option<egui::Shape> {
        let side = self.sides.get(side)?;
        if let Some(blit) = &self.blit {
            return Some(blit.shape(&self.window, side.shown.as_ref()?, rect));
        }
        let whole = egui::Rect::from_min_max(egui::Pos2::ZERO, egui::pos2(1.0, 1.0));
        Some(egui::Shape::image(side.picture.id?, rect, whole, egui::Color32::WHITE))
    }

    /// The plan of a side's picture.
    pub fn plan(&self, side: usize) -> Option<&ShadowPlan> {
        Some(self.sides.get(side)?.drawn.as_ref()?.plan())
    }

    /// What was drawn into each of its views.
    pub fn loads(&self, side: usize) -> &[ViewLoad] {
        self.sides.get(side).and_then(|side| side.drawn.as_ref()).map_or(&[], Drawn::loads)
    }

    /// Bytes of a side's maps and of what is made of them.
    pub fn bytes(&self, side: usize) -> u64 {
        self.sides.get(side).map_or(0, |side| side.renderer.shadows().bytes())
    }

    /// The tile of a view of the first side, painted; as it was painted before, where its maps are to be drawn anew.
    ///
    /// # Errors
    /// As [`Renderer::map_picture`]; and when nothing was drawn.
    pub fn map(
        &mut self,
        side: usize,
        view: usize,
        look: MapLook,
        side_px: u32,
    ) -> Result<egui::TextureId, RenderError> {
        let Side { renderer, drawn, .. } = &mut self.sides[side];
        let drawn = drawn.as_ref().ok_or(RenderError::NoSuchView { view, views: 0 })?;
        if let Some(id) = self.map.id.filter(|_| !renderer.has_maps_of(drawn)) {
            return Ok(id);
        }
        let picture = renderer.map_picture(drawn, view, look, side_px)?;
        Ok(self.map.show(&self.window, &picture))
    }

    /// Lets what was asked for come. A browser does that by itself.
    pub fn poll(&self) {
        // A device that is lost says so elsewhere.
        let _ = self.gpu.device.poll(wgpu::PollType::Poll);
    }

    /// Times of the frames of a side that came since the last call.
    pub fn times(&mut self, side: usize) -> Vec<PassTimes> {
        let Some(Side { renderer, awaited, .. }) = self.sides.get_mut(side) else { return Vec::new() };
        let mut times = Vec::new();
        while let Some([casters, filter, shade]) = renderer.pass_times() {
            if let Some(Some(plan)) = awaited.pop_front() {
                times.push([plan, casters, filter, shade]);
            }
        }
        // As many as the device's clock keeps; without timestamps none ever come.
        awaited.truncate(PENDING);
        times
    }
}

impl Drop for Stage {
    fn drop(&mut self) {
        for side in self.sides.drain(..) {
            side.picture.free(&self.window);
        }
        std::mem::take(&mut self.map).free(&self.window);
    }
}

impl Side {
    fn new(renderer: Renderer) -> Self {
        Self {
            renderer,
            shown: None,
            picture: Shown::default(),
            frame: None,
            drawn: None,
            awaited: VecDeque::new(),
        }
    }
}

/// A texture that egui shows; the same name for one texture after another.
#[derive(Debug, Default)]
struct Shown {
    id: Option<egui::TextureId>,
}

impl Shown {
    fn show(&mut self, window: &egui_wgpu::RenderState, picture: &wgpu::TextureView) -> egui::TextureId {
        let (device, mut renderer) = (&window.device, window.renderer.write());
        let nearest = wgpu::FilterMode::Nearest;
        match self.id {
            Some(id) => {
                renderer.update_egui_texture_from_wgpu_texture(device, picture, nearest, id);
                id
            }
            None => *self.id.insert(renderer.register_native_texture(device, picture, nearest)),
        }
    }

    fn free(self, window: &egui_wgpu::RenderState) {
        if let Some(id) = self.id {
            window.renderer.write().free_texture(&id);
        }
    }
}
