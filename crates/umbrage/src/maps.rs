//! The shadow maps themselves: one depth texture, in layers or as an atlas.

use umbrage_core::{MapLayout, ShadowView, Tile};
use umbrage_wgsl::clear;

use crate::capabilities::Capabilities;
use crate::coming::Coming;
use crate::coming_maps::{ComingMaps, stride};
use crate::depth_pipeline::{DepthPipeline, depth_pipeline, texture_format};
use crate::error::ShadowError;
use crate::objects::Objects;

/// The depth texture that all views share.
#[derive(Clone, Debug)]
pub(crate) struct Maps {
    pub layout: MapLayout,
    texture: wgpu::Texture,
    /// All layers, for lookups.
    pub all: wgpu::TextureView,
    /// One a layer, for drawing.
    layers: Vec<wgpu::TextureView>,
    /// Empties one tile; only where a layer may hold several.
    pub clear: Option<wgpu::RenderPipeline>,
}

/// Whether a layout is within an adapter's limits.
pub(crate) fn check_size(device: &wgpu::Device, layout: MapLayout) -> Result<(), ShadowError> {
    let limits = device.limits();
    let (max, max_layers) = (limits.max_texture_dimension_2d, limits.max_texture_array_layers);
    let MapLayout { width, height, layers, depth: _ } = layout;
    if width > max || height > max || layers > max_layers {
        return Err(ShadowError::TooLarge { width, height, layers, max, max_layers });
    }
    Ok(())
}

/// The pipeline that empties a tile; `None` where every layer holds one tile, so that the pass can empty it.
pub(crate) fn clear_pipeline(objects: &Objects<'_>, layout: MapLayout) -> Option<wgpu::RenderPipeline> {
    (layout.layers == 1).then(|| {
        let module = objects.shader("Maps::clear", &clear());
        let entry_points = ("clear", None);
        let label = "Maps::clear";
        depth_pipeline(
            objects,
            &DepthPipeline { label, module: &module, entry_points, group: None, depth: layout.depth },
        )
    })
}

impl Maps {
    /// Maps that lie so; the layout is within the limits of [`check_size`].
    pub fn new(
        objects: &Objects<'_>,
        layout: MapLayout,
        capabilities: Capabilities,
        clear: Option<&wgpu::RenderPipeline>,
    ) -> Self {
        let (width, height) = (layout.width, layout.height);
        let texture = objects.texture(&wgpu::TextureDescriptor {
            label: Some("Maps::texture"),
            size: wgpu::Extent3d {
                width,
                height,
                depth_or_array_layers: layout.layers.max(capabilities.min_layers),
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: texture_format(layout.depth),
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | if capabilities.read_back {
                    wgpu::TextureUsages::COPY_SRC
                } else {
                    wgpu::TextureUsages::empty()
                },
            view_formats: &[],
        });
        let view = |label, dimension, base_array_layer, array_layer_count| {
            let descriptor = wgpu::TextureViewDescriptor {
                label: Some(label),
                dimension: Some(dimension),
                base_array_layer,
                array_layer_count,
                ..Default::default()
            };
            objects.view(&texture, &descriptor)
        };
        let all = view("Maps::all", wgpu::TextureViewDimension::D2Array, 0, None);
        let layers = (0..layout.layers)
            .map(|layer| view("Maps::layer", wgpu::TextureViewDimension::D2, layer, Some(1)))
            .collect();
        Self { layout, texture, all, layers, clear: clear.cloned() }
    }

    /// Size of the texture, texels.
    pub fn size(&self) -> [u32; 2] {
        [self.texture.width(), self.texture.height()]
    }

    /// Whether a tile lies in the texture.
    pub fn holds(&self, tile: Tile) -> bool {
        let Tile { layer, x, y, size } = tile;
        let within = |start: u32, side: u32| start.checked_add(size).is_some_and(|end| end <= side);
        layer < self.layout.layers && within(x, self.layout.width) && within(y, self.layout.height)
    }

    /// Whether a tile is all that its layer holds.
    pub fn is_whole_layer(&self, tile: Tile) -> bool {
        self.clear.is_none() || self.layout.width == tile.size && self.layout.height == tile.size
    }

    /// Starts drawing an empty tile of a view.
    pub fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> wgpu::RenderPass<'e> {
        let mut pass = self.open(encoder, view.tile, timestamp_writes);
        self.enter(&mut pass, view.tile);
        pass
    }

    /// Starts drawing a tile of a view all over: what it held stays or not.
    pub fn overwrite<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
    ) -> wgpu::RenderPass<'e> {
        let mut pass = self.open(encoder, view.tile, None);
        self.go_to(&mut pass, view.tile);
        pass
    }

    /// Starts a pass on the layer of a tile, which is empty then if it holds no other.
    pub fn open<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        tile: Tile,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> wgpu::RenderPass<'e> {
        let load = if self.is_whole_layer(tile) { wgpu::LoadOp::Clear(0.0) } else { wgpu::LoadOp::Load };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("Shadows::caster_pass"),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.layers[tile.layer as usize],
                depth_ops: Some(wgpu::Operations { load, store: wgpu::StoreOp::Store }),
                stencil_ops: None,
            }),
            timestamp_writes,
            occlusion_query_set: None,
            multiview_mask: None,
        })
    }

    /// Goes on to a tile of the pass's layer, and empties it where the pass could not.
    pub fn enter(&self, pass: &mut wgpu::RenderPass<'_>, tile: Tile) {
        self.go_to(pass, tile);
        if let Some(clear) = self.clear.as_ref().filter(|_| !self.is_whole_layer(tile)) {
            pass.set_pipeline(clear);
            pass.draw(0..3, 0..1);
        }
    }

    /// Draws into a tile of the pass's layer alone from now on.
    pub fn go_to(&self, pass: &mut wgpu::RenderPass<'_>, tile: Tile) {
        let Tile { layer: _, x, y, size } = tile;
        pass.set_viewport(x as f32, y as f32, size as f32, size as f32, 0.0, 1.0);
        pass.set_scissor_rect(x, y, size, size);
    }

    /// Records a copy of all texels for the CPU.
    pub fn copy(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<ComingMaps, ShadowError> {
        let [width, height] = self.size();
        let layers = self.layout.layers;
        let stride = stride(self.layout);
        let size = u64::from(stride) * u64::from(height) * u64::from(layers);
        let max = device.limits().max_buffer_size;
        if size > max {
            return Err(ShadowError::CopyTooLarge { bytes: size, max });
        }
        let texture = wgpu::TexelCopyTextureInfo {
            aspect: wgpu::TextureAspect::DepthOnly,
            ..self.texture.as_image_copy()
        };
        let rows = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(stride),
            rows_per_image: Some(height),
        };
        let extent = wgpu::Extent3d { width, height, depth_or_array_layers: layers };
        let coming = Coming::copied(device, encoder, size, |encoder, buffer| {
            encoder.copy_texture_to_buffer(
                texture,
                wgpu::TexelCopyBufferInfo { buffer, layout: rows },
                extent,
            );
        });
        Ok(ComingMaps::new(coming, self.layout))
    }
}
