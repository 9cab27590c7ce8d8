//! What a host needs for pipelines that draw casters: made for it, or to agree with.

use umbrage_core::CasterKey;
use umbrage_wgsl::{caster_bindings, peel_bindings};

use super::Shadows;
use crate::caster_pipeline::CasterPipeline;
use crate::caster_state::{Bound, CasterState};

impl Shadows {
    /// Makes a depth-only pipeline for the host's vertices and fragments, with the settings' raster bias and faces.
    pub fn caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> wgpu::RenderPipeline {
        self.cached_by(pipeline).make(device, self.caster_state())
    }

    /// Makes the same for views whose [`ShadowView::unclipped_depth`](umbrage_core::ShadowView::unclipped_depth) is off, where
    /// [`Self::caster_pipeline`] flattens casters onto the near plane: it clips them there. Only a lamp within a bulb needs it
    /// ([`Light::with_near`](umbrage_core::Light::with_near)); `None` where the other one clips already.
    pub fn clipping_caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> Option<wgpu::RenderPipeline> {
        Some(self.cached_by(pipeline).make(device, self.clipping_caster_state()?))
    }

    /// Makes the same for [`Self::cast_second`] and [`Self::begin_second`]; `None` where there is no second surface. A fragment
    /// stage stands in a module behind [`second_caster_wgsl`](crate::second_caster_wgsl) here; without one, nothing changes.
    pub fn second_caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> Option<wgpu::RenderPipeline> {
        Some(self.cached_by(pipeline).make_second(device, self.second_caster_state()?))
    }

    /// Makes the same for [`Self::cast_second`] and [`Self::begin_second`] on views where [`Self::clipping_caster_pipeline`] draws the
    /// first surface: what is clipped otherwise than before has other depths, by which the first would not be left out.
    pub fn clipping_second_caster_pipeline(
        &self,
        device: &wgpu::Device,
        pipeline: &CasterPipeline<'_>,
    ) -> Option<wgpu::RenderPipeline> {
        Some(self.cached_by(pipeline).make_second(device, self.clipping_second_caster_state()?))
    }

    /// Returns what a pipeline agrees with that the host builds itself, instead of [`Self::caster_pipeline`].
    pub fn caster_state(&self) -> CasterState<'_> {
        self.first(self.settings.caster_key())
    }

    /// Returns the same instead of [`Self::clipping_caster_pipeline`].
    pub fn clipping_caster_state(&self) -> Option<CasterState<'_>> {
        self.clipping_key().map(|key| self.first(key))
    }

    /// Returns the same instead of [`Self::second_caster_pipeline`]. Its fragment stage must be there, in a module behind
    /// [`second_caster_wgsl`](crate::second_caster_wgsl), and call `umbrage_caster_fragment`.
    pub fn second_caster_state(&self) -> Option<CasterState<'_>> {
        self.second(self.settings.caster_key())
    }

    /// Returns the same instead of [`Self::clipping_second_caster_pipeline`].
    pub fn clipping_second_caster_state(&self) -> Option<CasterState<'_>> {
        self.clipping_key().and_then(|key| self.second(key))
    }

    /// A pipeline that is looked up in its own cache, or else in that of these shadows.
    fn cached_by<'a>(&'a self, pipeline: &CasterPipeline<'a>) -> CasterPipeline<'a> {
        CasterPipeline { cache: pipeline.cache.or(self.cache.as_ref()), ..pipeline.clone() }
    }

    /// The key of pipelines that clip what the others flatten.
    fn clipping_key(&self) -> Option<CasterKey> {
        let key = self.settings.caster_key();
        key.flattens.then_some(CasterKey { flattens: false, ..key })
    }

    fn first(&self, key: CasterKey) -> CasterState<'_> {
        let buffers = &self.parts.buffers;
        let bound = Bound { bindings: caster_bindings(), resources: buffers.bound().into() };
        CasterState::new(key, (&self.parts.caster_layout, &buffers.caster_group), bound)
    }

    fn second(&self, key: CasterKey) -> Option<CasterState<'_>> {
        let layers = self.parts.layers.as_ref()?;
        let first = wgpu::BindingResource::TextureView(&layers.first.all);
        let resources = self.parts.buffers.bound().into_iter().chain([first]).collect();
        let bound = Bound { bindings: peel_bindings(), resources };
        Some(CasterState::new(key, (&layers.peel_layout, &layers.peel_group), bound))
    }
}
