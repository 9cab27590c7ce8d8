//! The pass that paints a shadow view's tile as a grey picture: near dark, as it is stored; or inverted, stretched, even
//! in metres (R-VIEW-1).

use encase::{ShaderType, UniformBuffer};
use umbrage::{Shadows, map_wgsl};

use crate::buffers::{READ, WRITE, binding, filled};
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::shaders;

/// Says how to look at a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MapLook {
    /// Whether near is light. Where not, near is dark, as depth is stored.
    pub invert: bool,
    /// Whether grey goes from the nearest depth that was drawn to the farthest: [`Self::greys`].
    pub stretch: bool,
    /// The greys of the nearest and of the farthest depth, where they are stretched, 0 to 255; 0 and 255 unless said. What
    /// is empty is always 255.
    pub greys: [u8; 2],
    /// Whether grey is even in metres along the light, whatever a punctual light or a warp makes of depth.
    pub even: bool,
}

impl Default for MapLook {
    fn default() -> Self {
        Self { invert: false, stretch: false, greys: [0, 255], even: false }
    }
}

/// Which tile is painted, and how: as in the shader.
#[derive(Clone, Copy, Debug, ShaderType)]
struct GpuLook {
    view: u32,
    side: u32,
    invert: u32,
    stretch: u32,
    even: u32,
    nearest: f32,
    farthest: f32,
}

/// Texels of a workgroup's side, as in the shader.
const WORKGROUP: u32 = 8;

/// The pipelines that paint tiles.
#[derive(Debug)]
pub(crate) struct MapPicture {
    layout: wgpu::BindGroupLayout,
    find_range: wgpu::ComputePipeline,
    paint: wgpu::ComputePipeline,
}

impl MapPicture {
    pub fn new(gpu: &Gpu) -> Self {
        let layout = layout(gpu);
        let module = gpu.module("MapPicture::module", shaders::map_picture(&map_wgsl()));
        let pipeline = |entry_point| {
            gpu.compute_pipeline("MapPicture::pipeline", &[Some(&layout)], &module, entry_point)
        };
        Self { find_range: pipeline("find_range"), paint: pipeline("paint"), layout }
    }

    /// Paints the tile of view number `view`, `tile_size` texels a side, `side` by `side` pixels large. The picture is the
    /// caller's.
    pub fn record(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        shadows: &Shadows,
        (view, tile_size): (usize, u32),
        look: MapLook,
        side: u32,
    ) -> Result<wgpu::TextureView, RenderError> {
        let MapLook { invert, stretch, greys, even } = look;
        let [nearest, farthest] = greys.map(|grey| f32::from(grey) / 255.0);
        let [invert, stretch, even] = [invert, stretch, even].map(u32::from);
        let mut uniform = UniformBuffer::new(Vec::new());
        uniform
            .write(&GpuLook { view: view as u32, side, invert, stretch, even, nearest, farthest })
            .map_err(|e| RenderError::Device(e.to_string()))?;
        let uniform = filled(gpu, "look", &uniform.into_inner(), wgpu::BufferUsages::UNIFORM)?;
        let nothing: [u32; 2] = [1.0f32.to_bits(), 0.0f32.to_bits()];
        let drawn = filled(gpu, "drawn depths", bytemuck::cast_slice(&nothing), wgpu::BufferUsages::STORAGE)?;
        let picture = texture(gpu, side);
        let resources = [
            shadows.frame().as_entire_binding(),
            wgpu::BindingResource::TextureView(shadows.maps()),
            uniform.as_entire_binding(),
            drawn.as_entire_binding(),
            wgpu::BindingResource::TextureView(&picture),
        ];
        let group = gpu.bind_group("MapPicture::group", &self.layout, resources);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_bind_group(0, &group, &[]);
        for (pipeline, size) in [(&self.find_range, tile_size), (&self.paint, side)] {
            pass.set_pipeline(pipeline);
            pass.dispatch_workgroups(size.div_ceil(WORKGROUP), size.div_ceil(WORKGROUP), 1);
        }
        drop(pass);
        Ok(picture)
    }
}

/// Where a tile is painted: bytes to be read as they are.
fn texture(gpu: &Gpu, side: u32) -> wgpu::TextureView {
    let side = side.clamp(1, gpu.device.limits().max_texture_dimension_2d);
    let texture = gpu.texture(&wgpu::TextureDescriptor {
        label: Some("MapPicture::texture"),
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
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

fn layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let maps = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Depth,
        view_dimension: wgpu::TextureViewDimension::D2Array,
        multisampled: false,
    };
    let picture = wgpu::BindingType::StorageTexture {
        access: wgpu::StorageTextureAccess::WriteOnly,
        format: wgpu::TextureFormat::Rgba8Unorm,
        view_dimension: wgpu::TextureViewDimension::D2,
    };
    let types = [binding(READ), maps, binding(wgpu::BufferBindingType::Uniform), binding(WRITE), picture];
    gpu.layout("MapPicture::layout", types.map(|ty| (wgpu::ShaderStages::COMPUTE, ty)))
}
