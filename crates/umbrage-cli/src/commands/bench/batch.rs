//! How a batch of frames is timed: as a window draws them, and then pass by pass.
//!
//! A window hands frames over and does not wait for them, so that the CPU plans one while the device draws another; what
//! a frame costs is then the time between two that are done, and only the mean over some of them is steady. Timestamps keep
//! passes from overlapping, on a software device more than on others, so they are off meanwhile. A second time
//! the same frames are drawn with timestamps, each waited for.

use std::time::Instant;

use umbrage_render::{Drawn, Frame, FrameTimes, Gpu, InFlight, RenderError, Renderer, Show, ViewLoad};

/// As many frames as a window has in flight.
const IN_FLIGHT: usize = 2;

/// In which way frames are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// As the settings say.
    Shadowed,
    /// Without shadows.
    Unshadowed,
    /// With every part of the world drawn into every map.
    Unculled,
    /// With every map drawn anew.
    Forgetful,
}

/// What frames of one way took.
#[derive(Debug, Default)]
pub struct Timed {
    /// Every frame: the time from when the frame before was done, and the times of its passes.
    pub frames: Vec<FrameTimes>,
    /// The mean time of a frame in each batch, milliseconds.
    pub batches: Vec<f64>,
    /// What was drawn into the views of the last frame.
    pub loads: Vec<ViewLoad>,
}

/// What frames are drawn with.
pub struct Bench<'a> {
    pub renderer: &'a mut Renderer,
    pub gpu: &'a Gpu,
    /// Whether maps are kept that show already what they should.
    pub keeps: bool,
}

impl Timed {
    /// Draws a batch of frames twice, and adds what they took. `before` is drawn first and not counted, so that the device
    /// is at work when the first of them begins, and keeps what it would keep.
    pub fn add(
        &mut self,
        mut bench: Bench<'_>,
        way: Way,
        before: &Frame,
        batch: &[Frame],
    ) -> Result<(), RenderError> {
        let [before, batch] = [std::slice::from_ref(before), batch].map(|frames| way.frames(frames));
        bench.renderer.cull_parts = way != Way::Unculled;
        bench.renderer.keep_tiles = bench.keeps && way != Way::Forgetful;
        let between = bench.pipelined(&before[0], &batch)?;
        bench.renderer.render(&before[0])?;
        for (frame, between) in batch.iter().zip(&between) {
            let rendered = bench.renderer.render(frame)?;
            self.loads = rendered.drawn.loads().to_vec();
            self.frames.push(FrameTimes { frame: *between, ..rendered.times });
        }
        self.batches.push(between.iter().sum::<f64>() / between.len() as f64);
        (bench.renderer.cull_parts, bench.renderer.keep_tiles) = (true, true);
        Ok(())
    }
}

impl Bench<'_> {
    /// The time from when the frame before was done until each frame was, milliseconds.
    fn pipelined(&mut self, before: &Frame, batch: &[Frame]) -> Result<Vec<f64>, RenderError> {
        self.renderer.set_pass_times(false);
        let mut in_flight = InFlight::new(self.gpu, IN_FLIGHT);
        let mut draw = |frame: &Frame| -> Result<Instant, RenderError> {
            // A window shows each picture, and then gives it up.
            let _: Drawn = self.renderer.draw(frame)?;
            in_flight.handed_over()?;
            Ok(Instant::now())
        };
        draw(before)?;
        // Each is handed over while the one before is drawn, and that is done when the call returns.
        let mut done = batch.iter().map(&mut draw).collect::<Result<Vec<_>, _>>()?;
        in_flight.finish()?;
        done.push(Instant::now());
        self.renderer.set_pass_times(true);
        Ok(done.windows(2).map(|pair| (pair[1] - pair[0]).as_secs_f64() * 1e3).collect())
    }
}

impl Way {
    fn frames(self, frames: &[Frame]) -> Vec<Frame> {
        let shown = |frame: &Frame| match self {
            Self::Shadowed | Self::Unculled | Self::Forgetful => frame.clone(),
            Self::Unshadowed => Frame { show: Show::Unshadowed, ..frame.clone() },
        };
        frames.iter().map(shown).collect()
    }
}
