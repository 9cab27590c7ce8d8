//! Views that are fitted to what the camera sees, between the upload of a plan and its casters.

use std::ops::Range;

use umbrage_core::{Camera, ShadowPlan};
use umbrage_wgsl::ReadChoices;

use super::Shadows;
use crate::coming::Coming;
use crate::error::{DeviceError, ShadowError};

/// The depth that a camera sees, before any shadow is drawn.
#[derive(Clone, Copy, Debug)]
pub struct SeenDepth<'a> {
    /// A `Depth32Float` texture of one sample a pixel, reversed and cleared to 0, of any size: with all surfaces that are to
    /// receive shadows.
    pub depth: &'a wgpu::TextureView,
    /// The camera that it was drawn for, in world space: the one that the plan was made for.
    pub camera: &'a Camera,
}

impl Shadows {
    /// Fits the views of suns to what a camera sees, under [`Fit::Sample`](umbrage_core::Fit::Sample): after [`Self::upload`] of a plan and before
    /// [`Self::cast`]. Other views stay as planned, and so do all views where this is not called.
    ///
    /// The rectangles that are chosen lie within those that are planned, so a host lists casters by its plan all the same. They grow at
    /// once and shrink late; [`Self::forget_looks`] says that what is seen has nothing to do with what was seen before. What the depth does not
    /// show, as glass, is looked up in coarser maps, and outside of all maps it is lit.
    ///
    /// Returns whether views were fitted: not under another fit, or where the device has no compute shaders.
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn look(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
        seen: SeenDepth<'_>,
    ) -> Result<bool, ShadowError> {
        self.look_timed((device, queue), encoder, plan, seen, None)
    }

    /// Looks as [`Self::look`] does, and writes timestamps where [`Self::looks`].
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn look_timed(
        &self,
        on: (&wgpu::Device, &wgpu::Queue),
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
        SeenDepth { depth, camera }: SeenDepth<'_>,
        timestamps: Option<wgpu::ComputePassTimestampWrites<'_>>,
    ) -> Result<bool, ShadowError> {
        self.check_plan(plan)?;
        let Some(samples) = &self.parts.samples else { return Ok(false) };
        samples.record(on, encoder, plan, (depth, camera), (self.origin, timestamps));
        Ok(true)
    }

    /// Whether [`Self::look`] has something to compute.
    pub fn looks(&self) -> bool {
        self.parts.samples.is_some()
    }

    /// Between which view depths [`Self::look`] saw something, metres, in steps of which eight double a depth; it comes a frame
    /// late or two, and the splits of the next plan are placed there. `None` where nothing has come yet.
    pub fn seen_depths(&self) -> Option<Range<f32>> {
        self.parts.samples.as_ref()?.depths()
    }

    /// Forgets what [`Self::look`] saw and chose in frames before, so that the next one chooses by what it sees alone.
    pub fn forget_looks(&self, queue: &wgpu::Queue) {
        if let Some(samples) = &self.parts.samples {
            samples.forget(queue);
        }
    }

    /// Forgets the rectangles that [`Self::look`] chose in frames before, and keeps [`Self::seen_depths`]: where splits were placed anew, so
    /// that no map waits until it shrinks.
    pub fn forget_rectangles(&self, queue: &wgpu::Queue) {
        if let Some(samples) = &self.parts.samples {
            samples.forget_choices(queue);
        }
    }

    /// Copies what [`Self::look`] chose for a plan to the CPU, waits for it, and gives the plan's views the rectangles that shaders see:
    /// for [`Lookup`](umbrage_core::Lookup), measurements and tests. A plan that was uploaded before is not to be uploaded again then.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn read_looks(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        plan: &mut ShadowPlan,
    ) -> Result<(), ShadowError> {
        let Some(samples) = &self.parts.samples else { return Ok(()) };
        let mut encoder = device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("Shadows::read_looks") });
        let coming = Coming::of(device, &mut encoder, &samples.choices);
        queue.submit([encoder.finish()]);
        device
            .poll(wgpu::PollType::wait_indefinitely())
            .map_err(|error| ShadowError::ReadBack(DeviceError::new(error)))?;
        let Some(choices) = coming.take().and_then(|bytes| ReadChoices::of(&bytes)) else { return Ok(()) };
        for view in 0..plan.views().len() {
            if let Some(chosen) = choices.rectangle(&plan.views()[view], self.origin) {
                plan.set_rectangle(view, &chosen);
            }
        }
        Ok(())
    }
}
