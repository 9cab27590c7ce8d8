//! What the texts of receivers depend on.

use umbrage_core::{
    CompareDepth, Exact, Filter, RASTER_STEP_TEXELS, Select, Settings, ShaderNumber, ShaderValue,
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
    /// Which receivers are traced, and through what; `None` where none are.
    pub(crate) traced: Option<Traced>,
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

/// What casters are like, as far as rays through them care.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct OccluderTraits {
    /// Whether some triangles are not solid.
    pub covers: bool,
    /// Whether some instances are left to maps: rays know only the box around them.
    pub left_to_maps: bool,
}

/// Which receivers are traced, and through what.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Traced {
    /// Whether only those are of which the map is not sure.
    pub undecided: bool,
    pub occluders: OccluderTraits,
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
    /// The key of settings on a device, where there is nothing to trace: maps answer whatever `exact` is.
    pub fn new(settings: &Settings, support: TextureSupport) -> Self {
        Self::with_occluders(settings, support, None)
    }

    /// The key of settings on a device, where there are such occluders. On devices that do not read depths as numbers, none are
    /// traced.
    pub fn with_occluders(
        settings: &Settings,
        support: TextureSupport,
        occluders: Option<OccluderTraits>,
    ) -> Self {
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
            traced: occluders.filter(|_| support.loads_depth).and_then(|of| Traced::by(settings.exact, of)),
            constants: numbers.iter().map(|number| (number.name, Constant::from(&number.value))).collect(),
        }
    }

    /// Whether some receivers are traced.
    pub fn traces(&self) -> bool {
        self.traced.is_some()
    }

    /// Whether texts read depths four at once.
    pub(crate) fn gathers(&self) -> bool {
        self.read == Read::Gathered || self.traced.is_some_and(|traced| traced.undecided)
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
            ("umbrage_reaching", Traced::module(self.traced)),
            ("UMBRAGE_TURNED_AWAY", Traced::module(self.traced)),
            ("umbrage_select", select),
            ("umbrage_blend", if self.blends { blend } else { "receiver/blend_none" }),
            ("umbrage_gradient", compare),
            ("umbrage_normal_offset", compare),
            ("umbrage_tap", tap),
            ("umbrage_lit", lit),
            ("umbrage_filter", modules::filter_module(self.filter, filter)),
        ];
        // Lights have a size where the filter searches for blockers.
        let is_soft = self.filter == "pcss";
        if let Some(Traced { undecided, occluders: OccluderTraits { covers, left_to_maps } }) = self.traced {
            choices.extend([
                ("umbrage_traced", if left_to_maps { "exact/traced_or_looked_up" } else { "exact/traced" }),
                ("umbrage_known", if undecided { "exact/undecided" } else { "exact/always" }),
                ("umbrage_reaching_by_rays", "exact/reaching"),
                ("umbrage_rays", if is_soft { "exact/rays_disc" } else { "exact/rays_middle" }),
                ("umbrage_sure", if is_soft { "exact/decided_soft" } else { "exact/decided_hard" }),
                ("umbrage_covered", if covers { "exact/covered_cut" } else { "exact/covered_solid" }),
            ]);
        }
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

impl Traced {
    fn by(exact: Exact, occluders: OccluderTraits) -> Option<Self> {
        match exact {
            Exact::Off => None,
            Exact::Undecided => Some(Self { undecided: true, occluders }),
            Exact::Always => Some(Self { undecided: false, occluders }),
        }
    }

    /// The module that says how much of a light reaches a receiver.
    fn module(traced: Option<Self>) -> &'static str {
        if traced.is_some() { "exact/reaching" } else { "exact/off" }
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
