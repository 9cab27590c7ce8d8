//! Maps of moments: made of the depth maps, blurred and halved by compute, before anything reads them.
//!
//! For every view: depths become moments, and a Gaussian goes over rows into a square of scratch and over columns back. Then
//! every layer is halved to as many sizes as are wanted. `shaders/prefilter/` of `umbrage-wgsl` has the steps, `shaders/moments/`
//! what is stored.

use umbrage_core::{Prefilter, ShadowView};
use umbrage_wgsl::MomentSteps;

use crate::compute::{Kernel, KernelOn};
use crate::filtered_textures::{Extent, Source, Textures};

/// Moments of all views, and the steps that make them.
#[derive(Clone, Debug)]
pub(crate) struct MomentMaps {
    pub textures: Textures,
    prefilter: Prefilter,
    /// A step for each layer.
    convert: Vec<KernelOn>,
    blur: Option<[Vec<KernelOn>; 2]>,
    /// Size after size.
    halve: Vec<Vec<KernelOn>>,
}

impl MomentMaps {
    pub fn new(
        source: Source<'_>,
        steps: &MomentSteps,
        prefilter: Prefilter,
        old: Option<&Textures>,
    ) -> Self {
        let Source { objects, buffers, depths, layout, min_layers } = source;
        let size = [layout.width, layout.height].map(|side| side.div_ceil(prefilter.downsample));
        // No texture has a size below one texel.
        let levels = steps.levels.min(size[0].max(size[1]).max(1).ilog2() + 1);
        let extent = Extent {
            format: steps.format.format,
            size,
            layers: layout.layers.max(min_layers),
            levels,
            scratch_side: if prefilter.blur_texels > 0 { size[0].min(size[1]) } else { 1 },
        };
        let textures = Textures::new(objects, extent, old);
        let level_0: Vec<_> = (0..layout.layers).map(|layer| textures.layer(objects, layer, 0)).collect();
        let on = |kernel: &Kernel, read: &_, written: &_| kernel.on(objects, buffers, read, written);

        let convert = Kernel::new(objects, &steps.convert);
        let scratch = &textures.scratch;
        let blur = (prefilter.blur_texels > 0).then(|| {
            let (across, down) = (Kernel::new(objects, &steps.across), Kernel::new(objects, &steps.down));
            [
                level_0.iter().map(|layer| on(&across, layer, scratch)).collect(),
                level_0.iter().map(|layer| on(&down, scratch, layer)).collect(),
            ]
        });
        let halve = Kernel::new(objects, &steps.halve);
        let level = |layer, level| textures.layer(objects, layer, level);
        let halved = |layer, to| on(&halve, &level(layer, to - 1), &level(layer, to));
        Self {
            prefilter,
            convert: level_0.iter().map(|layer| on(&convert, depths, layer)).collect(),
            blur,
            halve: (1..levels)
                .map(|level| (0..layout.layers).map(|layer| halved(layer, level)).collect())
                .collect(),
            textures,
        }
    }

    /// Makes the moments of a plan's views.
    pub fn record<'v>(
        &self,
        pass: &mut wgpu::ComputePass<'_>,
        views: impl Iterator<Item = &'v ShadowView> + Clone,
    ) {
        for view in views.clone() {
            let (layer, side) = (view.tile.layer as usize, view.tile.size / self.prefilter.downsample);
            self.convert[layer].record(pass, view.index, [side.div_ceil(8); 2]);
            for steps in self.blur.iter().flatten() {
                steps[layer].record(pass, view.index, [side.div_ceil(64), side]);
            }
        }
        // Of the layers that these views have.
        let layers = views.map(|view| view.tile.layer as usize + 1).max().unwrap_or(0);
        for (level, steps) in (1..).zip(&self.halve) {
            let groups = self.textures.extent.size.map(|side| (side >> level).max(1).div_ceil(8));
            steps.iter().take(layers).for_each(|step| step.record(pass, 0, groups));
        }
    }
}
