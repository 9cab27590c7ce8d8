//! The camera's depth, drawn before shading for contact shadows: the same receivers, depth alone, one sample a pixel.

use umbrage::{Camera, ContactShadows};

use crate::cover::Cover;
use crate::draws::Draw;
use crate::gpu::Gpu;
use crate::scene_buffers::{RECEIVER_BUFFERS, SceneBuffers};
use crate::scene_uniform::SceneUniform;
use crate::shaders;
use crate::target::DEPTH_FORMAT;

/// Pipelines that draw depth, and the depth of a picture of one size.
#[derive(Debug)]
pub(crate) struct Prepass {
    contact: ContactShadows,
    /// One for each cover of the scene.
    by_cover: Vec<(Cover, wgpu::RenderPipeline)>,
    depth: Depth,
}

#[derive(Debug)]
struct Depth {
    size: [u32; 2],
    view: wgpu::TextureView,
    group: wgpu::BindGroup,
}

impl Prepass {
    /// The vertex shaders are those of the shading pass, so that both passes see the same depths.
    pub fn new(gpu: &Gpu, (uniform, scene): (&SceneUniform, &SceneBuffers), size: [u32; 2]) -> Self {
        let by_cover =
            scene.covers.iter().map(|cover| (*cover, pipeline(gpu, uniform, scene, *cover))).collect();
        let contact = ContactShadows::new(&gpu.device);
        Self { depth: Depth::new(gpu, &contact, size), contact, by_cover }
    }

    /// Makes depth for a picture of `size` pixels, where it has another size.
    pub fn resize(&mut self, gpu: &Gpu, size: [u32; 2]) {
        if self.depth.size != size {
            self.depth = Depth::new(gpu, &self.contact, size);
        }
    }

    /// Tells the GPU from where the depth is seen.
    pub fn upload(&self, gpu: &Gpu, camera: &Camera) {
        self.contact.upload(&gpu.queue, camera);
    }

    /// The layout of [`Self::group`].
    pub fn layout(&self) -> &wgpu::BindGroupLayout {
        self.contact.bind_group_layout()
    }

    /// What shaders that march through the depth read, as group 3.
    pub fn group(&self) -> &wgpu::BindGroup {
        &self.depth.group
    }

    /// Draws receivers, and veils where they cover at least half of their place.
    pub fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
        uniform: &SceneUniform,
        scene: &SceneBuffers,
        instance_numbers: &wgpu::Buffer,
        draws: [&[Draw]; 2],
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("Prepass::pass"),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth.view,
                // Reversed: nothing is at the far plane.
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            timestamp_writes,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        pass.set_bind_group(0, &uniform.group, &[]);
        let mut set = None;
        for draw in draws.iter().flat_map(|draws| draws.iter()) {
            if set != Some(draw.cover) {
                let found = self.by_cover.iter().find(|(cover, _)| *cover == draw.cover);
                let Some((_, pipeline)) = found else { continue };
                pass.set_pipeline(pipeline);
                scene.bind_surfaces(&mut pass, instance_numbers);
                set = Some(draw.cover);
            }
            if draw.cover != Cover::Solid {
                pass.set_bind_group(2, &scene.materials.groups[draw.material as usize], &[]);
            }
            pass.draw_indexed(draw.indices.clone(), draw.base_vertex, draw.instances.clone());
        }
    }
}

fn pipeline(gpu: &Gpu, uniform: &SceneUniform, scene: &SceneBuffers, cover: Cover) -> wgpu::RenderPipeline {
    let module = gpu.module("Prepass::module", shaders::depth(cover));
    let is_solid = cover == Cover::Solid;
    let groups = [Some(&uniform.layout), None, Some(&scene.materials.layout)];
    let layout = gpu.pipeline_layout("Prepass::layout", if is_solid { &groups[..1] } else { &groups });
    let [positions, instances, attributes] = RECEIVER_BUFFERS;
    gpu.render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("Prepass::pipeline"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some(if is_solid { "receiver" } else { "coloured_receiver" }),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[positions, instances, attributes, Some(scene.colours.stream.clone())],
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
        fragment: (!is_solid).then(|| wgpu::FragmentState {
            module: &module,
            entry_point: Some("cut_depth"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[],
        }),
        multiview_mask: None,
        cache: None,
    })
}

impl Depth {
    fn new(gpu: &Gpu, contact: &ContactShadows, size: [u32; 2]) -> Self {
        let texture = gpu.texture(&wgpu::TextureDescriptor {
            label: Some("Prepass::depth"),
            size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: DEPTH_FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let group = contact.bind_group(&gpu.device, &view);
        Self { size, view, group }
    }
}
