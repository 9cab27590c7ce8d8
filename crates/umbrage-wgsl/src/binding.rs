//! What shader texts bind, as data: for any host, whatever graphics library it has.

use crate::format::TexelFormat;

/// One binding of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Binding {
    /// The binding's number.
    pub binding: u32,
    /// The variable's name in the text.
    pub name: &'static str,
    /// What is bound.
    pub kind: BindingKind,
    /// Which stages read it.
    pub stages: Stages,
}

/// What is bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BindingKind {
    /// A storage buffer that is only read.
    Storage,
    /// A storage buffer that is read and written.
    WrittenStorage,
    /// A uniform buffer, at an offset that is given with the group where `has_dynamic_offset`.
    Uniform {
        /// Whether the offset is given when the group is bound.
        has_dynamic_offset: bool,
    },
    /// A texture that is read.
    Texture {
        /// What a texel is read as.
        sample: SampleType,
        /// How the texture is seen.
        dimension: Dimension,
    },
    /// A texture that is only written, of one layer.
    StorageTexture {
        /// What a texel is.
        format: TexelFormat,
    },
    /// A sampler.
    Sampler(SamplerKind),
}

/// What a texel is read as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SampleType {
    /// Depth.
    Depth,
    /// Floats, which samplers may weigh.
    FilterableFloat,
    /// Floats, which samplers may not weigh.
    Float,
    /// Whole numbers.
    Uint,
}

/// How a texture is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// One layer.
    D2,
    /// One layer of several samples a texel.
    D2Multisampled,
    /// An array of layers.
    D2Array,
}

/// What a sampler does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SamplerKind {
    /// Compares: 1 where the given depth is not greater than the stored one.
    Comparison,
    /// Weighs texels.
    Filtering,
    /// Reads texels as they are.
    NonFiltering,
}

/// Which stages read a binding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stages {
    /// Vertex shaders.
    Vertex,
    /// Fragment shaders.
    Fragment,
    /// Vertex and fragment shaders.
    VertexAndFragment,
    /// Compute shaders.
    Compute,
    /// Fragment and compute shaders: whoever asks for visibility.
    FragmentAndCompute,
}

impl Binding {
    /// The frame of [`crate::FrameBytes`], at binding 0 of every group.
    pub(crate) const fn frame(stages: Stages) -> Self {
        Self { binding: 0, name: "umbrage_frame", kind: BindingKind::Storage, stages }
    }

    /// The index of the view that is drawn or computed: a `vec4u`, in x, at a dynamic offset.
    pub(crate) const fn current_view(stages: Stages) -> Self {
        let kind = BindingKind::Uniform { has_dynamic_offset: true };
        Self { binding: 1, name: "umbrage_current_view", kind, stages }
    }

    /// An array of depth maps.
    pub(crate) const fn depth_maps(binding: u32, name: &'static str, stages: Stages) -> Self {
        let kind = BindingKind::Texture { sample: SampleType::Depth, dimension: Dimension::D2Array };
        Self { binding, name, kind, stages }
    }
}
