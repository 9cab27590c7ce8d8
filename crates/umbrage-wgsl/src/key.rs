//! What the texts of receivers depend on.

use umbrage_core::{CompareDepth, Moments, RASTER_STEP_TEXELS, Select, Settings};

use crate::constants::Constant;
use crate::filter_constants::{filter_constants, moment_constants};
use crate::format::{MomentFormat, TexelFormat, TextureSupport, sum_format};

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
    /// Whether views are blended with the next.
    blends: bool,
    /// What is stored instead of depth.
    pub(crate) stored: Option<Stored>,
    constants: Vec<(&'static str, Constant)>,
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
        let filter = &settings.filter;
        let moments = filter.moments(1.0);
        let mut constants = vec![
            ("UMBRAGE_FILTER_REACH", Constant::float(filter.reach_texels())),
            ("UMBRAGE_PLANE_REACH", Constant::float(filter.plane_reach_texels())),
            ("UMBRAGE_STEEPEST_PLANE", Constant::float(filter.steepest_plane())),
            ("UMBRAGE_RASTER_STEP", Constant::float(RASTER_STEP_TEXELS)),
        ];
        constants.extend(filter_constants(filter));
        constants.extend(moments.as_ref().map(moment_constants).unwrap_or_default());
        let blurred = MomentFormat::of(filter, support).zip(filter.prefilter());
        let blurred = blurred
            .map(|(format, prefilter)| StoredLayout::Moments { format, levels: format.levels(prefilter) });
        let layout = blurred.or(sum_format(filter).map(|format| StoredLayout::Sums { format }));
        Self {
            filter: filter.kind(),
            select: settings.select,
            compare_depth: settings.compare_depth(),
            blends: settings.blend > 0.0,
            stored: moments.zip(layout).map(|(of, layout)| Stored { module: moments_module(&of), layout }),
            constants,
        }
    }

    /// The lines that declare the constants, by their names.
    pub(crate) fn constants(&self) -> Vec<(&'static str, String)> {
        self.constants.iter().map(|(name, constant)| (*name, constant.line(name))).collect()
    }

    /// Which module declares what this key chooses.
    pub(crate) fn choices(&self) -> Vec<(&'static str, &'static str)> {
        let (compare, by_texel) = match self.compare_depth {
            CompareDepth::Plane => ("receiver/compare_plane", true),
            CompareDepth::Facing => ("receiver/compare_facing", true),
            CompareDepth::Own => ("receiver/compare_own", false),
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
            ("umbrage_tap", if by_texel { "sampling/tap_one" } else { "sampling/tap_four" }),
            ("umbrage_filter", filter_module(self.filter, by_texel)),
        ];
        choices.extend(self.stored.as_ref().and_then(Stored::read_by).map(|by| ("umbrage_moments_at", by)));
        choices
    }
}

impl Stored {
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

/// A filter's module is the file of its kind; where each texel is compared by itself the one for that, if there is one.
fn filter_module(kind: &str, by_texel: bool) -> &'static str {
    let file = |name: String| crate::link::module(&name);
    let alone = by_texel.then(|| file(format!("filter/{kind}_by_texel"))).flatten();
    // Every kind has a file, as a test holds.
    alone.or_else(|| file(format!("filter/{kind}"))).unwrap_or("filter/hard")
}

pub(crate) fn moments_module(moments: &Moments) -> &'static str {
    match moments {
        Moments::Vsm(_) => "moments/vsm",
        Moments::Esm(_) => "moments/esm",
        Moments::Evsm2(_) => "moments/evsm2",
        Moments::Evsm4(_) => "moments/evsm4",
        Moments::Msm(_) => "moments/msm",
    }
}
