//! What a texel of the maps of moments and sums is.

use umbrage_core::TexelPrecision;

/// The format of a texture that a step writes and lookups read. Named as in WebGPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TexelFormat {
    /// One 32-bit float.
    R32Float,
    /// Two 32-bit floats.
    Rg32Float,
    /// Four 32-bit floats.
    Rgba32Float,
    /// Two 16-bit floats.
    Rg16Float,
    /// Four 16-bit floats.
    Rgba16Float,
    /// Four 16-bit normalised numbers.
    Rgba16Unorm,
    /// Two 32-bit whole numbers.
    Rg32Uint,
    /// Four 32-bit whole numbers.
    Rgba32Uint,
}

impl TexelFormat {
    /// The format's name in WGSL.
    pub fn wgsl(self) -> &'static str {
        match self {
            Self::R32Float => "r32float",
            Self::Rg32Float => "rg32float",
            Self::Rgba32Float => "rgba32float",
            Self::Rg16Float => "rg16float",
            Self::Rgba16Float => "rgba16float",
            Self::Rgba16Unorm => "rgba16unorm",
            Self::Rg32Uint => "rg32uint",
            Self::Rgba32Uint => "rgba32uint",
        }
    }

    /// Bytes a texel.
    pub fn bytes(self) -> u64 {
        match self {
            Self::R32Float | Self::Rg16Float => 4,
            Self::Rg32Float | Self::Rgba16Float | Self::Rgba16Unorm | Self::Rg32Uint => 8,
            Self::Rgba32Float | Self::Rgba32Uint => 16,
        }
    }
}

/// What a device can do, as far as formats and shader texts depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TextureSupport {
    /// Whether shaders read depths as numbers, one or four at once. Where not, as on OpenGL, samplers compare them.
    pub loads_depth: bool,
    /// Whether samplers weigh 32-bit textures. Where not, shaders do, at one size and without anisotropy.
    pub filters_float32: bool,
    /// Whether there are textures of 16-bit normalised numbers. Where not, 32 bits hold the same numbers.
    pub has_unorm16: bool,
    /// Whether compute shaders write textures of two 16-bit floats. Where not, they write four.
    pub writes_two_float16: bool,
}

impl TextureSupport {
    /// Everything that shadows can profit from.
    pub const ALL: Self =
        Self { loads_depth: true, filters_float32: true, has_unorm16: true, writes_two_float16: true };
    /// What every device with WebGPU can do.
    pub const WEBGPU: Self =
        Self { loads_depth: true, filters_float32: false, has_unorm16: false, writes_two_float16: false };
}

/// What a texel of moments is on a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MomentFormat {
    /// The texture's format.
    pub format: TexelFormat,
    /// Whether samplers weigh it.
    pub is_filterable: bool,
    /// Whether shaders round to 16 bits what the format would not.
    pub rounds: bool,
}

impl MomentFormat {
    /// What so many numbers of a precision are stored in.
    pub fn new(precision: TexelPrecision, channels: u32, support: TextureSupport) -> Self {
        use TexelFormat as F;
        let of = |format, is_filterable| Self { format, is_filterable, rounds: false };
        match (precision, channels) {
            (TexelPrecision::F32, 1) => of(F::R32Float, support.filters_float32),
            (TexelPrecision::F32, 2) => of(F::Rg32Float, support.filters_float32),
            (TexelPrecision::F32, _) => of(F::Rgba32Float, support.filters_float32),
            (TexelPrecision::F16, ..=2) if support.writes_two_float16 => of(F::Rg16Float, true),
            (TexelPrecision::F16, _) => of(F::Rgba16Float, true),
            (TexelPrecision::U16, _) if support.has_unorm16 => of(F::Rgba16Unorm, true),
            (TexelPrecision::U16, _) => Self { rounds: true, ..of(F::Rgba32Float, support.filters_float32) },
        }
    }
}
