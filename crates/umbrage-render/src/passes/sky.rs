//! The pass that draws the sky where nothing else is: it depends on no setting of shadows.

use crate::gpu::Gpu;
use crate::scene_uniform::SceneUniform;
use crate::shaders::{self, Around};
use crate::target::{DEPTH_FORMAT, Encoding};

/// A pipeline that draws the sky, for one kind of target.
#[derive(Debug)]
pub(crate) struct Sky {
    pipeline: wgpu::RenderPipeline,
}

impl Sky {
    pub fn new(gpu: &Gpu, uniform: &SceneUniform, around: Around, encoding: Encoding, samples: u32) -> Self {
        let (text, fragment) = match encoding {
            Encoding::Srgb => (shaders::sky(around), "sky_shade"),
            Encoding::Linear => (shaders::lit_sky(), "sky_visibility"),
        };
        let module = gpu.module("Sky::module", text);
        let layout = gpu.pipeline_layout("Sky::layout", &[Some(&uniform.layout)]);
        let pipeline = gpu.render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("Sky::pipeline"),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("sky"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(false),
                depth_compare: Some(wgpu::CompareFunction::GreaterEqual),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some(fragment),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(encoding.format().into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline }
    }

    /// Draws the sky into a pass over a target, behind what is there.
    pub fn record(&self, pass: &mut wgpu::RenderPass<'_>, uniform: &SceneUniform) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &uniform.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
