//! What the texts of receivers depend on.

use umbrage_core::{
    CompareDepth, Filter, RASTER_STEP_TEXELS, Select, Settings, ShaderNumber, ShaderValue,
    Stored as StoredByFilter,
};

use crate::constants::Constant;
use crate::format::{MomentFormat, TexelFormat, TextureSupport};
use crate::modules;

/// Everything that the texts of receivers, and of the steps before them, depend on: choices among modules, and numbers. Equal keys
/// give equal texts.
///
/// What is not in it is in the frame: λ, the shadow distance, the constants of the bias, the size of lights, the shade.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct ShaderKey {
    /// `filter.kind` of the settings.
    filter: &'static str,
    select: Select,
    compare_depth: CompareDepth,
    pub(crate) read: Read,
    /// Whether views are blended with the next.
    blends: bool,
    /// What is stored instead of depth.
    pub(crate) stored: Option<Stored>,
    constants: Vec<(&'static str, Constant)>,
}

/// Who compares a lookup's depth with what is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Read {
    /// Nobody compares: moments are read.
    Moments,
    /// Samplers compare four texels with one depth.
    Compared,
    /// Samplers compare, and each texel has a depth of its own.
    ComparedByTexel,
    /// Shaders compare, with depths that they read one by one.
    Loaded,
    /// Shaders compare, with depths that they read four at once.
    Gathered,
}

/// What a filter stores instead of depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Stored {
    /// The module that makes it of depth.
    pub module: &'static str,
    pub layout: StoredLayout,
}

/// How it lies in textures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum StoredLayout {
    /// Blurred moments, in so many sizes.
    Moments { format: MomentFormat, levels: u32 },
    /// Sums of moments.
    Sums { format: TexelFormat },
}

impl ShaderKey {
    /// The key of settings on a device.
    pub fn new(settings: &Settings, support: TextureSupport) -> Self {
        let value = ShaderValue::F32(RASTER_STEP_TEXELS);
        let mut numbers = settings.filter.numbers();
        numbers.push(ShaderNumber { name: "UMBRAGE_RASTER_STEP", value });
        Self {
            filter: settings.filter.kind(),
            select: settings.select,
            compare_depth: settings.compare_depth(),
            read: Read::of(settings, support),
            blends: settings.blend > 0.0,
            stored: Stored::by(&settings.filter, support),
            constants: numbers.iter().map(|number| (number.name, Constant::from(&number.value))).collect(),
        }
    }

    /// The lines that declare the constants, by their names.
    pub(crate) fn constants(&self) -> Vec<(&'static str, String)> {
        self.constants.iter().map(|(name, constant)| (*name, constant.line(name))).collect()
    }

    /// Which module declares what this key chooses.
    pub(crate) fn choices(&self) -> Vec<(&'static str, &'static str)> {
        let compare = match self.compare_depth {
            CompareDepth::Plane => "receiver/compare_plane",
            CompareDepth::Facing => "receiver/compare_facing",
            CompareDepth::Own => "receiver/compare_own",
        };
        let (tap, lit, filter) = match self.read {
            Read::Moments | Read::Compared => ("sampling/tap_four", "sampling/lit_compared", ""),
            Read::ComparedByTexel => ("sampling/tap_one", "sampling/lit_compared", "_by_texel"),
            Read::Loaded | Read::Gathered => ("sampling/tap_one", "sampling/lit_loaded", "_by_quad"),
        };
        let (select, blend) = match self.select {
            Select::Depth => ("receiver/select_depth", "receiver/blend_depth"),
            Select::ClipDepth => ("receiver/select_clip_depth", "receiver/blend_depth"),
            Select::Map => ("receiver/select_map", "receiver/blend_map"),
        };
        let mut choices = vec![
            ("umbrage_select", select),
            ("umbrage_blend", if self.blends { blend } else { "receiver/blend_none" }),
            ("umbrage_gradient", compare),
            ("umbrage_normal_offset", compare),
            ("umbrage_tap", tap),
            ("umbrage_lit", lit),
            ("umbrage_filter", modules::filter_module(self.filter, filter)),
        ];
        choices.extend(self.stored.as_ref().and_then(Stored::read_by).map(|by| ("umbrage_moments_at", by)));
        choices
    }
}

impl Read {
    fn of(settings: &Settings, support: TextureSupport) -> Self {
        if !settings.filter.compares_depths() {
            return Self::Moments;
        }
        let is_grid = modules::has_own(settings.filter.kind(), "_by_quad");
        match settings.compare_depth() {
            CompareDepth::Own => Self::Compared,
            CompareDepth::Plane | CompareDepth::Facing if !support.loads_depth => Self::ComparedByTexel,
            CompareDepth::Plane | CompareDepth::Facing if is_grid => Self::Gathered,
            CompareDepth::Plane | CompareDepth::Facing => Self::Loaded,
        }
    }
}

impl Stored {
    /// What a filter stores on a device; `None` where lookups read depths.
    fn by(filter: &Filter, support: TextureSupport) -> Option<Self> {
        let (texel, layout) = match filter.stores() {
            StoredByFilter::Depths => return None,
            StoredByFilter::Prefiltered { texel, precision, prefilter } => {
                let format = MomentFormat::new(precision, texel.channels, support);
                // Samplers choose among sizes; shaders read one.
                let levels = if format.is_filterable { prefilter.mip_levels } else { 1 };
                (texel, StoredLayout::Moments { format, levels })
            }
            StoredByFilter::Summed { texel, steps: _ } => {
                let format =
                    if texel.channels <= 2 { TexelFormat::Rg32Uint } else { TexelFormat::Rgba32Uint };
                (texel, StoredLayout::Sums { format })
            }
        };
        Some(Self { module: modules::moments_module(texel.moments), layout })
    }

    /// The module that looks moments up.
    fn read_by(&self) -> Option<&'static str> {
        match self.layout {
            StoredLayout::Sums { .. } => None,
            StoredLayout::Moments { format, .. } if !format.is_filterable => Some("storage/moments_loaded"),
            StoredLayout::Moments { levels: 1, .. } => Some("storage/moments_level"),
            StoredLayout::Moments { .. } => Some("storage/moments_footprint"),
        }
    }
}
