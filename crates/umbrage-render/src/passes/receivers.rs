//! The pass that shades receivers, with one of the shaders of [`crate::shaders`] for each cover that surfaces have.

use umbrage::Shadows;

use crate::cover::Cover;
use crate::draws::Draw;
use crate::gpu::Gpu;
use crate::passes::prepass::Prepass;
use crate::scene_buffers::{RECEIVER_BUFFERS, SceneBuffers};
use crate::scene_uniform::SceneUniform;
use crate::shaders::{self, Covering, Look, Place, RECEIVER_ENTRY};
use crate::target::{DEPTH_FORMAT, Encoding};

/// Pipelines that shade receivers one way, for one kind of target.
#[derive(Debug)]
pub(crate) struct Receivers {
    /// One for each cover of the scene, in its order.
    by_cover: Vec<(Cover, Pipeline)>,
}

#[derive(Debug)]
struct Pipeline {
    pipeline: wgpu::RenderPipeline,
    /// Whether colours of vertices are read.
    has_colours: bool,
}

/// What pipelines of receivers are made for, beside the scene.
#[derive(Clone, Copy, Debug)]
struct Made<'a> {
    look: Look,
    encoding: Encoding,
    samples: u32,
    /// Whether the depth of what the pass before this draws is there.
    after_depth: bool,
    /// Whether visibility is found for the whole picture before it.
    is_resolved: bool,
    /// The layout of group 3, for a look whose shader has one.
    extra: Option<&'a wgpu::BindGroupLayout>,
}

impl Receivers {
    /// `extra` is the layout of group 3, for a look whose shader has one.
    pub fn new(
        gpu: &Gpu,
        look: Look,
        (encoding, samples): (Encoding, u32),
        (after_depth, is_resolved): (bool, bool),
        bound: (&SceneUniform, &SceneBuffers, &Shadows),
        extra: Option<&wgpu::BindGroupLayout>,
    ) -> Self {
        let made = Made { look, encoding, samples, after_depth, is_resolved, extra };
        let one = |cover: &Cover| (*cover, Pipeline::new(gpu, made, *cover, bound));
        Self { by_cover: bound.1.covers.iter().map(one).collect() }
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
        pass.set_bind_group(0, &uniform.group, &[]);
        pass.set_bind_group(1, shadows.bind_group(), &[]);
        if let Some(group) = extra {
            pass.set_bind_group(3, group, &[]);
        }
        let (mut set, mut bound) = (None, None);
        for draw in draws {
            if set != Some(draw.cover) {
                let Some((_, made)) = self.by_cover.iter().find(|(cover, _)| *cover == draw.cover) else {
                    continue;
                };
                pass.set_pipeline(&made.pipeline);
                if made.has_colours {
                    scene.bind_surfaces(pass, instance_numbers);
                } else {
                    scene.bind_receivers(pass, instance_numbers);
                }
                set = Some(draw.cover);
            }
            if bound != Some(draw.material) {
                pass.set_bind_group(2, &scene.materials.groups[draw.material as usize], &[]);
                bound = Some(draw.material);
            }
            pass.draw_indexed(draw.indices.clone(), draw.base_vertex, draw.instances.clone());
        }
    }
}

impl Pipeline {
    fn new(
        gpu: &Gpu,
        Made { look, encoding, samples, after_depth, is_resolved, extra }: Made<'_>,
        cover: Cover,
        (uniform, scene, shadows): (&SceneUniform, &SceneBuffers, &Shadows),
    ) -> Self {
        let around = scene.surroundings.around;
        let contact = shadows.settings().contact.as_ref();
        let covering = Covering::of(look, cover, samples);
        let place = Place::of(samples, shadows.key().traces());
        let receiver = shadows.wgsl(1);
        let text = shaders::receivers(
            look,
            scene.finish,
            around,
            covering,
            (&receiver, place),
            (contact, is_resolved),
        );
        let module = gpu.module("Receivers::module", text);
        let groups =
            [Some(&uniform.layout), Some(shadows.bind_group_layout()), Some(&scene.materials.layout), extra];
        let [positions, instances, attributes] = RECEIVER_BUFFERS;
        let surfaces = [positions, instances, attributes, Some(scene.colours.stream.clone())];
        let entry = shaders::vertex_entry(look, scene.finish, covering);
        let has_colours = entry != RECEIVER_ENTRY;
        let is_veil = covering == Covering::Veil;
        let is_drawn = after_depth && !is_veil && Prepass::draws(cover, samples);
        let layout = gpu.pipeline_layout("Receivers::layout", &groups);
        let pipeline = gpu.render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("Receivers::pipeline"),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some(entry),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: if has_colours { &surfaces } else { &RECEIVER_BUFFERS },
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(!is_veil && !is_drawn),
                depth_compare: Some(if is_drawn {
                    wgpu::CompareFunction::Equal
                } else {
                    wgpu::CompareFunction::Greater
                }),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState {
                count: samples,
                alpha_to_coverage_enabled: covering.is_alpha_to_coverage(),
                ..Default::default()
            },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("shade"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(wgpu::ColorTargetState {
                    format: encoding.format(),
                    blend: is_veil.then_some(wgpu::BlendState::ALPHA_BLENDING),
                    // What is seen through stays opaque in the picture.
                    write_mask: if covering == Covering::Solid {
                        wgpu::ColorWrites::ALL
                    } else {
                        wgpu::ColorWrites::COLOR
                    },
                })],
            }),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline, has_colours }
    }
}
