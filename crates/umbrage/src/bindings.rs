//! What receivers' shaders read: the frame, the maps, and what a filter has made of them.

use umbrage_core::{Filter, Prefilter};

use crate::capabilities::Capabilities;
use crate::compute::{DEPTH_MAPS, frame_entry};
use crate::prefilter::MomentFormat;

/// What is bound.
pub(crate) struct Read<'a> {
    pub frame: &'a wgpu::Buffer,
    pub maps: &'a wgpu::TextureView,
    /// Moments or sums, where the filter has them.
    pub filtered: Option<&'a wgpu::TextureView>,
}

/// The layout of group `group` of [`crate::receiver_wgsl`].
pub(crate) fn layout(
    device: &wgpu::Device,
    filter: &Filter,
    capabilities: Capabilities,
) -> wgpu::BindGroupLayout {
    let visibility = wgpu::ShaderStages::FRAGMENT | wgpu::ShaderStages::COMPUTE;
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None };
    let array_of = |sample_type| wgpu::BindingType::Texture {
        sample_type,
        view_dimension: wgpu::TextureViewDimension::D2Array,
        multisampled: false,
    };
    let mut entries = vec![
        frame_entry(visibility),
        entry(1, DEPTH_MAPS),
        entry(2, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Comparison)),
    ];
    if let Some(MomentFormat { is_filterable: filterable, .. }) = MomentFormat::of(filter, capabilities) {
        entries.push(entry(3, array_of(wgpu::TextureSampleType::Float { filterable })));
        if filterable {
            entries.push(entry(4, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)));
        }
    } else if !filter.compares_depths() {
        entries.push(entry(3, array_of(wgpu::TextureSampleType::Uint)));
    }
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("Shadows::receiver_layout"),
        entries: &entries,
    })
}

/// What is bound to that layout.
pub(crate) fn group(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    filter: &Filter,
    capabilities: Capabilities,
    read: &Read<'_>,
) -> wgpu::BindGroup {
    let comparison = comparison_sampler(device, filter);
    let format = MomentFormat::of(filter, capabilities);
    let smooth = smooth_sampler(device, &format.map(|format| format.prefilter).unwrap_or_default());
    let mut resources = vec![
        read.frame.as_entire_binding(),
        wgpu::BindingResource::TextureView(read.maps),
        wgpu::BindingResource::Sampler(&comparison),
    ];
    resources.extend(read.filtered.map(wgpu::BindingResource::TextureView));
    if format.is_some_and(|format| format.is_filterable) {
        resources.push(wgpu::BindingResource::Sampler(&smooth));
    }
    let entries: Vec<_> =
        (0..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("Shadows::receiver_group"),
        layout,
        entries: &entries,
    })
}

/// Lit where the reference is not greater than what is stored.
fn comparison_sampler(device: &wgpu::Device, filter: &Filter) -> wgpu::Sampler {
    let mode = if filter.is_bilinear() { wgpu::FilterMode::Linear } else { wgpu::FilterMode::Nearest };
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("Shadows::comparison_sampler"),
        mag_filter: mode,
        min_filter: mode,
        compare: Some(wgpu::CompareFunction::LessEqual),
        ..Default::default()
    })
}

/// For moments.
fn smooth_sampler(device: &wgpu::Device, prefilter: &Prefilter) -> wgpu::Sampler {
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("Shadows::smooth_sampler"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        anisotropy_clamp: if prefilter.mip_levels > 1 { prefilter.anisotropy as u16 } else { 1 },
        ..Default::default()
    })
}
