//! Pictures of one byte a pixel, and the way back from the device.

use umbrage_render::{Gpu, RenderError};

/// A texture that is drawn into, of one byte a pixel.
#[derive(Debug)]
pub(crate) struct Picture {
    texture: wgpu::Texture,
    pub view: wgpu::TextureView,
}

impl Picture {
    /// Makes a texture that shaders may read too.
    pub fn new(gpu: &Gpu, label: &str, size: [u32; 2], format: wgpu::TextureFormat) -> Self {
        let read = wgpu::TextureUsages::COPY_SRC | wgpu::TextureUsages::TEXTURE_BINDING;
        let texture = texture(gpu, label, size, format, read);
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Self { texture, view }
    }

    /// A copy of what was drawn, for [`Self::read`].
    pub fn copy(&self, gpu: &Gpu, encoder: &mut wgpu::CommandEncoder) -> Result<wgpu::Buffer, RenderError> {
        let size = self.texture.size();
        let row = size.width.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let descriptor = wgpu::BufferDescriptor {
            label: Some("Picture::copy"),
            size: u64::from(row) * u64::from(size.height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        };
        let make = || Ok::<_, RenderError>(gpu.device.create_buffer(&descriptor));
        let buffer = gpu.allocate("a copy of the picture", make)?;
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
        let to = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
        encoder.copy_texture_to_buffer(self.texture.as_image_copy(), to, size);
        Ok(buffer)
    }

    /// The bytes of a copy, rows from top to bottom, waited for.
    pub fn read(&self, gpu: &Gpu, copy: wgpu::Buffer) -> Result<Vec<u8>, RenderError> {
        let width = self.texture.width() as usize;
        let row = width.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize);
        gpu.read_mapped(copy, |bytes| bytes.chunks(row).flat_map(|row| &row[..width]).copied().collect())
    }
}

/// Makes a texture of a picture's size.
pub(crate) fn texture(
    gpu: &Gpu,
    label: &str,
    [width, height]: [u32; 2],
    format: wgpu::TextureFormat,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | usage,
        view_formats: &[],
    })
}

/// A pipeline that covers the picture.
pub(crate) fn over_all(
    gpu: &Gpu,
    module: &wgpu::ShaderModule,
    fragment: &str,
    depth_stencil: Option<wgpu::DepthStencilState>,
    targets: &[Option<wgpu::ColorTargetState>],
) -> wgpu::RenderPipeline {
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(fragment),
        layout: None,
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("whole_picture"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets,
        }),
        multiview_mask: None,
        cache: None,
    })
}
