//! The first two surfaces that the light meets, and the one depth that is made of them (`bias.depth_layer` of the settings).
//!
//! Casters are drawn twice: into the first texture as ever, and into the second without what the first one shows. Then a
//! triangle over every tile writes what is stored. Sources: Wang & Molnar 1994 (second depth), Woo 1992 (midpoint), Weiskopf
//! & Ertl 2003 (dual), Everitt 2001 (peeling).

use umbrage_core::{DepthLayer, MapLayout, Settings, ShadowPlan, ShadowView};

use crate::capabilities::Capabilities;
use crate::compute::{DEPTH_MAPS, Inputs, frame_and_view, frame_entry, view_entry};
use crate::maps::{Maps, texture_format};
use crate::shadows::VIEW_INDEX_STRIDE;
use crate::wgsl::{DEPTH, FRAME};

/// The two surfaces, and what joins them.
#[derive(Debug)]
pub(crate) struct Layers {
    pub first: Maps,
    pub second: Maps,
    /// Group 0 of a caster pipeline that peels: as ever, and the first surface.
    pub peel_layout: wgpu::BindGroupLayout,
    pub peel_group: wgpu::BindGroup,
    join: wgpu::RenderPipeline,
    join_group: wgpu::BindGroup,
}

impl Layers {
    /// For maps that lie so; `None` where only the first surface is asked for.
    pub fn new(
        inputs: Inputs<'_>,
        settings: &Settings,
        capabilities: Capabilities,
        layout: MapLayout,
    ) -> Option<Self> {
        let joined = match settings.bias.depth_layer {
            DepthLayer::First => return None,
            DepthLayer::Second => include_str!("../shaders/layers/second.wgsl"),
            DepthLayer::Midpoint => include_str!("../shaders/layers/midpoint.wgsl"),
            DepthLayer::Dual => include_str!("../shaders/layers/dual.wgsl"),
        };
        let device = inputs.device;
        let (first, second) =
            (Maps::of(device, layout, capabilities), Maps::of(device, layout, capabilities));
        let peel_layout = group_layout(device, wgpu::ShaderStages::VERTEX_FRAGMENT, 1);
        let join_layout = group_layout(device, wgpu::ShaderStages::FRAGMENT, 2);
        let limit =
            format!("const UMBRAGE_DEPTH_LAYER_LIMIT: f32 = {:?};\n", settings.bias.depth_layer_limit);
        let text = [FRAME, DEPTH, &limit, joined, include_str!("../shaders/layers/join.wgsl")].join("\n");
        let join = join_pipeline(device, &join_layout, &text, texture_format(layout.depth));
        let peel_group = group(inputs, &peel_layout, &[&first.all]);
        let join_group = group(inputs, &join_layout, &[&first.all, &second.all]);
        Some(Self { first, second, peel_layout, peel_group, join, join_group })
    }

    /// Writes what is stored of a plan's views.
    pub fn join(&self, encoder: &mut wgpu::CommandEncoder, maps: &Maps, plan: &ShadowPlan) {
        for view in plan.views() {
            let mut pass = maps.begin(encoder, view, None);
            pass.set_pipeline(&self.join);
            pass.set_bind_group(0, &self.join_group, &[offset(view)]);
            pass.draw(0..3, 0..1);
        }
    }

    /// Of both surfaces.
    pub fn bytes(&self) -> u64 {
        self.first.layout.bytes() + self.second.layout.bytes()
    }
}

/// Where a view's number stands.
pub(crate) fn offset(view: &ShadowView) -> u32 {
    view.index as u32 * VIEW_INDEX_STRIDE
}

/// What a fragment shader that leaves out the first surface is made of; it goes with the caller's vertex shader.
pub(crate) fn peel_wgsl() -> String {
    [FRAME, include_str!("../shaders/layers/peel.wgsl")].join("\n")
}

/// The frame, the view, and so many depth maps from binding 2 on.
fn group_layout(device: &wgpu::Device, visibility: wgpu::ShaderStages, maps: u32) -> wgpu::BindGroupLayout {
    let map = |binding| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: DEPTH_MAPS,
        count: None,
    };
    let entries: Vec<_> =
        [frame_entry(visibility), view_entry(visibility)].into_iter().chain((2..2 + maps).map(map)).collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("Layers::layout"),
        entries: &entries,
    })
}

fn group(inputs: Inputs<'_>, layout: &wgpu::BindGroupLayout, maps: &[&wgpu::TextureView]) -> wgpu::BindGroup {
    let texture = |(binding, view)| wgpu::BindGroupEntry {
        binding,
        resource: wgpu::BindingResource::TextureView(view),
    };
    let maps = (2..).zip(maps.iter().copied()).map(texture);
    let entries: Vec<_> = frame_and_view(inputs.frame, inputs.view_indices).into_iter().chain(maps).collect();
    inputs.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("Layers::group"),
        layout,
        entries: &entries,
    })
}

fn join_pipeline(
    device: &wgpu::Device,
    group: &wgpu::BindGroupLayout,
    text: &str,
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("Layers::join"),
        source: wgpu::ShaderSource::Wgsl(text.into()),
    });
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("Layers::join"),
        bind_group_layouts: &[Some(group)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("Layers::join"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("everywhere"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Always),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("join"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[],
        }),
        multiview_mask: None,
        cache: None,
    })
}
