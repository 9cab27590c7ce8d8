//! Lights of some size, drawn as many frames with a light of none.

use std::sync::Arc;

use web_time::Instant;

use super::Renderer;
use crate::area::Area;
use crate::error::RenderError;
use crate::frame::{Frame, Show};
use crate::light::FrameLight;
use crate::passes::area_sum::AreaSum;
use crate::timing::FrameTimes;

/// A light of some size, drawn.
#[derive(Clone, Debug)]
pub struct AreaRendered {
    /// The visibility of every pixel, 0 to 1; the sky is lit.
    pub visibility: Vec<f32>,
    /// How long all samples took together.
    pub times: FrameTimes,
}

impl Renderer {
    /// Draws the visibility of one of a frame's lights as if it had some size. The frame says from where, when and how
    /// large; what it shows does not matter.
    ///
    /// # Errors
    /// When there is no such light or area, and as [`Self::render`].
    pub fn area(&mut self, frame: &Frame, light: usize, area: Area) -> Result<AreaRendered, RenderError> {
        area.validate()?;
        let lights = frame.lights.len();
        let light = *frame.lights.get(light).ok_or(RenderError::NoSuchLight { light, lights })?;
        let start = Instant::now();
        let (mut sum, mut times) = (None, FrameTimes::default());
        for sample in 0..area.samples {
            let moved = Frame {
                lights: vec![FrameLight { light: area.moved(&light.light, sample)?, ..light }],
                show: Show::Visibility(0),
                camera: frame.camera,
                planned_for: None,
                pose: Arc::clone(&frame.pose),
                ..*frame
            };
            let rendered = self.render(&moved)?;
            times += rendered.times;
            let sum = match &sum {
                Some(sum) => sum,
                None => sum.insert(AreaSum::new(&self.gpu, [frame.width, frame.height])?),
            };
            let mut encoder = self.gpu.encoder("Renderer::area");
            sum.record(&self.gpu, &mut encoder, &rendered.drawn.target.resolved_view);
            self.gpu.queue.submit([encoder.finish()]);
        }
        let mut visibility = match sum {
            Some(sum) => sum.read(&self.gpu)?,
            None => Vec::new(),
        };
        visibility.iter_mut().for_each(|sum| *sum /= area.samples as f32);
        times.frame = start.elapsed().as_secs_f64() * 1e3;
        Ok(AreaRendered { visibility, times })
    }
}
