//! The bindings of `umbrage-wgsl`, as wgpu has them.

use umbrage_wgsl::{Binding, BindingKind, Dimension, SampleType, SamplerKind, Stages, TexelFormat};

use crate::objects::Objects;

/// The layout of a group with these bindings.
pub(crate) fn group_layout(
    objects: &Objects<'_>,
    label: &str,
    bindings: &[Binding],
) -> wgpu::BindGroupLayout {
    let entries = layout_entries(bindings, 0);
    objects.group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries: &entries })
}

/// The entries of a layout for these bindings, with number `first` in place of 0.
pub(crate) fn layout_entries(bindings: &[Binding], first: u32) -> Vec<wgpu::BindGroupLayoutEntry> {
    let entry = |binding: &Binding| wgpu::BindGroupLayoutEntry {
        binding: first + binding.binding,
        visibility: stages(binding.stages),
        ty: kind(binding.kind),
        count: None,
    };
    bindings.iter().map(entry).collect()
}

/// A group that binds these, at 0 and on.
pub(crate) fn group<'a>(
    objects: &Objects<'_>,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    resources: impl IntoIterator<Item = wgpu::BindingResource<'a>>,
) -> wgpu::BindGroup {
    let entries = entries(0, resources);
    objects.group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
}

/// The entries of a group that binds these, at `first` and on.
pub(crate) fn entries<'a>(
    first: u32,
    resources: impl IntoIterator<Item = wgpu::BindingResource<'a>>,
) -> Vec<wgpu::BindGroupEntry<'a>> {
    (first..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect()
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
        BindingKind::WrittenStorage => buffer(wgpu::BufferBindingType::Storage { read_only: false }, false),
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
                Dimension::D2 | Dimension::D2Multisampled => wgpu::TextureViewDimension::D2,
                Dimension::D2Array => wgpu::TextureViewDimension::D2Array,
            },
            multisampled: dimension == Dimension::D2Multisampled,
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
