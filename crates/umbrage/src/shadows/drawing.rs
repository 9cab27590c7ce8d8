//! From an uploaded plan to maps that are drawn.

use umbrage_core::{ShadowPlan, ShadowView};

use super::Shadows;
use crate::casting::{Casting, Destination};
use crate::error::ShadowError;
use crate::frame::offset;
use crate::kept::{Share, Step, Target};
use crate::maps::Maps;

impl Shadows {
    /// Begins to draw the views of the plan that was uploaded last, in one render pass where their tiles lie in one layer, and in one
    /// a view otherwise. Views whose tiles show what they are to show are left out: see [`Self::has_due_views`]. With a
    /// `bias.depth_layer` other than the first, [`Self::cast_second`] follows.
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn cast<'a>(
        &'a self,
        encoder: &'a mut wgpu::CommandEncoder,
        plan: &'a ShadowPlan,
    ) -> Result<Casting<'a>, ShadowError> {
        self.cast_timed(encoder, plan, None)
    }

    /// Casts as [`Self::cast`] does, and writes timestamps as the first pass begins and as the last one ends.
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn cast_timed<'a>(
        &'a self,
        encoder: &'a mut wgpu::CommandEncoder,
        plan: &'a ShadowPlan,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'a>>,
    ) -> Result<Casting<'a>, ShadowError> {
        self.check_plan(plan)?;
        let parts = &self.parts;
        let to = Destination {
            maps: self.drawn(),
            still: parts.still.as_ref(),
            group: &parts.buffers.caster_group,
            kept: Some(&parts.kept),
        };
        Ok(self.casting(encoder, to, plan, timestamps))
    }

    /// Begins to draw all views of a plan once more where `bias.depth_layer` asks for a second surface, with the pipeline of
    /// [`Self::second_caster_pipeline`], after [`Self::cast`]. `None` where it does not.
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn cast_second<'a>(
        &'a self,
        encoder: &'a mut wgpu::CommandEncoder,
        plan: &'a ShadowPlan,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'a>>,
    ) -> Result<Option<Casting<'a>>, ShadowError> {
        self.check_plan(plan)?;
        let Some(layers) = &self.parts.layers else { return Ok(None) };
        let to = Destination { maps: &layers.second, still: None, group: &layers.peel_group, kept: None };
        Ok(Some(self.casting(encoder, to, plan, timestamps)))
    }

    /// Begins a pass that draws one view's casters: its tile is empty, viewport, scissor and group 0 are set. Views may be drawn in
    /// any order, and those that are not drawn keep what they show. With a `bias.depth_layer` other than the first, draw each view
    /// once more: see [`Self::begin_second`].
    ///
    /// # Errors
    /// When the view lies outside of these maps, as one of a plan that was made for others may.
    pub fn begin<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> Result<wgpu::RenderPass<'e>, ShadowError> {
        self.check_view(view)?;
        let mut pass = self.drawn().begin(encoder, view, timestamps);
        let step = Step { view: view.index, target: Target::Maps, share: Some(Share::All), restores: false };
        self.parts.kept.lock().record(&step, view, None);
        pass.set_bind_group(0, &self.parts.buffers.caster_group, &[offset(view)]);
        Ok(pass)
    }

    /// Begins the pass that draws one view's casters once more where `bias.depth_layer` asks for a second surface, with the pipeline
    /// of [`Self::second_caster_pipeline`], after the view's first pass. `None` where it does not.
    ///
    /// # Errors
    /// As [`Self::begin`].
    pub fn begin_second<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        view: &ShadowView,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> Result<Option<wgpu::RenderPass<'e>>, ShadowError> {
        self.check_view(view)?;
        let Some(layers) = &self.parts.layers else { return Ok(None) };
        let mut pass = layers.second.begin(encoder, view, timestamps);
        pass.set_bind_group(0, &layers.peel_group, &[offset(view)]);
        Ok(Some(pass))
    }

    /// Makes of the casters that were drawn what lookups read: the surface between two layers, moments, sums. Call it
    /// after the last view; for filters that read depths it does nothing, nor for views that were not drawn.
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn finish(&self, encoder: &mut wgpu::CommandEncoder, plan: &ShadowPlan) -> Result<(), ShadowError> {
        self.finish_timed(encoder, plan, None)
    }

    /// Finishes as [`Self::finish`] does, and writes timestamps where [`Self::has_filter_pass`].
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn finish_timed(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
        timestamp_writes: Option<wgpu::ComputePassTimestampWrites<'_>>,
    ) -> Result<(), ShadowError> {
        self.check_plan(plan)?;
        let mut kept = self.parts.kept.lock();
        let views = plan.views().iter().filter(|view| kept.is_drawn(view));
        if let Some(layers) = &self.parts.layers {
            layers.join(encoder, &self.parts.maps, views.clone());
        }
        if let Some(filtered) = &self.parts.filtered {
            let label = Some("Shadows::filter_pass");
            let descriptor = wgpu::ComputePassDescriptor { label, timestamp_writes };
            filtered.record(&mut encoder.begin_compute_pass(&descriptor), views);
        }
        kept.forget_drawn();
        Ok(())
    }

    /// Whether [`Self::finish`] has something to compute.
    pub fn has_filter_pass(&self) -> bool {
        self.parts.filtered.is_some()
    }

    fn casting<'a>(
        &'a self,
        encoder: &'a mut wgpu::CommandEncoder,
        to: Destination<'a>,
        plan: &'a ShadowPlan,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'a>>,
    ) -> Casting<'a> {
        let (views, steps) = (plan.views(), self.steps.as_slice());
        Casting { encoder, to, views, steps, timestamps, pass: None, has_begun: false }
    }

    /// The maps that casters are drawn into first.
    fn drawn(&self) -> &Maps {
        self.parts.layers.as_ref().map_or(&self.parts.maps, |layers| &layers.first)
    }
}
