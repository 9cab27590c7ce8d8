//! Pipelines that draw casters: depth only, with the settings' raster bias and faces.

use umbrage_core::{CasterFaces, Settings};

use crate::capabilities::Capabilities;
use crate::compute::{frame_entry, view_entry};
use crate::layers::peel_wgsl;
use crate::maps::texture_format;

/// The caller's half of a caster pipeline: how vertices reach world space.
#[derive(Clone, Debug)]
pub struct CasterVertex<'a> {
    /// [`crate::caster_wgsl`], followed by the caller's own text.
    pub module: &'a wgpu::ShaderModule,
    /// A vertex shader that returns `umbrage_caster_position(…)`.
    pub entry_point: &'a str,
    /// What it reads a vertex and an instance from.
    pub buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    /// Its bind groups, from group 1 on.
    pub bind_group_layouts: &'a [&'a wgpu::BindGroupLayout],
    /// Which winding is the front; clockwise for meshes that are mirrored.
    pub front_face: wgpu::FrontFace,
}

/// Group 0 of every caster pipeline: the frame, and the index of the view at a dynamic offset.
pub(crate) fn bind_group_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("Shadows::caster_layout"),
        entries: &[frame_entry(wgpu::ShaderStages::VERTEX), view_entry(wgpu::ShaderStages::VERTEX)],
    })
}

/// One that draws casters; where it `peels`, without the first surface, which is then bound in group 0 too.
pub(crate) fn pipeline(
    device: &wgpu::Device,
    settings: &Settings,
    capabilities: Capabilities,
    group: &wgpu::BindGroupLayout,
    vertex: &CasterVertex<'_>,
    peels: bool,
) -> wgpu::RenderPipeline {
    let peel = peels.then(|| {
        device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("Shadows::peel"),
            source: wgpu::ShaderSource::Wgsl(peel_wgsl().into()),
        })
    });
    let CasterVertex { module, entry_point, buffers, bind_group_layouts, front_face } = *vertex;
    let groups: Vec<_> = std::iter::once(group).chain(bind_group_layouts.iter().copied()).map(Some).collect();
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("Shadows::caster_pipeline"),
        bind_group_layouts: &groups,
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("Shadows::caster_pipeline"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(entry_point),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers,
        },
        primitive: wgpu::PrimitiveState {
            front_face,
            cull_mode: match settings.bias.casters {
                CasterFaces::Both => None,
                CasterFaces::Front => Some(wgpu::Face::Back),
                CasterFaces::Back => Some(wgpu::Face::Front),
            },
            unclipped_depth: settings.flattens_casters() && capabilities.unclipped_depth,
            ..wgpu::PrimitiveState::default()
        },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: texture_format(settings.depth),
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::LessEqual),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState {
                constant: settings.bias.raster_constant,
                slope_scale: settings.bias.raster_slope,
                clamp: 0.0,
            },
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: peel.as_ref().map(|module| wgpu::FragmentState {
            module,
            entry_point: Some("peel"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[],
        }),
        multiview_mask: None,
        cache: None,
    })
}
