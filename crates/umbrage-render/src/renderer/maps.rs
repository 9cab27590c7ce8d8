//! The shadow maps of a frame that was drawn: read, queried, or painted.

use std::sync::Arc;

use glam::Vec2;
use umbrage::{ComingMaps, MapTexels};

use super::Renderer;
use crate::drawn::{Drawn, Planned};
use crate::error::RenderError;
use crate::passes::map_picture::{MapLook, MapPicture};
use crate::passes::query::{MOST_AT_ONCE, Point, Query, QueryPass};
use crate::picture::{ComingPicture, Picture};

impl Renderer {
    /// Says whether the shadow maps are still those of a frame: whether nothing was drawn into them since, and no settings
    /// made other ones.
    pub fn has_maps_of(&self, drawn: &Drawn) -> bool {
        drawn.planned.maps == self.maps
    }

    /// The plan of a frame whose maps there are.
    pub(super) fn with_maps_of<'a>(&self, drawn: &'a Drawn) -> Result<&'a Arc<Planned>, RenderError> {
        if self.has_maps_of(drawn) { Ok(&drawn.planned) } else { Err(RenderError::MapsGone) }
    }

    /// Copies the shadow maps of a frame to the CPU, and waits for them.
    ///
    /// # Errors
    /// [`RenderError::MapsGone`] when they are not the frame's any more; when the device fails, or cannot copy depth (GL).
    pub fn maps(&self, drawn: &Drawn) -> Result<MapTexels, RenderError> {
        self.with_maps_of(drawn)?;
        Ok(self.shadows.read_maps(&self.gpu.device, &self.gpu.queue)?)
    }

    /// Starts to copy the shadow maps of a frame to the CPU without waiting: [`ComingMaps::take`] has them when they have come.
    ///
    /// # Errors
    /// [`RenderError::MapsGone`] when they are not the frame's any more; when the device cannot copy depth (GL), or the maps
    /// exceed its buffers.
    pub fn coming_maps(&self, drawn: &Drawn) -> Result<ComingMaps, RenderError> {
        self.with_maps_of(drawn)?;
        let mut encoder = self.gpu.encoder("Renderer::coming_maps");
        let coming = self.shadows.copy_maps(&self.gpu.device, &mut encoder)?;
        self.gpu.queue.submit([encoder.finish()]);
        Ok(coming)
    }

    /// Returns how much of a light the shadow maps of a frame let through to points, from 0 to 1. Whether the camera sees
    /// the points does not matter.
    ///
    /// # Errors
    /// [`RenderError::MapsGone`] when the maps are not the frame's any more; when the frame has no shadows of that light, or
    /// the device fails.
    pub fn query(&mut self, drawn: &Drawn, light: usize, points: &[Point]) -> Result<Vec<f32>, RenderError> {
        let planned = self.with_maps_of(drawn)?;
        planned.has_shadows_of(light)?;
        // A renderer beside this one may have moved what rays go through.
        self.scene.move_to(&self.gpu, &self.timer, planned.origin, &planned.pose)?;
        let [width, height] = planned.size.map(|side| side as f32);
        let origin = planned.origin;
        let clip_from_world = planned.camera.relative_to(origin).clip_from_world();
        let query = Query { clip_from_world, size: Vec2::new(width, height), light: light as u32 };
        let Self { gpu, shadows, query: pass, .. } = self;
        let pass = pass.get_or_insert_with(|| QueryPass::new(gpu, shadows));
        let mut answers = Vec::with_capacity(points.len());
        for points in points.chunks(MOST_AT_ONCE) {
            let queries = pass.upload(gpu, &query, origin, points)?;
            let mut encoder = gpu.encoder("Renderer::query");
            pass.record(&mut encoder, shadows, &queries);
            gpu.queue.submit([encoder.finish()]);
            answers.extend(gpu.read_floats(&queries.answers, queries.count)?);
        }
        Ok(answers)
    }

    /// Paints the tile of view number `view` of a frame's plan, as a picture of `side` by `side` pixels of bytes to be read
    /// as they are: nearest texels, so that what is stored can be seen. The picture is the caller's.
    ///
    /// # Errors
    /// [`RenderError::MapsGone`] when the maps are not the frame's any more; when the frame has no such view, or shaders
    /// cannot read depths as numbers (GL).
    pub fn map_picture(
        &mut self,
        drawn: &Drawn,
        view: usize,
        look: MapLook,
        side: u32,
    ) -> Result<wgpu::TextureView, RenderError> {
        let views = self.with_maps_of(drawn)?.plan.views();
        let Some(tile) = views.get(view).map(|view| view.tile) else {
            return Err(RenderError::NoSuchView { view, views: views.len() });
        };
        if self.gpu.adapter.backend == wgpu::Backend::Gl.to_str() {
            return Err(RenderError::NoWindow { adapter: self.gpu.adapter.name.clone() });
        }
        let Self { gpu, shadows, map_picture: pass, .. } = self;
        let pass = pass.get_or_insert_with(|| MapPicture::new(gpu));
        let mut encoder = gpu.encoder("Renderer::map_picture");
        let picture = pass.record(gpu, &mut encoder, shadows, (view, tile.size), look, side)?;
        gpu.queue.submit([encoder.finish()]);
        Ok(picture)
    }

    /// Paints a tile as [`Self::map_picture`] does, copies the picture to the CPU, and waits for it.
    ///
    /// # Errors
    /// As [`Self::map_picture`], and when the device fails.
    pub fn read_map_picture(
        &mut self,
        drawn: &Drawn,
        view: usize,
        look: MapLook,
        side: u32,
    ) -> Result<Picture, RenderError> {
        let painted = self.map_picture(drawn, view, look, side)?;
        ComingPicture::of_texture(&self.gpu, painted.texture())?.wait(&self.gpu)
    }
}
