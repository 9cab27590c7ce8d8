//! Pipelines that draw casters: depth only, with the settings' raster bias and faces.

use umbrage_core::{CasterFaces, CasterKey};

use umbrage_wgsl::peel;

use crate::depth_pipeline::texture_format;

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

/// One that draws casters, on a device that can do what the key asks for; where it `peels`, without the first surface, which is then bound in group 0 too.
pub(crate) fn pipeline(
    device: &wgpu::Device,
    key: CasterKey,
    group: &wgpu::BindGroupLayout,
    vertex: &CasterVertex<'_>,
    peels: bool,
) -> wgpu::RenderPipeline {
    let peel = peels.then(|| {
        device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("Shadows::peel"),
            source: wgpu::ShaderSource::Wgsl(peel().into()),
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
            cull_mode: match key.faces {
                CasterFaces::Both => None,
                CasterFaces::Front => Some(wgpu::Face::Back),
                CasterFaces::Back => Some(wgpu::Face::Front),
            },
            unclipped_depth: key.flattens,
            ..wgpu::PrimitiveState::default()
        },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: texture_format(key.depth),
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::GreaterEqual),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState {
                // Depth is reversed: what is deeper is less.
                constant: -key.raster_constant,
                slope_scale: -key.raster_slope,
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
