//! What shaders that ask for visibility bind: the frame, the maps, and what a filter has made of them.

use umbrage_core::{Filter, Stored};
use umbrage_wgsl::{Binding, BindingKind, SamplerKind};

use crate::bindings;
use crate::filtered::Filtered;
use crate::frame::FrameBuffers;
use crate::maps::Maps;
use crate::objects::Objects;
use crate::occluders::Occluders;

/// The layout of receivers' group, and what it is for.
#[derive(Clone, Debug)]
pub(crate) struct ReceiverLayout {
    pub bindings: Vec<Binding>,
    pub layout: wgpu::BindGroupLayout,
}

/// All that receivers may bind.
#[derive(Clone, Copy)]
pub(crate) struct Bound<'a> {
    pub buffers: &'a FrameBuffers,
    pub maps: &'a Maps,
    pub filtered: Option<&'a Filtered>,
    pub samplers: &'a Samplers,
    pub occluders: Option<&'a Occluders>,
}

impl ReceiverLayout {
    pub fn new(objects: &Objects<'_>, bindings: Vec<Binding>) -> Self {
        let layout = bindings::group_layout(objects, "Shadows::receiver_layout", &bindings);
        Self { bindings, layout }
    }

    /// The group that binds these.
    pub fn group(&self, objects: &Objects<'_>, bound: Bound<'_>) -> wgpu::BindGroup {
        objects.group(&wgpu::BindGroupDescriptor {
            label: Some("Shadows::receiver_group"),
            layout: &self.layout,
            entries: &self.entries(bound, 0),
        })
    }

    /// The entries of a group that binds these, with number `first` in place of 0.
    pub fn entries<'a>(&self, bound: Bound<'a>, first: u32) -> Vec<wgpu::BindGroupEntry<'a>> {
        let entry = |binding: &Binding| wgpu::BindGroupEntry {
            binding: first + binding.binding,
            resource: bound.resource(binding),
        };
        self.bindings.iter().map(entry).collect()
    }
}

impl<'a> Bound<'a> {
    /// What a binding binds.
    fn resource(self, binding: &Binding) -> wgpu::BindingResource<'a> {
        let Self { buffers, maps, filtered, samplers, occluders } = self;
        match (binding.kind, binding.binding) {
            (BindingKind::Sampler(SamplerKind::Comparison), _) => {
                wgpu::BindingResource::Sampler(&samplers.comparison)
            }
            (BindingKind::Sampler(SamplerKind::NonFiltering), _) => {
                wgpu::BindingResource::Sampler(&samplers.nearest)
            }
            (BindingKind::Sampler(SamplerKind::Filtering), _) => {
                wgpu::BindingResource::Sampler(&samplers.smooth)
            }
            (BindingKind::Texture { .. }, 1) => wgpu::BindingResource::TextureView(&maps.all),
            (BindingKind::Texture { .. } | BindingKind::StorageTexture { .. }, _) => {
                let filtered = filtered.map_or(&maps.all, |filtered| &filtered.textures().all);
                wgpu::BindingResource::TextureView(filtered)
            }
            (BindingKind::Storage | BindingKind::WrittenStorage | BindingKind::Uniform { .. }, number) => {
                let occluders = occluders.and_then(|occluders| occluders.buffer(number));
                occluders.unwrap_or(&buffers.frame).as_entire_binding()
            }
        }
    }
}

/// The samplers of receivers.
#[derive(Clone, Debug)]
pub(crate) struct Samplers {
    kind: SamplersKind,
    /// Lit where the depth to compare with is not greater than what is stored.
    comparison: wgpu::Sampler,
    /// For depths as they are.
    nearest: wgpu::Sampler,
    /// For moments.
    smooth: wgpu::Sampler,
}

/// What tells samplers apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SamplersKind {
    /// Whether four texels are compared, and not one.
    is_bilinear: bool,
    anisotropy: u16,
}

impl SamplersKind {
    /// What a filter asks for.
    pub fn of(filter: &Filter) -> Self {
        let anisotropy = match filter.stores() {
            Stored::Prefiltered { prefilter, .. } if prefilter.mip_levels > 1 => prefilter.anisotropy as u16,
            Stored::Depths | Stored::Prefiltered { .. } | Stored::Summed { .. } => 1,
        };
        Self { is_bilinear: filter.is_bilinear(), anisotropy }
    }
}

impl Samplers {
    pub fn new(objects: &Objects<'_>, kind: SamplersKind) -> Self {
        let mode = if kind.is_bilinear { wgpu::FilterMode::Linear } else { wgpu::FilterMode::Nearest };
        let comparison = objects.sampler(&wgpu::SamplerDescriptor {
            label: Some("Shadows::comparison_sampler"),
            mag_filter: mode,
            min_filter: mode,
            compare: Some(wgpu::CompareFunction::GreaterEqual),
            ..Default::default()
        });
        let nearest = objects.sampler(&wgpu::SamplerDescriptor {
            label: Some("Shadows::nearest_sampler"),
            ..Default::default()
        });
        let smooth = objects.sampler(&wgpu::SamplerDescriptor {
            label: Some("Shadows::smooth_sampler"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: wgpu::MipmapFilterMode::Linear,
            anisotropy_clamp: kind.anisotropy,
            ..Default::default()
        });
        Self { kind, comparison, nearest, smooth }
    }

    /// Whether they are what is asked for.
    pub fn are(&self, kind: SamplersKind) -> bool {
        self.kind == kind
    }
}
