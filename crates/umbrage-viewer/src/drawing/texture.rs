//! A texture of ours under a name that egui knows.

use eframe::{egui, egui_wgpu, wgpu};

/// A texture that egui shows. Its id stays the same while one texture after another is shown.
#[derive(Debug, Default)]
pub struct EguiTexture {
    id: Option<egui::TextureId>,
}

impl EguiTexture {
    /// Returns the id of what is shown; `None` before the first [`Self::show`].
    pub fn id(&self) -> Option<egui::TextureId> {
        self.id
    }

    /// Shows another texture, and returns the id.
    pub fn show(&mut self, window: &egui_wgpu::RenderState, picture: &wgpu::TextureView) -> egui::TextureId {
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

    /// Gives the id back to egui.
    pub fn free(self, window: &egui_wgpu::RenderState) {
        if let Some(id) = self.id {
            window.renderer.write().free_texture(&id);
        }
    }
}
