//! A shadow view's tile as a grey picture: near dark, as it is stored; or inverted, stretched, even in metres (R-VIEW-1).

use encase::{ShaderType, UniformBuffer};
use umbrage::{Shadows, map_wgsl};

use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::renderer::Renderer;
use crate::scene_buffers::filled;

/// How to look at a tile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MapLook {
    /// Whether near is light. Where not, near is dark, as depth is stored.
    pub invert: bool,
    /// Whether grey goes from the nearest depth that was drawn to the farthest.
    pub stretch: bool,
    /// Whether grey is even in metres along the light, whatever a lamp or a warp makes of depth.
    pub even: bool,
}

#[derive(Clone, Copy, Debug, ShaderType)]
struct LookUniform {
    view: u32,
    side: u32,
    invert: u32,
    stretch: u32,
    even: u32,
}

/// Texels of a workgroup's side, as in the shader.
const WORKGROUP: u32 = 8;

/// The pipelines that paint the tiles of some maps.
#[derive(Debug)]
pub(crate) struct MapPainter {
    layout: wgpu::BindGroupLayout,
    find_range: wgpu::ComputePipeline,
    paint: wgpu::ComputePipeline,
}

impl Renderer {
    /// The tile of view number `view` of the last frame's plan, as a picture of `side` by `side` pixels of bytes to be
    /// read as they are. Nearest texels, so that what is stored can be seen.
    ///
    /// # Errors
    /// When no frame was drawn, it has no such view, or shaders cannot read depths as numbers (GL).
    pub fn map_picture(
        &mut self,
        view: usize,
        look: MapLook,
        side: u32,
    ) -> Result<wgpu::TextureView, RenderError> {
        let views = self.views.len();
        let Some(&tile_size) = self.views.get(view) else {
            return Err(RenderError::NoSuchView { view, views });
        };
        if self.gpu.adapter.backend == wgpu::Backend::Gl.to_str() {
            return Err(RenderError::NoWindow { adapter: self.gpu.adapter.name.clone() });
        }
        let painter = self.map_painter.get_or_insert_with(|| MapPainter::new(&self.gpu));
        let MapLook { invert, stretch, even } = look;
        let [invert, stretch, even] = [invert, stretch, even].map(u32::from);
        let look = LookUniform { view: view as u32, side, invert, stretch, even };
        painter.paint(&self.gpu, &self.shadows, look, tile_size)
    }
}

impl MapPainter {
    fn new(gpu: &Gpu) -> Self {
        let device = &gpu.device;
        let layout = layout(device);
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("MapPainter::module"),
            source: wgpu::ShaderSource::Wgsl(
                (map_wgsl() + include_str!("../shaders/map_picture.wgsl")).into(),
            ),
        });
        let of_pipelines = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("MapPainter::pipeline_layout"),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = |entry_point| {
            device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some("MapPainter::pipeline"),
                layout: Some(&of_pipelines),
                module: &module,
                entry_point: Some(entry_point),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
        };
        Self { find_range: pipeline("find_range"), paint: pipeline("paint"), layout }
    }

    fn paint(
        &self,
        gpu: &Gpu,
        shadows: &Shadows,
        look: LookUniform,
        tile_size: u32,
    ) -> Result<wgpu::TextureView, RenderError> {
        let mut uniform = UniformBuffer::new(Vec::new());
        uniform.write(&look).map_err(|e| RenderError::Device(e.to_string()))?;
        let uniform = filled(gpu, "look", &uniform.into_inner(), wgpu::BufferUsages::UNIFORM)?;
        let nothing: [u32; 2] = [1.0f32.to_bits(), 0.0f32.to_bits()];
        let drawn = filled(gpu, "drawn depths", bytemuck::cast_slice(&nothing), wgpu::BufferUsages::STORAGE)?;
        let side = look.side.clamp(1, gpu.device.limits().max_texture_dimension_2d);
        let picture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("MapPainter::picture"),
            size: wgpu::Extent3d { width: side, height: side, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: wgpu::TextureUsages::STORAGE_BINDING
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let picture = picture.create_view(&wgpu::TextureViewDescriptor::default());
        let resources = [
            shadows.frame().as_entire_binding(),
            wgpu::BindingResource::TextureView(shadows.maps()),
            uniform.as_entire_binding(),
            drawn.as_entire_binding(),
            wgpu::BindingResource::TextureView(&picture),
        ];
        let entries: Vec<_> = (0..)
            .zip(resources)
            .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource })
            .collect();
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("MapPainter::group"),
            layout: &self.layout,
            entries: &entries,
        });
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_bind_group(0, &group, &[]);
            for (pipeline, size) in [(&self.find_range, tile_size), (&self.paint, side)] {
                pass.set_pipeline(pipeline);
                pass.dispatch_workgroups(size.div_ceil(WORKGROUP), size.div_ceil(WORKGROUP), 1);
            }
        }
        gpu.queue.submit([encoder.finish()]);
        Ok(picture)
    }
}

fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let buffer = |ty| wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
    let types = [
        buffer(wgpu::BufferBindingType::Storage { read_only: true }),
        wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Depth,
            view_dimension: wgpu::TextureViewDimension::D2Array,
            multisampled: false,
        },
        buffer(wgpu::BufferBindingType::Uniform),
        buffer(wgpu::BufferBindingType::Storage { read_only: false }),
        wgpu::BindingType::StorageTexture {
            access: wgpu::StorageTextureAccess::WriteOnly,
            format: wgpu::TextureFormat::Rgba8Unorm,
            view_dimension: wgpu::TextureViewDimension::D2,
        },
    ];
    let entry = |(binding, ty)| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty,
        count: None,
    };
    let entries: Vec<_> = (0..).zip(types).map(entry).collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("MapPainter::layout"),
        entries: &entries,
    })
}
