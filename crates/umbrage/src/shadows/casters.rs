//! What a host needs for pipelines that draw casters: made for it, or to agree with.

use umbrage_core::CasterKey;

use super::Shadows;
use crate::caster_pipeline::CasterPipeline;
use crate::caster_state::CasterState;

impl Shadows {
    /// Makes a depth-only pipeline for the host's vertices and fragments, with the settings' raster bias and faces.
    pub fn caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> wgpu::RenderPipeline {
        pipeline.make(device, self.caster_state())
    }

    /// Makes the same for views whose [`ShadowView::unclipped_depth`](umbrage_core::ShadowView::unclipped_depth) is off, where
    /// [`Self::caster_pipeline`] flattens casters onto the near plane: it clips them there. Only a lamp within a bulb needs it
    /// ([`Light::with_near`](umbrage_core::Light::with_near)); `None` where the other one clips already.
    pub fn clipping_caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> Option<wgpu::RenderPipeline> {
        Some(pipeline.make(device, self.clipping_caster_state()?))
    }

    /// Makes the same for [`Self::cast_second`] and [`Self::begin_second`]; `None` where there is no second surface. A fragment
    /// stage stands in a module behind [`second_caster_wgsl`](crate::second_caster_wgsl) here; without one, nothing changes.
    pub fn second_caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> Option<wgpu::RenderPipeline> {
        Some(pipeline.make_second(device, self.second_caster_state()?))
    }

    /// Returns what a pipeline agrees with that the host builds itself, instead of [`Self::caster_pipeline`].
    pub fn caster_state(&self) -> CasterState<'_> {
        self.state(self.settings.caster_key())
    }

    /// Returns the same instead of [`Self::clipping_caster_pipeline`].
    pub fn clipping_caster_state(&self) -> Option<CasterState<'_>> {
        let key = self.settings.caster_key();
        key.flattens.then(|| self.state(CasterKey { flattens: false, ..key }))
    }

    /// Returns the same instead of [`Self::second_caster_pipeline`]. Its fragment stage must be there, in a module behind
    /// [`second_caster_wgsl`](crate::second_caster_wgsl), and call `umbrage_caster_fragment`.
    pub fn second_caster_state(&self) -> Option<CasterState<'_>> {
        let layers = self.parts.layers.as_ref()?;
        Some(CasterState::new(self.settings.caster_key(), &layers.peel_layout, &layers.peel_group))
    }

    fn state(&self, key: CasterKey) -> CasterState<'_> {
        CasterState::new(key, &self.parts.caster_layout, &self.parts.buffers.caster_group)
    }
}
