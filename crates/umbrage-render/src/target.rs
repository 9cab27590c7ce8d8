//! What a frame is drawn into.

use crate::error::RenderError;
use crate::frame::Show;
use crate::gpu::Gpu;
use crate::picture::{ComingPicture, Picture};

/// What colour targets are. Visibility is drawn into the linear one, so that ½ is stored as 128.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Srgb,
    Linear,
}

impl Encoding {
    /// What a picture is drawn into.
    pub fn of(show: &Show) -> Self {
        match show {
            Show::Visibility(_) | Show::Nothing => Self::Linear,
            Show::World | Show::Unshadowed | Show::Given(_) | Show::Marked(_) => Self::Srgb,
        }
    }

    pub fn format(self) -> wgpu::TextureFormat {
        match self {
            Self::Srgb => wgpu::TextureFormat::Rgba8UnormSrgb,
            Self::Linear => wgpu::TextureFormat::Rgba8Unorm,
        }
    }
}

pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// What tells targets apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    pub size: [u32; 2],
    pub encoding: Encoding,
    pub samples: u32,
}

impl Shape {
    /// The target of a picture; `size` and `samples` are the frame's.
    pub fn of(show: &Show, size: [u32; 2], samples: u32) -> Self {
        let (size, samples) = match show {
            Show::Nothing => ([1, 1], 1),
            Show::Visibility(_) | Show::Given(_) => (size, 1),
            Show::World | Show::Unshadowed | Show::Marked(_) => (size, if samples > 1 { 4 } else { 1 }),
        };
        Self { size, encoding: Encoding::of(show), samples }
    }
}

/// What a pass over a target finds there of the depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DepthBefore {
    /// Nothing: the pass clears it.
    Nothing,
    /// Some of it: the pass draws the rest.
    Some,
    /// All of it: the pass writes none, so that its shaders may read it.
    All,
}

/// Textures of one shape.
#[derive(Debug)]
pub(crate) struct Target {
    pub shape: Shape,
    resolved: wgpu::Texture,
    pub resolved_view: wgpu::TextureView,
    /// The same as a window shows it: sRGB bytes, to be read as they are. `None` where the adapter cannot (GL).
    pub shown: Option<wgpu::TextureView>,
    multisampled: Option<wgpu::TextureView>,
    pub depth: wgpu::TextureView,
}

impl Target {
    pub fn new(gpu: &Gpu, shape: Shape) -> Result<Self, RenderError> {
        let Shape { size: [width, height], encoding, samples } = shape;
        let most = gpu.device.limits().max_texture_dimension_2d;
        if width == 0 || height == 0 || width > most || height > most {
            return Err(RenderError::PictureSize { width, height, most });
        }
        // As a window wants it: the bytes as they are, not the light that they stand for.
        let bytes: &[_] = if gpu.adapter.view_formats { &[wgpu::TextureFormat::Rgba8Unorm] } else { &[] };
        let texture = |label, format, sample_count, usage| {
            gpu.texture(&wgpu::TextureDescriptor {
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
        let bound = if samples == 1 { wgpu::TextureUsages::TEXTURE_BINDING } else { none };
        let depth = view(&texture("Target::depth", DEPTH_FORMAT, samples, bound));
        let shown = gpu.adapter.view_formats.then(|| {
            resolved.create_view(&wgpu::TextureViewDescriptor {
                format: Some(wgpu::TextureFormat::Rgba8Unorm),
                usage: Some(wgpu::TextureUsages::TEXTURE_BINDING),
                ..Default::default()
            })
        });
        Ok(Self { shape, resolved_view: view(&resolved), resolved, shown, multisampled, depth })
    }

    /// Starts a pass over the whole target: colour cleared, and (reversed) depth where nothing of it is drawn.
    pub fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        depth: DepthBefore,
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
                depth_ops: match depth {
                    DepthBefore::Nothing => Some(wgpu::LoadOp::Clear(0.0)),
                    DepthBefore::Some => Some(wgpu::LoadOp::Load),
                    DepthBefore::All => None,
                }
                .map(|load| wgpu::Operations { load, store: wgpu::StoreOp::Discard }),
                stencil_ops: None,
            }),
            timestamp_writes,
            occlusion_query_set: None,
            multiview_mask: None,
        })
    }

    /// Starts to copy the picture to the CPU.
    pub fn request(&self, gpu: &Gpu) -> Result<ComingPicture, RenderError> {
        ComingPicture::of_texture(gpu, &self.resolved)
    }

    /// Copies the picture to the CPU, and waits for it.
    pub fn read(&self, gpu: &Gpu) -> Result<Picture, RenderError> {
        self.request(gpu)?.wait(gpu)
    }
}
