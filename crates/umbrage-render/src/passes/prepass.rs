//! The camera's depth, drawn before shading: then only what is seen is shaded, and contact shadows know what is there. Beside it may
//! be drawn where what is seen lies, for who answers for a whole picture.

use crate::cover::Cover;
use crate::draws::Draw;
use crate::gpu::Gpu;
use crate::scene_buffers::{RECEIVER_BUFFERS, SceneBuffers};
use crate::scene_uniform::SceneUniform;
use crate::shaders;
use crate::target::DEPTH_FORMAT;

/// What tells passes over the camera's depth apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PrepassKind {
    /// Samples a pixel.
    pub samples: u32,
    /// Whether places are drawn beside it.
    pub places: bool,
}

/// The format of places.
pub(crate) const PLACE_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Uint;

/// Pipelines that draw depth into targets of so many samples a pixel.
#[derive(Debug)]
pub(crate) struct Prepass {
    pub kind: PrepassKind,
    /// One for each cover of the scene that the pass draws.
    by_cover: Vec<(Cover, wgpu::RenderPipeline)>,
}

impl Prepass {
    /// Whether the pass draws surfaces of a cover. With several samples a pixel, what is cut out has edges that only its
    /// colour knows.
    pub fn draws(cover: Cover, samples: u32) -> bool {
        cover == Cover::Solid || samples == 1
    }

    /// The vertex shaders are those of the shading pass, so that both passes see the same depths.
    pub fn new(gpu: &Gpu, (uniform, scene): (&SceneUniform, &SceneBuffers), kind: PrepassKind) -> Self {
        let covers = scene.covers.iter().filter(|cover| Self::draws(**cover, kind.samples));
        let by_cover = covers.map(|cover| (*cover, pipeline(gpu, uniform, scene, *cover, kind))).collect();
        Self { kind, by_cover }
    }

    /// Draws the depth of receivers, and of veils where they cover at least half of their place.
    pub fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        (depth, places): (&wgpu::TextureView, Option<&wgpu::TextureView>),
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
        (uniform, scene): (&SceneUniform, &SceneBuffers),
        instance_numbers: &wgpu::Buffer,
        draws: [&[Draw]; 2],
    ) {
        let places = places.map(|view| {
            let ops = wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                store: wgpu::StoreOp::Store,
            };
            Some(wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops })
        });
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("Prepass::pass"),
            color_attachments: places.as_slice(),
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: depth,
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
        for draw in draws.into_iter().flatten() {
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

fn pipeline(
    gpu: &Gpu,
    uniform: &SceneUniform,
    scene: &SceneBuffers,
    cover: Cover,
    PrepassKind { samples, places }: PrepassKind,
) -> wgpu::RenderPipeline {
    let text = if places { shaders::places(cover) } else { shaders::depth(cover) };
    let module = gpu.module("Prepass::module", text);
    let is_solid = cover == Cover::Solid;
    let groups = [Some(&uniform.layout), None, Some(&scene.materials.layout)];
    let layout = gpu.pipeline_layout("Prepass::layout", if is_solid { &groups[..1] } else { &groups });
    let [positions, instances, attributes] = RECEIVER_BUFFERS;
    let place_target = [Some(PLACE_FORMAT.into())];
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
        multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
        fragment: (places || !is_solid).then(|| wgpu::FragmentState {
            module: &module,
            entry_point: Some(match (places, is_solid) {
                (true, true) => "place",
                (true, false) => "cut_place",
                (false, _) => "cut_depth",
            }),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: if places { &place_target } else { &[] },
        }),
        multiview_mask: None,
        cache: None,
    })
}
