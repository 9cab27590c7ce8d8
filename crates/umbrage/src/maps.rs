//! The shadow maps themselves: one depth texture, in layers or as an atlas, and its texels read back.

use umbrage_core::{DepthFormat, MapLayout, MapTexels, ShadowView, Tile};

use crate::capabilities::Capabilities;
use crate::error::ShadowError;

/// The depth texture that all views share.
#[derive(Debug)]
pub(crate) struct Maps {
    pub layout: MapLayout,
    texture: wgpu::Texture,
    /// All layers, for lookups.
    pub all: wgpu::TextureView,
    /// One a layer, for drawing.
    layers: Vec<wgpu::TextureView>,
}

impl Maps {
    pub fn new(
        device: &wgpu::Device,
        layout: MapLayout,
        capabilities: Capabilities,
    ) -> Result<Self, ShadowError> {
        let limits = device.limits();
        let (most, most_layers) = (limits.max_texture_dimension_2d, limits.max_texture_array_layers);
        let (width, height) = (layout.width, layout.height);
        if width > most || height > most || layout.layers > most_layers {
            return Err(ShadowError::TooLarge { width, height, layers: layout.layers, most, most_layers });
        }
        Ok(Self::of(device, layout, capabilities))
    }

    /// As [`Self::new`], for a layout that is within the limits.
    pub fn of(device: &wgpu::Device, layout: MapLayout, capabilities: Capabilities) -> Self {
        let (width, height) = (layout.width, layout.height);
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("Maps::texture"),
            size: wgpu::Extent3d {
                width,
                height,
                depth_or_array_layers: layout.layers.max(capabilities.least_layers),
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
        let all = texture.create_view(&wgpu::TextureViewDescriptor {
            label: Some("Maps::all"),
            dimension: Some(wgpu::TextureViewDimension::D2Array),
            ..Default::default()
        });
        let layers = (0..layout.layers)
            .map(|layer| {
                texture.create_view(&wgpu::TextureViewDescriptor {
                    label: Some("Maps::layer"),
                    dimension: Some(wgpu::TextureViewDimension::D2),
                    base_array_layer: layer,
                    array_layer_count: Some(1),
                    ..Default::default()
                })
            })
            .collect();
        Self { layout, texture, all, layers }
    }

    /// Size of the texture, texels.
    pub fn size(&self) -> [u32; 2] {
        [self.texture.width(), self.texture.height()]
    }

    /// Starts drawing a view's tile. The first view that is drawn into a layer clears it.
    pub fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> wgpu::RenderPass<'e> {
        let Tile { layer, x, y, size } = view.tile;
        let is_first = view.index == 0 || self.layout.layers > 1;
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("Shadows::caster_pass"),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.layers[layer as usize],
                depth_ops: Some(wgpu::Operations {
                    load: if is_first { wgpu::LoadOp::Clear(1.0) } else { wgpu::LoadOp::Load },
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            timestamp_writes,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        pass.set_viewport(x as f32, y as f32, size as f32, size as f32, 0.0, 1.0);
        pass.set_scissor_rect(x, y, size, size);
        pass
    }

    /// Copies all texels to the CPU, and waits for them.
    pub fn read(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> Result<MapTexels, ShadowError> {
        let bytes = self.layout.depth.bytes() as u32;
        let [width, height] = self.size();
        let stride = (width * bytes).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let size = u64::from(stride) * u64::from(height) * u64::from(self.layout.layers);
        let most = device.limits().max_buffer_size;
        if size > most {
            return Err(ShadowError::CopyTooLarge { bytes: size, most });
        }
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("Maps::read"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder =
            device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("Maps::read") });
        encoder.copy_texture_to_buffer(
            wgpu::TexelCopyTextureInfo {
                texture: &self.texture,
                mip_level: 0,
                origin: wgpu::Origin3d::ZERO,
                aspect: wgpu::TextureAspect::DepthOnly,
            },
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(stride),
                    rows_per_image: Some(height),
                },
            },
            wgpu::Extent3d { width, height, depth_or_array_layers: self.layout.layers },
        );
        queue.submit([encoder.finish()]);
        let failed = |error: &dyn std::fmt::Display| ShadowError::ReadBack(error.to_string());
        let (sender, receiver) = std::sync::mpsc::channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // The receiver lives until the result has come.
            let _ = sender.send(result);
        });
        device.poll(wgpu::PollType::wait_indefinitely()).map_err(|e| failed(&e))?;
        receiver.recv().map_err(|e| failed(&e))?.map_err(|e| failed(&e))?;
        let mapped = buffer.get_mapped_range(..).map_err(|e| failed(&e))?;
        let row = |row: &[u8]| -> Vec<f32> {
            let row = &row[..(width * bytes) as usize];
            match self.layout.depth {
                DepthFormat::F32 => row.as_chunks().0.iter().map(|b| f32::from_le_bytes(*b)).collect(),
                DepthFormat::U16 => {
                    row.as_chunks().0.iter().map(|b| f32::from(u16::from_le_bytes(*b)) / 65535.0).collect()
                }
            }
        };
        let depths = mapped.chunks_exact(stride as usize).flat_map(row).collect();
        Ok(MapTexels { layout: self.layout, depths })
    }
}

/// What a texel of the texture is.
pub(crate) fn texture_format(depth: DepthFormat) -> wgpu::TextureFormat {
    match depth {
        DepthFormat::F32 => wgpu::TextureFormat::Depth32Float,
        DepthFormat::U16 => wgpu::TextureFormat::Depth16Unorm,
    }
}
