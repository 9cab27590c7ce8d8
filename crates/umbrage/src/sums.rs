//! Summed-area tables of moments: made of the depth maps by compute, so that a box of any size is sixteen reads.
//!
//! Source: Crow, SIGGRAPH 1984; in whole numbers that wrap around, Peters et al., JCGT 6 (1), 2017, §4. `shaders/prefilter/sum.wgsl`
//! of `umbrage-wgsl` has the steps, `shaders/sampling/box.wgsl` the reads.

use umbrage_core::ShadowView;
use umbrage_wgsl::SumSteps;

use crate::compute::{Kernel, KernelOn};
use crate::filtered_textures::{Extent, Source, Textures};

/// Sums of all views, and the steps that make them.
#[derive(Clone, Debug)]
pub(crate) struct SumMaps {
    pub textures: Textures,
    /// A step for each layer.
    rows: Vec<KernelOn>,
    columns: Vec<KernelOn>,
}

impl SumMaps {
    pub fn new(source: Source<'_>, steps: &SumSteps, old: Option<&Textures>) -> Self {
        let Source { objects, buffers, depths, layout, min_layers } = source;
        let extent = Extent {
            format: steps.format,
            size: [layout.width, layout.height],
            layers: layout.layers.max(min_layers),
            levels: 1,
            scratch_side: layout.width.min(layout.height),
        };
        let textures = Textures::new(objects, extent, old);
        let (rows, columns) = (Kernel::new(objects, &steps.rows), Kernel::new(objects, &steps.columns));
        let column =
            |layer| columns.on(objects, buffers, &textures.scratch, &textures.layer(objects, layer, 0));
        Self {
            rows: (0..layout.layers).map(|_| rows.on(objects, buffers, depths, &textures.scratch)).collect(),
            columns: (0..layout.layers).map(column).collect(),
            textures,
        }
    }

    /// Makes the sums of a plan's views.
    pub fn record<'v>(&self, pass: &mut wgpu::ComputePass<'_>, views: impl Iterator<Item = &'v ShadowView>) {
        for view in views {
            let layer = view.tile.layer as usize;
            for steps in [&self.rows, &self.columns] {
                steps[layer].record(pass, view.index, [view.tile.size, 1]);
            }
        }
    }
}
