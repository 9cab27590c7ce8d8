//! Where a frame is drawn when there is no window, and the picture that comes of it.

use crate::error::RenderError;
use crate::gpu::{Coming, Gpu};

/// A picture on the CPU, rows from top to bottom: sRGB, or linear where it shows visibility.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// `4 · width · height` bytes.
    pub rgba: Vec<u8>,
}

/// What colour targets are. Visibility is drawn into the linear one, so that ½ is stored as 128.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Encoding {
    #[default]
    Srgb,
    Linear,
}

impl Encoding {
    pub fn format(self) -> wgpu::TextureFormat {
        match self {
            Self::Srgb => wgpu::TextureFormat::Rgba8UnormSrgb,
            Self::Linear => wgpu::TextureFormat::Rgba8Unorm,
        }
    }
}

pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Textures of one size, made anew when the size changes.
#[derive(Debug)]
pub(crate) struct Target {
    pub width: u32,
    pub height: u32,
    pub samples: u32,
    resolved: wgpu::Texture,
    pub resolved_view: wgpu::TextureView,
    multisampled: Option<wgpu::TextureView>,
    depth: wgpu::TextureView,
}

impl Target {
    pub fn new(
        gpu: &Gpu,
        width: u32,
        height: u32,
        encoding: Encoding,
        samples: u32,
    ) -> Result<Self, RenderError> {
        let most = gpu.device.limits().max_texture_dimension_2d;
        if width == 0 || height == 0 || width > most || height > most {
            return Err(RenderError::PictureSize { width, height, most });
        }
        // As a window wants it: the bytes as they are, not the light that they stand for.
        let bytes: &[_] = if gpu.adapter.view_formats { &[wgpu::TextureFormat::Rgba8Unorm] } else { &[] };
        let texture = |label, format, sample_count, usage| {
            gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | usage,
                view_formats: if format == wgpu::TextureFormat::Rgba8UnormSrgb { bytes } else { &[] },
            })
        };
        let none = wgpu::TextureUsages::empty();
        let view = |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        let read = wgpu::TextureUsages::COPY_SRC | wgpu::TextureUsages::TEXTURE_BINDING;
        let resolved = texture("Target::resolved", encoding.format(), 1, read);
        let multisampled =
            (samples > 1).then(|| view(&texture("Target::multisampled", encoding.format(), samples, none)));
        let depth = view(&texture("Target::depth", DEPTH_FORMAT, samples, none));
        Ok(Self { width, height, samples, resolved_view: view(&resolved), resolved, multisampled, depth })
    }

    /// Starts a pass over the whole target: colour and (reversed) depth cleared.
    pub fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> wgpu::RenderPass<'e> {
        let (view, resolve_target) = match &self.multisampled {
            Some(multisampled) => (multisampled, Some(&self.resolved_view)),
            None => (&self.resolved_view, None),
        };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("Target::pass"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                    store: if resolve_target.is_some() {
                        wgpu::StoreOp::Discard
                    } else {
                        wgpu::StoreOp::Store
                    },
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            timestamp_writes,
            occlusion_query_set: None,
            multiview_mask: None,
        })
    }

    /// The picture as a window shows it: sRGB bytes, to be read as they are.
    pub fn shown(&self) -> wgpu::TextureView {
        self.resolved.create_view(&wgpu::TextureViewDescriptor {
            format: Some(wgpu::TextureFormat::Rgba8Unorm),
            usage: Some(wgpu::TextureUsages::TEXTURE_BINDING),
            ..Default::default()
        })
    }

    /// Starts to copy the picture to the CPU.
    pub fn request(&self, gpu: &Gpu) -> Result<ComingPicture, RenderError> {
        ComingPicture::of_texture(gpu, &self.resolved)
    }

    /// Copies the picture to the CPU, and waits for it.
    pub fn read(&self, gpu: &Gpu) -> Result<Picture, RenderError> {
        let coming = self.request(gpu)?;
        gpu.wait()?;
        coming.take().unwrap_or_else(|| Err(RenderError::Device("the picture did not come".to_owned())))
    }
}

/// A picture on its way to the CPU.
#[derive(Debug)]
pub struct ComingPicture {
    bytes: Coming,
    width: u32,
    height: u32,
    stride: u32,
}

impl ComingPicture {
    /// Starts to copy a texture of four bytes a texel to the CPU.
    ///
    /// # Errors
    /// When it exceeds the adapter's buffers.
    pub fn of_texture(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Self, RenderError> {
        let (width, height) = (texture.width(), texture.height());
        let stride = (width * 4).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let size = u64::from(stride) * u64::from(height);
        let most = gpu.device.limits().max_buffer_size;
        if size > most {
            return Err(RenderError::TooLarge { what: "picture", bytes: size, most });
        }
        let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("ComingPicture::buffer"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(stride),
                    rows_per_image: Some(height),
                },
            },
            wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        );
        gpu.queue.submit([encoder.finish()]);
        Ok(ComingPicture { bytes: Coming::new(buffer), width, height, stride })
    }

    /// The picture, once; `None` where it has not come yet. Never waits: poll the device, or submit, between two calls.
    ///
    /// # Errors
    /// When the device fails.
    pub fn take(&self) -> Option<Result<Picture, RenderError>> {
        let Self { bytes, width, height, stride } = self;
        let rgba = bytes.take(|bytes| {
            let rows = bytes.chunks_exact(*stride as usize);
            rows.flat_map(|row| &row[..*width as usize * 4]).copied().collect()
        })?;
        Some(rgba.map(|rgba| Picture { width: *width, height: *height, rgba }))
    }
}
