//! The pass that shades receivers, with one of the shaders of [`crate::shaders`].

use umbrage::Shadows;

use crate::draws::Draw;
use crate::gpu::Gpu;
use crate::scene_buffers::{RECEIVER_BUFFERS, SceneBuffers};
use crate::scene_uniform::SceneUniform;
use crate::shaders::{self, Look, RECEIVER_ENTRY};
use crate::target::{DEPTH_FORMAT, Encoding};

/// A pipeline that shades receivers one way, for one kind of target.
#[derive(Debug)]
pub(crate) struct Receivers {
    pipeline: wgpu::RenderPipeline,
    /// Whether colours of vertices are read.
    has_colours: bool,
}

impl Receivers {
    /// `extra` is the layout of group 3, for a look whose shader has one.
    pub fn new(
        gpu: &Gpu,
        look: Look,
        (encoding, samples): (Encoding, u32),
        (uniform, scene, shadows): (&SceneUniform, &SceneBuffers, &Shadows),
        extra: Option<&wgpu::BindGroupLayout>,
    ) -> Self {
        let around = scene.surroundings.around;
        let contact = shadows.settings().contact.as_ref();
        let text = shaders::receivers(look, scene.finish, around, &shadows.wgsl(1), contact);
        let module = gpu.module("Receivers::module", text);
        let groups =
            [Some(&uniform.layout), Some(shadows.bind_group_layout()), Some(&scene.materials.layout), extra];
        let [positions, instances, attributes] = RECEIVER_BUFFERS;
        let surfaces = [positions, instances, attributes, Some(scene.colours.stream.clone())];
        let entry = shaders::vertex_entry(look, scene.finish);
        let layout = gpu.pipeline_layout("Receivers::layout", &groups);
        let pipeline = gpu.render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("Receivers::pipeline"),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some(entry),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: if entry == RECEIVER_ENTRY { &RECEIVER_BUFFERS } else { &surfaces },
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Greater),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("shade"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(encoding.format().into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline, has_colours: entry != RECEIVER_ENTRY }
    }

    /// Draws receivers into a pass over a target. `extra` is group 3, for a look whose shader has one.
    pub fn record(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        (uniform, scene, shadows): (&SceneUniform, &SceneBuffers, &Shadows),
        extra: Option<&wgpu::BindGroup>,
        instance_numbers: &wgpu::Buffer,
        draws: &[Draw],
    ) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &uniform.group, &[]);
        pass.set_bind_group(1, shadows.bind_group(), &[]);
        if let Some(group) = extra {
            pass.set_bind_group(3, group, &[]);
        }
        if self.has_colours {
            scene.bind_surfaces(pass, instance_numbers);
        } else {
            scene.bind_receivers(pass, instance_numbers);
        }
        let mut bound = None;
        for draw in draws {
            if bound != Some(draw.material) {
                pass.set_bind_group(2, &scene.materials.groups[draw.material as usize], &[]);
                bound = Some(draw.material);
            }
            pass.draw_indexed(draw.indices.clone(), draw.base_vertex, draw.instances.clone());
        }
    }
}
