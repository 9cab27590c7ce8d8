//! How is a map of moments made smooth before it is read?

use crate::error::SettingsError;
use crate::filter::shader::ShaderNumber;
use crate::kernel::gaussian;
use crate::schema::cost::Cost;
use crate::schema::group::Group;
use crate::schema::key::Key;
use crate::schema::values::Values;

/// How a map of moments is made smooth before it is read.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Prefilter {
    /// How far the Gaussian reaches, from 0 to 16 texels of moments; its standard deviation is half of it, and 0 is no
    /// blur. The default is 2.
    pub blur_texels: u32,
    /// How many depths make one texel of moments, 1 or 2 depths a side. With 2, moments have a quarter of the texels, each
    /// the mean of four depths: what multisampling of a map that small would resolve to. The default is 1.
    pub downsample: u32,
    /// How many mip levels the moments are kept in, each half of the one before, from 1 to 12 levels. The default is 1.
    pub mip_levels: u32,
    /// The most lookups along a long footprint, from 1 to 16 lookups; it needs more than one level. The default is 1.
    pub anisotropy: u32,
}

impl Default for Prefilter {
    fn default() -> Self {
        Self { blur_texels: 2, downsample: 1, mip_levels: 1, anisotropy: 1 } // as wide as PCF 5 × 5
    }
}

impl Prefilter {
    /// The numbers of the shaders that make moments smooth, and of those that read them.
    pub(super) fn numbers(&self) -> [ShaderNumber; 4] {
        [
            ShaderNumber::f32("UMBRAGE_MOMENTS_INSET", 0.5 * self.downsample as f32),
            ShaderNumber::u32("UMBRAGE_DOWNSAMPLE", self.downsample),
            ShaderNumber::i32("UMBRAGE_BLUR", self.blur_texels.cast_signed()),
            ShaderNumber::f32s("UMBRAGE_WEIGHTS", gaussian(self.blur_texels)),
        ]
    }

    /// How far a lookup of smooth moments reaches, texels of the depth map.
    pub(in crate::filter) fn reach_texels(&self) -> f32 {
        (self.downsample * (self.blur_texels + 1)) as f32
    }

    pub(in crate::filter) fn validate(&self) -> Result<(), SettingsError> {
        let Self { blur_texels, downsample, mip_levels, anisotropy } = *self;
        BLUR_TEXELS.check(blur_texels)?;
        DOWNSAMPLE.check(downsample)?;
        MIP_LEVELS.check(mip_levels)?;
        ANISOTROPY.check(anisotropy)
    }
}

pub(super) const BLUR_TEXELS: Key = Key {
    name: "filter.prefilter.blur_texels",
    label: "blur",
    help: "How far the Gaussian reaches, in texels of moments; its standard deviation is half of it, 0 is no blur. \
           More of it makes softer edges, and costs lookups for every texel of the map.",
    unit: "texels",
    costs: &[Cost::Plan, Cost::Shader, Cost::Maps],
    values: Values::whole(0, 16),
    ..Key::of(Group::Filter)
};

pub(super) const DOWNSAMPLE: Key = Key {
    name: "filter.prefilter.downsample",
    label: "downsample",
    help: "How many depths a side make one texel of moments. \
           With 2, moments take a quarter of the memory, and edges are softer.",
    unit: "depths a side",
    costs: &[Cost::Plan, Cost::Shader, Cost::Maps],
    values: Values::whole(1, 2),
    ..Key::of(Group::Filter)
};

pub(super) const MIP_LEVELS: Key = Key {
    name: "filter.prefilter.mip_levels",
    label: "mip levels",
    help: "How many mip levels the moments are kept in, each half of the one before. \
           More of them keep far shadows from flickering, and cost up to a third more memory.",
    unit: "levels",
    costs: &[Cost::Shader, Cost::Maps],
    values: Values::whole(1, 12),
    ..Key::of(Group::Filter)
};

pub(super) const ANISOTROPY: Key = Key {
    name: "filter.prefilter.anisotropy",
    label: "anisotropy",
    help: "The most lookups along a long footprint; needs more than one mip level. \
           More of them keep slanted shadows sharp.",
    unit: "lookups",
    costs: &[Cost::Maps],
    values: Values::whole(1, 16),
    ..Key::of(Group::Filter)
};
