//! Pipelines of ours that write a tile's depth, whatever was there: a triangle over all of it.

use umbrage_core::DepthFormat;

use crate::objects::Objects;

/// What such a pipeline is made of.
pub(crate) struct DepthPipeline<'a> {
    pub label: &'a str,
    pub module: &'a wgpu::ShaderModule,
    /// The names of the vertex shader, and of the fragment shader where there is one.
    pub entry_points: (&'a str, Option<&'a str>),
    pub group: Option<&'a wgpu::BindGroupLayout>,
    pub depth: DepthFormat,
}

pub(crate) fn depth_pipeline(objects: &Objects<'_>, of: &DepthPipeline<'_>) -> wgpu::RenderPipeline {
    let DepthPipeline { label, module, entry_points: (vertex, fragment), group, depth } = *of;
    let groups: Vec<_> = group.into_iter().map(Some).collect();
    let layout = objects.pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(label),
        bind_group_layouts: &groups,
        immediate_size: 0,
    });
    objects.render_pipeline(wgpu::RenderPipelineDescriptor {
        label: Some(label),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(vertex),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: texture_format(depth),
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Always),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: fragment.map(|entry_point| wgpu::FragmentState {
            module,
            entry_point: Some(entry_point),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// The format of the maps' texels, as wgpu calls it.
pub(crate) fn texture_format(depth: DepthFormat) -> wgpu::TextureFormat {
    match depth {
        DepthFormat::F32 => wgpu::TextureFormat::Depth32Float,
        DepthFormat::U16 => wgpu::TextureFormat::Depth16Unorm,
    }
}
