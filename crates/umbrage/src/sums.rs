//! Summed-area tables of moments: made of the depth maps by compute, so that a box of any size is sixteen reads.
//!
//! Source: Crow, SIGGRAPH 1984; in whole numbers that wrap around, Peters et al., JCGT 6 (1), 2017, §4. `shaders/prefilter/sum.wgsl` has
//! the steps, `shaders/sample/box.wgsl` the reads.

use umbrage_core::{Filter, MapLayout, ShadowPlan, Stored};

use crate::capabilities::Capabilities;
use crate::compute::{DEPTH_MAPS, Inputs, Kernel, Step, layer_of, layer_view};
use crate::moments::moments_files;
use crate::prefilter::texture;
use crate::wgsl::{DEPTH, FRAME, declared};

/// Sums of all views, and the steps that make them.
#[derive(Debug)]
pub(crate) struct SumMaps {
    /// All layers, for lookups.
    pub all: wgpu::TextureView,
    /// Of sums and scratch.
    pub bytes: u64,
    /// A step for each layer.
    rows: Vec<Step>,
    columns: Vec<Step>,
}

impl SumMaps {
    /// Sums for depth maps that lie so; `None` for a filter that has none.
    pub fn new(
        inputs: Inputs<'_>,
        filter: &Filter,
        capabilities: Capabilities,
        depths: &wgpu::TextureView,
        layout: MapLayout,
    ) -> Option<Self> {
        let Stored::Summed { texel, steps: _ } = filter.stores() else { return None };
        let (format, name) = match texel.channels {
            ..=2 => (wgpu::TextureFormat::Rg32Uint, "rg32uint"),
            _ => (wgpu::TextureFormat::Rgba32Uint, "rgba32uint"),
        };
        let (numbers, moments) = (declared(&filter.numbers()), moments_files(texel.moments));
        let steps = include_str!("../shaders/prefilter/sum.wgsl");
        let text = [FRAME, DEPTH, &numbers, &moments, steps].join("\n").replace("UMBRAGE_SUM_FORMAT", name);
        let layers = layout.layers.max(capabilities.least_layers);
        let side = layout.width.min(layout.height);
        let made = texture(inputs.device, format, [layout.width, layout.height], layers, 1);
        let scratch = layer_view(&texture(inputs.device, format, [side; 2], 1, 1), 0, 0);
        let rows = Kernel::new(inputs.device, &text, "rows", DEPTH_MAPS, format);
        let read = layer_of(wgpu::TextureSampleType::Uint);
        let columns = Kernel::new(inputs.device, &text, "columns", read, format);
        let texel = u64::from(format.block_copy_size(None).unwrap_or_default());
        let texels = u64::from(layout.width) * u64::from(layout.height) * u64::from(layers);
        Some(Self {
            all: made.create_view(&wgpu::TextureViewDescriptor {
                label: Some("SumMaps::all"),
                dimension: Some(wgpu::TextureViewDimension::D2Array),
                ..Default::default()
            }),
            bytes: (texels + u64::from(side).pow(2)) * texel,
            rows: (0..layout.layers).map(|_| rows.on(inputs, depths, &scratch)).collect(),
            columns: (0..layout.layers)
                .map(|layer| columns.on(inputs, &scratch, &layer_view(&made, layer, 0)))
                .collect(),
        })
    }

    /// Makes the sums of a plan's views.
    pub fn record(&self, pass: &mut wgpu::ComputePass<'_>, plan: &ShadowPlan) {
        for view in plan.views() {
            let layer = view.tile.layer as usize;
            for steps in [&self.rows, &self.columns] {
                steps[layer].record(pass, view.index, [view.tile.size, 1]);
            }
        }
    }
}
