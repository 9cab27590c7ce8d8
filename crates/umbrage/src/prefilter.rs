//! Maps of moments: made of the depth maps, blurred and halved by compute, before anything reads them.
//!
//! For every view: depths become moments, and a Gaussian goes over rows into a square of scratch and over columns back. Then
//! every layer is halved to as many sizes as are wanted. `shaders/prefilter/` has the steps, `shaders/moments/` what is
//! stored.

use umbrage_core::{Filter, MapLayout, Prefilter, ShadowPlan, Stored, TexelPrecision};

use crate::capabilities::Capabilities;
use crate::compute::{DEPTH_MAPS, Inputs, Kernel, Step, layer_of, layer_view};
use crate::moments::moments_files;
use crate::wgsl::{DEPTH, FRAME, declared};

/// What a texel of moments is on a device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MomentFormat {
    pub format: wgpu::TextureFormat,
    /// What WGSL calls it.
    name: &'static str,
    /// Whether samplers weigh it.
    pub is_filterable: bool,
    /// Whether shaders round to 16 bits what the format would not.
    rounds: bool,
    /// How many sizes are made: one, where samplers do not choose among them.
    pub levels: u32,
    /// How they are made smooth.
    pub prefilter: Prefilter,
    /// Which moments they are.
    moments: &'static str,
}

impl MomentFormat {
    /// What a filter's moments are stored in; `None` for a filter that has none, or sums of them.
    pub fn of(filter: &Filter, capabilities: Capabilities) -> Option<Self> {
        use wgpu::TextureFormat as F;
        let Stored::Prefiltered { texel, precision, prefilter } = filter.stores() else { return None };
        let is_filterable = precision == TexelPrecision::F16 || capabilities.filters_float32;
        let levels = |is_filterable| if is_filterable { prefilter.mip_levels } else { 1 };
        let of = |format, name| Self {
            format,
            name,
            is_filterable,
            rounds: false,
            levels: levels(is_filterable),
            prefilter,
            moments: texel.moments,
        };
        Some(match (precision, texel.channels) {
            (TexelPrecision::F32, 1) => of(F::R32Float, "r32float"),
            (TexelPrecision::F32, 2) => of(F::Rg32Float, "rg32float"),
            (TexelPrecision::F32, _) => of(F::Rgba32Float, "rgba32float"),
            (TexelPrecision::F16, ..=2) if capabilities.writes_two_float16 => of(F::Rg16Float, "rg16float"),
            (TexelPrecision::F16, _) => of(F::Rgba16Float, "rgba16float"),
            (TexelPrecision::U16, _) if capabilities.has_unorm16 => {
                Self { is_filterable: true, levels: levels(true), ..of(F::Rgba16Unorm, "rgba16unorm") }
            }
            (TexelPrecision::U16, _) => Self { rounds: true, ..of(F::Rgba32Float, "rgba32float") },
        })
    }
}

/// Moments of all views, and the steps that make them.
#[derive(Debug)]
pub(crate) struct MomentMaps {
    /// All layers and sizes, for lookups.
    pub all: wgpu::TextureView,
    /// Of moments and scratch.
    pub bytes: u64,
    size: [u32; 2],
    prefilter: Prefilter,
    /// A step for each layer.
    convert: Vec<Step>,
    blur: Option<[Vec<Step>; 2]>,
    /// Size after size.
    halve: Vec<Vec<Step>>,
}

