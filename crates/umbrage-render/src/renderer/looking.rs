//! Maps that are fitted to what the camera sees: its depth is drawn before the casters, and asked for on the device.

use umbrage::SeenDepth;

use super::Renderer;
use crate::drawn::{Drawn, Planned};
use crate::error::RenderError;
use crate::frame::Frame;
use crate::shading::Inputs;
use crate::target::Target;
use crate::timing::CASTERS;

impl Renderer {
    /// Forgets what was seen in frames before: under [`Fit::Sample`](umbrage::Fit::Sample) the next frame is drawn as the first.
    pub fn forget_looks(&self) {
        self.shadows.forget_looks(&self.gpu.queue);
    }

    /// Waits until it is known between which depths something is seen, where that decides how a first frame is planned.
    pub(super) fn settle(&mut self, frame: &Frame, target: &Target) -> Result<(), RenderError> {
        if self.shadows.looks() && self.shadows.seen_depths().is_none() {
            let planned = self.plan(frame)?;
            self.look(frame, &planned, target)?;
            self.gpu.wait()?;
            if self.shadows.seen_depths().is_some() {
                self.shadows.forget_rectangles(&self.gpu.queue);
            }
        }
        Ok(())
    }

    /// Reads what was chosen for the maps of a frame that was waited for.
    pub(super) fn read_looks(&self, drawn: &Drawn) -> Result<(), RenderError> {
        let planned = &drawn.planned;
        if self.shadows.looks() && planned.plan.views().iter().any(|view| view.samples.is_some()) {
            let mut plan = planned.plan.clone();
            self.shadows.read_looks(&self.gpu.device, &self.gpu.queue, &mut plan)?;
            planned.chosen.get_or_init(|| plan);
        }
        Ok(())
    }

    /// Fits shadow views to what is seen, where the fit asks for that. What is planned for another camera stays as it is.
    pub(super) fn look(
        &mut self,
        frame: &Frame,
        planned: &Planned,
        target: &Target,
    ) -> Result<bool, RenderError> {
        let has_views = planned.plan.views().iter().any(|view| view.samples.is_some());
        if !self.shadows.looks() || !has_views || frame.planned_for.is_some() {
            return Ok(false);
        }
        let Self { gpu, scene, shadows, shading, timer, .. } = self;
        let mut encoder = gpu.encoder("Renderer::look");
        let inputs = Inputs { gpu, scene, shadows };
        let depth = shading.see(inputs, &mut encoder, timer, planned, &frame.show, target)?;
        let seen = SeenDepth { depth: &depth, camera: &planned.camera };
        let on = (&gpu.device, &gpu.queue);
        timer.compute_pass(CASTERS, &mut encoder, |encoder, timestamps| {
            shadows.look_timed(on, encoder, &planned.plan, seen, timestamps)
        })?;
        gpu.queue.submit([encoder.finish()]);
        Ok(true)
    }
}
