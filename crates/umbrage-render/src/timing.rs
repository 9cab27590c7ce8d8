//! How long a frame's stages take: on the device where it has timestamps, by the wall clock otherwise.

use wgpu_profiler::{GpuProfiler, GpuProfilerSettings, GpuTimerQueryResult};

use crate::error::RenderError;
use crate::gpu::Gpu;

/// Says how long one frame's stages took, milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameTimes {
    /// The time of planning, culling and upload, on the CPU.
    pub plan: f64,
    /// The time of bending meshes by joints and morph targets, once for all views, and of making what rays go through fit them. It
    /// is 0 where nothing is bent, or nothing is bent otherwise than before; without timestamps part of `casters`.
    pub deform: f64,
    /// The time of all caster passes.
    pub casters: f64,
    /// The time of making moments, blurs and sums of the maps. It is 0 for filters that read depths; without timestamps
    /// part of `casters`.
    pub filter: f64,
    /// The time of the shading pass, and of the camera's depth before it where contact shadows need that.
    pub shade: f64,
    /// The time from the start of planning to the end of shading, by the wall clock.
    pub frame: f64,
}

impl std::ops::AddAssign for FrameTimes {
    fn add_assign(&mut self, other: Self) {
        let Self { plan, deform, casters, filter, shade, frame } = other;
        self.plan += plan;
        self.deform += deform;
        self.casters += casters;
        self.filter += filter;
        self.shade += shade;
        self.frame += frame;
    }
}

/// Says what was drawn into one shadow view: nothing where its tile showed that already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ViewLoad {
    /// The light whose view it is, counted from 0.
    pub light: usize,
    /// The split, or the face of a cube, counted from 0.
    pub split: usize,
    /// The number of draw calls.
    pub draws: usize,
    /// The number of triangles, all instances together.
    pub triangles: u64,
}

/// Labels that tell the passes of a frame apart.
pub(crate) const DEFORM: &str = "deform";
pub(crate) const CASTERS: &str = "casters";
pub(crate) const FILTER: &str = "filter";
pub(crate) const SHADE: &str = "shade";

/// Times passes by timestamps, where the device has them.
pub(crate) struct PassTimer {
    profiler: Option<GpuProfiler>,
    /// Whether it does so; otherwise passes run as if the device had no timestamps.
    on: bool,
}

impl std::fmt::Debug for PassTimer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PassTimer").field("timestamps", &self.profiler.is_some()).finish()
    }
}

impl PassTimer {
    pub fn new(gpu: &Gpu) -> Result<Self, RenderError> {
        let has_timestamps = gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY);
        let settings = GpuProfilerSettings::default();
        let profiler = has_timestamps.then(|| GpuProfiler::new(&gpu.device, settings)).transpose();
        Ok(Self { profiler: profiler.map_err(|e| RenderError::Device(e.to_string()))?, on: true })
    }

    /// Times passes from the next frame on, or no more.
    pub fn switch(&mut self, on: bool) {
        self.on = on;
    }

    /// Whether passes are timed.
    pub fn is_running(&self) -> bool {
        self.running().is_some()
    }

    /// What times passes now.
    fn running(&self) -> Option<&GpuProfiler> {
        self.profiler.as_ref().filter(|_| self.on)
    }

    /// Runs `record` with the timestamps of a pass labelled `label`, if there are any.
    pub fn pass<R>(
        &self,
        label: &str,
        encoder: &mut wgpu::CommandEncoder,
        record: impl FnOnce(&mut wgpu::CommandEncoder, Option<wgpu::RenderPassTimestampWrites<'_>>) -> R,
    ) -> R {
        match self.running() {
            None => record(encoder, None),
            Some(profiler) => {
                let query = profiler.begin_pass_query(label, encoder);
                let recorded = record(encoder, query.render_pass_timestamp_writes());
                profiler.end_query(encoder, query);
                recorded
            }
        }
    }

    /// The same for a compute pass.
    pub fn compute_pass<R>(
        &self,
        label: &str,
        encoder: &mut wgpu::CommandEncoder,
        record: impl FnOnce(&mut wgpu::CommandEncoder, Option<wgpu::ComputePassTimestampWrites<'_>>) -> R,
    ) -> R {
        match self.running() {
            None => record(encoder, None),
            Some(profiler) => {
                let query = profiler.begin_pass_query(label, encoder);
                let recorded = record(encoder, query.compute_pass_timestamp_writes());
                profiler.end_query(encoder, query);
                recorded
            }
        }
    }

    /// Ends a frame's queries: call it last, before the encoder is handed over.
    pub fn resolve(&mut self, encoder: &mut wgpu::CommandEncoder) {
        if let Some(profiler) = self.profiler.as_mut().filter(|_| self.on) {
            profiler.resolve_queries(encoder);
        }
    }

    /// The frame was handed over.
    pub fn end_frame(&mut self) -> Result<(), RenderError> {
        let Some(profiler) = self.profiler.as_mut().filter(|_| self.on) else { return Ok(()) };
        profiler.end_frame().map_err(|e| RenderError::Device(e.to_string()))
    }

    /// Milliseconds of all passes labelled `DEFORM`, `CASTERS`, `FILTER` and `SHADE`, of each together, of the oldest frame that is done and was not taken yet. `None` where there is none, or the device has no timestamps.
    pub fn take(&mut self, gpu: &Gpu) -> Option<[f64; 4]> {
        let period = gpu.queue.get_timestamp_period();
        let profiler = self.profiler.as_mut().filter(|_| self.on)?;
        let results = profiler.process_finished_frame(period)?;
        let total = |label: &str| -> f64 {
            let spans = results.iter().filter(|result| result.label == label);
            // A sum of nothing is -0.
            0.0 + spans.filter_map(milliseconds).sum::<f64>()
        };
        Some([DEFORM, CASTERS, FILTER, SHADE].map(total))
    }
}

fn milliseconds(result: &GpuTimerQueryResult) -> Option<f64> {
    result.time.as_ref().map(|time| (time.end - time.start) * 1e3)
}
