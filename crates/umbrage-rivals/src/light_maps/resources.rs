//! What the pass holds on the device: the atlas, the pictures that it draws, and the pipeline that reads one into the other.

use umbrage_render::{Gpu, RenderError};

use super::unwrap::Unwrapped;
use crate::buffers::bind;
use crate::picture::texture;

/// Depth is reversed: 1 near and 0 far.
pub(super) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// The visibility of three lights, and whether it is known.
pub(super) const COLOUR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// What a picture of some size is drawn into.
#[derive(Debug)]
pub(super) struct Targets {
    pub size: [u32; 2],
    pub colour: wgpu::Texture,
    pub depth: wgpu::Texture,
}

impl Targets {
    pub fn new(gpu: &Gpu, size: [u32; 2]) -> Result<Self, RenderError> {
        gpu.allocate("the picture", || {
            let colour = texture(gpu, "Targets::colour", size, COLOUR_FORMAT, wgpu::TextureUsages::COPY_SRC);
            let depth = texture(gpu, "Targets::depth", size, DEPTH_FORMAT, wgpu::TextureUsages::empty());
            Ok::<_, RenderError>(Self { size, colour, depth })
        })
    }

    /// The bytes that the textures hold.
    pub fn bytes(&self) -> u64 {
        let a_pixel = 4 + 4;
        u64::from(self.size[0]) * u64::from(self.size[1]) * a_pixel
    }
}

/// A buffer with something in it. It is not mapped, since one that there is no room for cannot be.
pub(super) fn filled(gpu: &Gpu, label: &str, contents: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        // A buffer of no bytes cannot be bound.
        size: contents.len().max(16) as u64,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue.write_buffer(&buffer, 0, contents);
    buffer
}

/// The atlas, one layer a page and light.
pub(super) fn atlas(gpu: &Gpu, unwrapped: &Unwrapped, texels: &[u8]) -> wgpu::TextureView {
    let [width, height] = unwrapped.size;
    let layers = (texels.len() / (width as usize * height as usize)) as u32;
    let atlas = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("Pass::atlas"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: layers.max(1) },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::R8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let rows =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(width), rows_per_image: Some(height) };
    let copied = wgpu::Extent3d { width, height, depth_or_array_layers: layers };
    gpu.queue.write_texture(atlas.as_image_copy(), texels, rows, copied);
    atlas.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        ..Default::default()
    })
}

/// What the shader reads.
pub(super) fn group(
    gpu: &Gpu,
    pipeline: &wgpu::RenderPipeline,
    [places, lights]: [&wgpu::Buffer; 2],
    atlas: &wgpu::TextureView,
) -> wgpu::BindGroup {
    let bilinear = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("Pass::bilinear"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    });
    let resources = [
        (0, places.as_entire_binding()),
        (1, wgpu::BindingResource::TextureView(atlas)),
        (2, wgpu::BindingResource::Sampler(&bilinear)),
        (3, lights.as_entire_binding()),
    ];
    bind(gpu, &pipeline.get_bind_group_layout(0), &resources)
}

/// The pipeline: everything is drawn from both sides, and the nearest is kept.
pub(super) fn pipeline(gpu: &Gpu) -> wgpu::RenderPipeline {
    let module = gpu.device.create_shader_module(wgpu::include_wgsl!("read.wgsl"));
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("Pass::pipeline"),
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("surface"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[
                Some(wgpu::VertexBufferLayout {
                    array_stride: 12,
                    step_mode: wgpu::VertexStepMode::Vertex,
                    attributes: &wgpu::vertex_attr_array![0 => Float32x3],
                }),
                Some(wgpu::VertexBufferLayout {
                    array_stride: 4,
                    step_mode: wgpu::VertexStepMode::Vertex,
                    attributes: &wgpu::vertex_attr_array![1 => Unorm16x2],
                }),
            ],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH_FORMAT,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Greater),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("reach"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(COLOUR_FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
