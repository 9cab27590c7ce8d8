//! A binding of a shader text as plain data, in WebGPU's words.

use serde::Serialize;
use umbrage_wgsl::{Binding, BindingKind, Dimension, SampleType, SamplerKind, Stages};

/// One binding of a group.
#[derive(Clone, Debug, Serialize)]
pub struct BindingData {
    binding: u32,
    /// The variable's name in the text.
    name: &'static str,
    #[serde(flatten)]
    kind: Kind,
    /// Which stages read it: `vertex`, `fragment`, `compute`.
    stages: &'static [&'static str],
}

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
enum Kind {
    /// A storage buffer that is only read.
    Storage,
    /// A storage buffer that is read and written.
    WrittenStorage,
    Uniform {
        has_dynamic_offset: bool,
    },
    Texture {
        sample_type: &'static str,
        view_dimension: &'static str,
    },
    /// A texture that is only written.
    StorageTexture {
        format: &'static str,
    },
    Sampler {
        sampler_type: &'static str,
    },
}

impl From<&Binding> for BindingData {
    fn from(of: &Binding) -> Self {
        let Binding { binding, name, kind, stages } = *of;
        Self { binding, name, kind: kind_of(kind), stages: stages_of(stages) }
    }
}

fn kind_of(kind: BindingKind) -> Kind {
    match kind {
        BindingKind::Storage => Kind::Storage,
        BindingKind::WrittenStorage => Kind::WrittenStorage,
        BindingKind::Uniform { has_dynamic_offset } => Kind::Uniform { has_dynamic_offset },
        BindingKind::Texture { sample, dimension } => {
            Kind::Texture { sample_type: sample_type(sample), view_dimension: view_dimension(dimension) }
        }
        BindingKind::StorageTexture { format } => Kind::StorageTexture { format: format.wgsl() },
        BindingKind::Sampler(kind) => Kind::Sampler { sampler_type: sampler_type(kind) },
    }
}

/// Returns WebGPU's word for what a texel is read as.
pub(crate) fn sample_type(sample: SampleType) -> &'static str {
    match sample {
        SampleType::Depth => "depth",
        SampleType::FilterableFloat => "float",
        SampleType::Float => "unfilterable-float",
        SampleType::Uint => "uint",
    }
}

/// Returns WebGPU's word for how a texture is seen.
pub(crate) fn view_dimension(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::D2 | Dimension::D2Multisampled => "2d",
        Dimension::D2Array => "2d-array",
    }
}

/// Returns WebGPU's word for a kind of sampler.
pub(crate) fn sampler_type(kind: SamplerKind) -> &'static str {
    match kind {
        SamplerKind::Comparison => "comparison",
        SamplerKind::Filtering => "filtering",
        SamplerKind::NonFiltering => "non-filtering",
    }
}

fn stages_of(stages: Stages) -> &'static [&'static str] {
    match stages {
        Stages::Vertex => &["vertex"],
        Stages::Fragment => &["fragment"],
        Stages::VertexAndFragment => &["vertex", "fragment"],
        Stages::Compute => &["compute"],
        Stages::FragmentAndCompute => &["fragment", "compute"],
    }
}
