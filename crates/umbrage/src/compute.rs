//! Compute steps that make one texture of another, view by view.

use umbrage_wgsl::Step;

use crate::bindings;
use crate::frame::{FrameBuffers, VIEW_INDEX_STRIDE};
use crate::objects::Objects;

/// A pipeline that reads one texture and writes another.
pub(crate) struct Kernel {
    pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
}

/// A kernel on two textures.
#[derive(Clone, Debug)]
pub(crate) struct KernelOn {
    pipeline: wgpu::ComputePipeline,
    group: wgpu::BindGroup,
}

/// One layer and size of a texture, to read or to write.
pub(crate) fn layer_view(
    objects: &Objects<'_>,
    texture: &wgpu::Texture,
    layer: u32,
    level: u32,
) -> wgpu::TextureView {
    objects.view(
        texture,
        &wgpu::TextureViewDescriptor {
            label: Some("Kernel::layer"),
            dimension: Some(wgpu::TextureViewDimension::D2),
            base_array_layer: layer,
            array_layer_count: Some(1),
            base_mip_level: level,
            mip_level_count: Some(1),
            ..Default::default()
        },
    )
}

impl Kernel {
    pub fn new(objects: &Objects<'_>, step: &Step) -> Self {
        let layout = bindings::group_layout(objects, "Kernel::layout", &step.bindings);
        let module = objects.shader("Kernel::module", &step.text);
        let pipeline_layout = objects.pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("Kernel::pipeline"),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = objects.compute_pipeline(wgpu::ComputePipelineDescriptor {
            label: Some("Kernel::pipeline"),
            layout: Some(&pipeline_layout),
            module: &module,
            entry_point: Some(step.entry_point),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        Self { pipeline, layout }
    }

    /// On these textures.
    pub fn on(
        &self,
        objects: &Objects<'_>,
        buffers: &FrameBuffers,
        read: &wgpu::TextureView,
        written: &wgpu::TextureView,
    ) -> KernelOn {
        let textures = [read, written].map(wgpu::BindingResource::TextureView);
        let bound = buffers.bound().into_iter().chain(textures);
        let group = bindings::group(objects, "Kernel::group", &self.layout, bound);
        KernelOn { pipeline: self.pipeline.clone(), group }
    }
}

impl KernelOn {
    /// Runs so many workgroups for view number `view`.
    pub fn record(&self, pass: &mut wgpu::ComputePass<'_>, view: usize, [columns, rows]: [u32; 2]) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[view as u32 * VIEW_INDEX_STRIDE]);
        pass.dispatch_workgroups(columns, rows, 1);
    }
}
