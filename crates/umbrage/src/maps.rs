//! The shadow maps themselves: one depth texture, in layers or as an atlas, and its texels read back.

use umbrage_core::{DepthFormat, MapLayout, MapTexels, ShadowView, Tile};
use umbrage_wgsl::clear;

use crate::capabilities::Capabilities;
use crate::coming::Coming;
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
        Ok(ComingMaps { coming, layout: self.layout })
    }
}

/// Texels of the maps on their way to the CPU, which nobody waits for: a page may not, since nothing comes while it does.
///
/// ```no_run
/// # fn look(device: &wgpu::Device, queue: &wgpu::Queue, shadows: &umbrage::Shadows) -> Result<(), umbrage::ShadowError> {
/// let mut encoder = device.create_command_encoder(&Default::default());
/// let coming = shadows.copy_maps(device, &mut encoder)?;
/// queue.submit([encoder.finish()]);
/// // In each frame from then on, until they have come:
/// if let Some(maps) = coming.take() {
///     println!("{} depths", maps?.depths.len());
/// }
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct ComingMaps {
    coming: Coming,
    layout: MapLayout,
}

impl ComingMaps {
    /// Returns the texels once, when they have come; `None` before that and after it.
    ///
    /// # Errors
    /// When the device is lost, or the commands were dropped that the copy was recorded among.
    pub fn take(&self) -> Option<Result<MapTexels, ShadowError>> {
        let read =
            self.coming.read(|bytes| MapTexels { layout: self.layout, depths: depths(bytes, self.layout) });
        read.map(|read| read.map_err(ShadowError::ReadBack))
    }
}

/// The bytes from one row of a copy to the next.
fn stride(layout: MapLayout) -> u32 {
    (layout.width * layout.depth.bytes() as u32).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT)
}

/// The depths of a copy.
fn depths(bytes: &[u8], layout: MapLayout) -> Vec<f32> {
    let row = |row: &[u8]| -> Vec<f32> {
        let row = &row[..layout.width as usize * layout.depth.bytes() as usize];
        match layout.depth {
            DepthFormat::F32 => bytemuck::pod_collect_to_vec(row),
            DepthFormat::U16 => {
                let steps: Vec<u16> = bytemuck::pod_collect_to_vec(row);
                steps.into_iter().map(|step| f32::from(step) / 65535.0).collect()
            }
        }
    };
    bytes.chunks_exact(stride(layout) as usize).flat_map(row).collect()
}