impl MomentMaps {
    /// Moments for depth maps that lie so; `None` for a filter that has none.
    pub fn new(
        inputs: Inputs<'_>,
        filter: &Filter,
        capabilities: Capabilities,
        depths: &wgpu::TextureView,
        layout: MapLayout,
    ) -> Option<Self> {
        let format = MomentFormat::of(filter, capabilities)?;
        let prefilter = format.prefilter;
        let size = [layout.width, layout.height].map(|side| side.div_ceil(prefilter.downsample));
        // No texture has a size below one texel.
        let levels = format.levels.min(size[0].max(size[1]).max(1).ilog2() + 1);
        let layers = layout.layers.max(capabilities.least_layers);
        let made = texture(inputs.device, format.format, size, layers, levels);
        let scratch_side = if prefilter.blur_texels > 0 { size[0].min(size[1]) } else { 1 };
        let scratch = texture(inputs.device, format.format, [scratch_side; 2], 1, 1);
        let scratch = layer_view(&scratch, 0, 0);
        let kernel = |step: &str, entry: &str, read| {
            let text = text(filter, format, step);
            Kernel::new(inputs.device, &text, entry, read, format.format)
        };
        let stored = layer_of(wgpu::TextureSampleType::Float { filterable: false });
        let level_0: Vec<_> = (0..layout.layers).map(|layer| layer_view(&made, layer, 0)).collect();

        let convert = kernel(include_str!("../shaders/prefilter/convert.wgsl"), "convert", DEPTH_MAPS);
        let blur = (prefilter.blur_texels > 0).then(|| {
            let blur = include_str!("../shaders/prefilter/blur.wgsl");
            let (across, down) = (kernel(blur, "across", stored), kernel(blur, "down", stored));
            [
                level_0.iter().map(|layer| across.on(inputs, layer, &scratch)).collect(),
                level_0.iter().map(|layer| down.on(inputs, &scratch, layer)).collect(),
            ]
        });
        let halve = kernel(include_str!("../shaders/prefilter/halve.wgsl"), "halve", stored);
        let halved = |layer, level| {
            halve.on(inputs, &layer_view(&made, layer, level - 1), &layer_view(&made, layer, level))
        };
        let texel = u64::from(format.format.block_copy_size(None).unwrap_or_default());
        let texels_of =
            |level: u32| size.map(|side| u64::from((side >> level).max(1))).iter().product::<u64>();
        let texels = (0..levels).map(texels_of).sum::<u64>() * u64::from(layers);
        Some(Self {
            all: made.create_view(&wgpu::TextureViewDescriptor {
                label: Some("MomentMaps::all"),
                dimension: Some(wgpu::TextureViewDimension::D2Array),
                ..Default::default()
            }),
            bytes: (texels + u64::from(scratch_side).pow(2)) * texel,
            size,
            prefilter,
            convert: level_0.iter().map(|layer| convert.on(inputs, depths, layer)).collect(),
            blur,
            halve: (1..levels)
                .map(|level| (0..layout.layers).map(|layer| halved(layer, level)).collect())
                .collect(),
        })
    }

    /// Makes the moments of a plan's views.
    pub fn record(&self, pass: &mut wgpu::ComputePass<'_>, plan: &ShadowPlan) {
        for view in plan.views() {
            let (layer, side) = (view.tile.layer as usize, view.tile.size / self.prefilter.downsample);
            self.convert[layer].record(pass, view.index, [side.div_ceil(8); 2]);
            for steps in self.blur.iter().flatten() {
                steps[layer].record(pass, view.index, [side.div_ceil(64), side]);
            }
        }
        // Of the layers that this plan has.
        let layers = plan.views().iter().map(|view| view.tile.layer as usize + 1).max().unwrap_or(0);
        for (level, steps) in (1..).zip(&self.halve) {
            let groups = self.size.map(|side| (side >> level).max(1).div_ceil(8));
            steps.iter().take(layers).for_each(|step| step.record(pass, 0, groups));
        }
    }
}

/// A texture that steps read and write.
pub(crate) fn texture(
    device: &wgpu::Device,
    format: wgpu::TextureFormat,
    [width, height]: [u32; 2],
    layers: u32,
    levels: u32,
) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("MomentMaps::texture"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: layers },
        mip_level_count: levels,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::STORAGE_BINDING,
        view_formats: &[],
    })
}

/// A step's text, with what stands before it.
fn text(filter: &Filter, format: MomentFormat, step: &str) -> String {
    let stored = if format.rounds {
        include_str!("../shaders/prefilter/rounded.wgsl")
    } else {
        include_str!("../shaders/prefilter/as_it_is.wgsl")
    };
    let (numbers, moments) = (declared(&filter.numbers()), moments_files(format.moments));
    [FRAME, DEPTH, &numbers, &moments, stored, step].join("\n").replace("UMBRAGE_FORMAT", format.name)
}
