//! Compute steps that make one texture of another, view by view. Group 0 holds the frame, which view it is, what is read and
//! what is written.

use crate::shadows::VIEW_INDEX_STRIDE;

/// What every step reads beside its texture.
#[derive(Clone, Copy)]
pub(crate) struct Inputs<'a> {
    pub device: &'a wgpu::Device,
    /// The frame.
    pub frame: &'a wgpu::Buffer,
    /// The numbers of the views.
    pub view_indices: &'a wgpu::Buffer,
}

/// A pipeline that reads one texture and writes another.
pub(crate) struct Kernel {
    pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
}

/// A kernel on two textures.
#[derive(Debug)]
pub(crate) struct Step {
    pipeline: wgpu::ComputePipeline,
    group: wgpu::BindGroup,
}

/// An array of depth maps.
pub(crate) const DEPTH_MAPS: wgpu::BindingType = wgpu::BindingType::Texture {
    sample_type: wgpu::TextureSampleType::Depth,
    view_dimension: wgpu::TextureViewDimension::D2Array,
    multisampled: false,
};

/// One layer and size of a texture that is read texel by texel.
pub(crate) fn layer_of(sample_type: wgpu::TextureSampleType) -> wgpu::BindingType {
    wgpu::BindingType::Texture {
        sample_type,
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    }
}

/// One layer and size of a texture, to read or to write.
pub(crate) fn layer_view(texture: &wgpu::Texture, layer: u32, level: u32) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor {
        label: Some("Kernel::layer"),
        dimension: Some(wgpu::TextureViewDimension::D2),
        base_array_layer: layer,
        array_layer_count: Some(1),
        base_mip_level: level,
        mip_level_count: Some(1),
        ..Default::default()
    })
}

/// The frame, at binding 0.
pub(crate) fn frame_entry(visibility: wgpu::ShaderStages) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding: 0,
        visibility,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Storage { read_only: true },
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

/// The index of a view, at binding 1 and a dynamic offset.
pub(crate) fn view_entry(visibility: wgpu::ShaderStages) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding: 1,
        visibility,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: true,
            min_binding_size: None,
        },
        count: None,
    }
}

/// What [`frame_entry`] and [`view_entry`] ask for.
pub(crate) fn frame_and_view<'a>(
    frame: &'a wgpu::Buffer,
    view_indices: &'a wgpu::Buffer,
) -> [wgpu::BindGroupEntry<'a>; 2] {
    let view = wgpu::BufferBinding { buffer: view_indices, offset: 0, size: wgpu::BufferSize::new(16) };
    [
        wgpu::BindGroupEntry { binding: 0, resource: frame.as_entire_binding() },
        wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Buffer(view) },
    ]
}

impl Kernel {
    /// Of an entry point that reads binding 2 and writes binding 3, a texture of this format.
    pub fn new(
        device: &wgpu::Device,
        text: &str,
        entry_point: &str,
        read: wgpu::BindingType,
        format: wgpu::TextureFormat,
    ) -> Self {
        let stage = wgpu::ShaderStages::COMPUTE;
        let entry = |binding, ty| wgpu::BindGroupLayoutEntry { binding, visibility: stage, ty, count: None };
        let written = wgpu::BindingType::StorageTexture {
            access: wgpu::StorageTextureAccess::WriteOnly,
            format,
            view_dimension: wgpu::TextureViewDimension::D2,
        };
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("Kernel::layout"),
            entries: &[frame_entry(stage), view_entry(stage), entry(2, read), entry(3, written)],
        });
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("Kernel::module"),
            source: wgpu::ShaderSource::Wgsl(text.into()),
        });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("Kernel::pipeline"),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("Kernel::pipeline"),
            layout: Some(&pipeline_layout),
            module: &module,
            entry_point: Some(entry_point),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        Self { pipeline, layout }
    }

    /// On these textures.
    pub fn on(&self, inputs: Inputs<'_>, read: &wgpu::TextureView, written: &wgpu::TextureView) -> Step {
        let [frame, view] = frame_and_view(inputs.frame, inputs.view_indices);
        let texture = |binding, view| wgpu::BindGroupEntry {
            binding,
            resource: wgpu::BindingResource::TextureView(view),
        };
        let group = inputs.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("Kernel::group"),
            layout: &self.layout,
            entries: &[frame, view, texture(2, read), texture(3, written)],
        });
        Step { pipeline: self.pipeline.clone(), group }
    }
}

impl Step {
    /// Runs so many workgroups for view number `view`.
    pub fn record(&self, pass: &mut wgpu::ComputePass<'_>, view: usize, [columns, rows]: [u32; 2]) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[view as u32 * VIEW_INDEX_STRIDE]);
        pass.dispatch_workgroups(columns, rows, 1);
    }
}
