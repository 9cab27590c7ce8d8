//! What lookups read instead of depths, where the filter stores something else: moments or sums of them.

use umbrage_core::{Filter, ShadowView, Stored};
use umbrage_wgsl::ShaderKey;

use crate::filtered_textures::{Source, Textures};
use crate::prefilter::MomentMaps;
use crate::sums::SumMaps;

/// Moments or sums of all views, and the steps that make them.
#[derive(Clone, Debug)]
pub(crate) enum Filtered {
    Moments(MomentMaps),
    Sums(SumMaps),
}

impl Filtered {
    /// Moments or sums for a key; `None` where depths themselves are read. Textures of `old` are kept where they fit.
    pub fn new(source: Source<'_>, key: &ShaderKey, filter: &Filter, old: Option<&Self>) -> Option<Self> {
        let old = old.map(Self::textures);
        match filter.stores() {
            Stored::Depths => None,
            Stored::Prefiltered { prefilter, .. } => {
                Some(Self::Moments(MomentMaps::new(source, &key.moment_steps()?, prefilter, old)))
            }
            Stored::Summed { .. } => Some(Self::Sums(SumMaps::new(source, &key.sum_steps()?, old))),
        }
    }

    pub fn textures(&self) -> &Textures {
        match self {
            Self::Moments(MomentMaps { textures, .. }) | Self::Sums(SumMaps { textures, .. }) => textures,
        }
    }

    /// Makes what lookups read of these views.
    pub fn record<'v>(
        &self,
        pass: &mut wgpu::ComputePass<'_>,
        views: impl Iterator<Item = &'v ShadowView> + Clone,
    ) {
        match self {
            Self::Moments(moments) => moments.record(pass, views),
            Self::Sums(sums) => sums.record(pass, views),
        }
    }
}
