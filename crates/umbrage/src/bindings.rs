//! The bindings of `umbrage-wgsl`, as wgpu has them.

use umbrage_wgsl::{Binding, BindingKind, Dimension, SampleType, SamplerKind, Stages, TexelFormat};

use crate::objects::Objects;

/// The layout of a group with these bindings.
pub(crate) fn group_layout(
    objects: &Objects<'_>,
    label: &str,
    bindings: &[Binding],
) -> wgpu::BindGroupLayout {
    let entry = |binding: &Binding| wgpu::BindGroupLayoutEntry {
        binding: binding.binding,
        visibility: stages(binding.stages),
        ty: kind(binding.kind),
        count: None,
    };
    let entries: Vec<_> = bindings.iter().map(entry).collect();
    objects.group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries: &entries })
}

/// A group that binds these, at 0 and on.
pub(crate) fn group<'a>(
    objects: &Objects<'_>,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    resources: impl IntoIterator<Item = wgpu::BindingResource<'a>>,
) -> wgpu::BindGroup {
    group_at(objects, label, layout, (0..).zip(resources))
}

/// A group that binds these, each at its number.
pub(crate) fn group_at<'a>(
    objects: &Objects<'_>,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    resources: impl IntoIterator<Item = (u32, wgpu::BindingResource<'a>)>,
) -> wgpu::BindGroup {
    let entry = |(binding, resource)| wgpu::BindGroupEntry { binding, resource };
    let entries: Vec<_> = resources.into_iter().map(entry).collect();
    objects.group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
}

fn stages(stages: Stages) -> wgpu::ShaderStages {
    match stages {
        Stages::Vertex => wgpu::ShaderStages::VERTEX,
        Stages::Fragment => wgpu::ShaderStages::FRAGMENT,
        Stages::VertexAndFragment => wgpu::ShaderStages::VERTEX_FRAGMENT,
        Stages::Compute => wgpu::ShaderStages::COMPUTE,
        Stages::FragmentAndCompute => wgpu::ShaderStages::FRAGMENT | wgpu::ShaderStages::COMPUTE,
    }
}

fn kind(kind: BindingKind) -> wgpu::BindingType {
    let buffer =
        |ty, has_dynamic_offset| wgpu::BindingType::Buffer { ty, has_dynamic_offset, min_binding_size: None };
    match kind {
        BindingKind::Storage => buffer(wgpu::BufferBindingType::Storage { read_only: true }, false),
        BindingKind::Uniform { has_dynamic_offset } => {
            buffer(wgpu::BufferBindingType::Uniform, has_dynamic_offset)
        }
        BindingKind::Texture { sample, dimension } => wgpu::BindingType::Texture {
            sample_type: match sample {
                SampleType::Depth => wgpu::TextureSampleType::Depth,
                SampleType::FilterableFloat => wgpu::TextureSampleType::Float { filterable: true },
                SampleType::Float => wgpu::TextureSampleType::Float { filterable: false },
                SampleType::Uint => wgpu::TextureSampleType::Uint,
            },
            view_dimension: match dimension {
                Dimension::D2 => wgpu::TextureViewDimension::D2,
                Dimension::D2Array => wgpu::TextureViewDimension::D2Array,
            },
            multisampled: false,
        },
        BindingKind::StorageTexture { format } => wgpu::BindingType::StorageTexture {
            access: wgpu::StorageTextureAccess::WriteOnly,
            format: texel_format(format),
            view_dimension: wgpu::TextureViewDimension::D2,
        },
        BindingKind::Sampler(SamplerKind::Comparison) => {
            wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Comparison)
        }
        BindingKind::Sampler(SamplerKind::Filtering) => {
            wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)
        }
        BindingKind::Sampler(SamplerKind::NonFiltering) => {
            wgpu::BindingType::Sampler(wgpu::SamplerBindingType::NonFiltering)
        }
    }
}

/// The format of a texture of moments or sums.
pub(crate) fn texel_format(format: TexelFormat) -> wgpu::TextureFormat {
    match format {
        TexelFormat::R32Float => wgpu::TextureFormat::R32Float,
        TexelFormat::Rg32Float => wgpu::TextureFormat::Rg32Float,
        TexelFormat::Rgba32Float => wgpu::TextureFormat::Rgba32Float,
        TexelFormat::Rg16Float => wgpu::TextureFormat::Rg16Float,
        TexelFormat::Rgba16Float => wgpu::TextureFormat::Rgba16Float,
        TexelFormat::Rgba16Unorm => wgpu::TextureFormat::Rgba16Unorm,
        TexelFormat::Rg32Uint => wgpu::TextureFormat::Rg32Uint,
        TexelFormat::Rgba32Uint => wgpu::TextureFormat::Rgba32Uint,
    }
}
