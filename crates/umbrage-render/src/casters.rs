//! Pipelines that draw casters, and the instances they read.

use umbrage::{CasterVertex, Shadows, caster_wgsl};

use crate::gpu::Gpu;
use crate::scene_buffers::{CASTER_BUFFERS, SceneBuffers};

/// How a scene's casters are drawn into any view.
#[derive(Debug)]
pub(crate) struct CasterPipelines {
    /// For instances as they are, and for instances that mirror their mesh: these turn its winding over.
    pub by_mirroring: [wgpu::RenderPipeline; 2],
    /// The same for the second surface that the light meets, where there is one.
    pub second_by_mirroring: Option<[wgpu::RenderPipeline; 2]>,
    /// Group 1 of both.
    pub instances: wgpu::BindGroup,
}

impl CasterPipelines {
    pub fn new(gpu: &Gpu, buffers: &SceneBuffers, shadows: &Shadows) -> Self {
        let layout = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("CasterPipelines::layout"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::VERTEX,
                ty: wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Storage { read_only: true },
                    has_dynamic_offset: false,
                    min_binding_size: None,
                },
                count: None,
            }],
        });
        let instances = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("CasterPipelines::instances"),
            layout: &layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: buffers.instances.as_entire_binding() }],
        });
        let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("CasterPipelines::module"),
            source: wgpu::ShaderSource::Wgsl((caster_wgsl() + include_str!("../shaders/caster.wgsl")).into()),
        });
        let groups = [&layout];
        let vertices = [wgpu::FrontFace::Ccw, wgpu::FrontFace::Cw].map(|front_face| CasterVertex {
            module: &module,
            entry_point: "caster",
            buffers: &CASTER_BUFFERS,
            bind_group_layouts: &groups,
            front_face,
        });
        let [plain, mirrored] = &vertices;
        let second = |vertex| shadows.second_caster_pipeline(&gpu.device, vertex);
        Self {
            by_mirroring: [plain, mirrored].map(|vertex| shadows.caster_pipeline(&gpu.device, vertex)),
            second_by_mirroring: second(plain).zip(second(mirrored)).map(<[_; 2]>::from),
            instances,
        }
    }
}
