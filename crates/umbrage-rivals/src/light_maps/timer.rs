//! How long a pass takes: by timestamps where the device has them, otherwise by the clock on the wall.

use umbrage_render::{Gpu, RenderError};
use web_time::Instant;

/// Times one pass after the other.
#[derive(Debug)]
pub(super) struct Timer {
    queries: Option<wgpu::QuerySet>,
    start: Instant,
}

/// A begin and an end, in ticks.
const BYTES: u64 = 16;

impl Timer {
    pub fn new(gpu: &Gpu) -> Self {
        let has_timestamps = gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY);
        let descriptor = wgpu::QuerySetDescriptor {
            label: Some("Timer::queries"),
            ty: wgpu::QueryType::Timestamp,
            count: 2,
        };
        let queries = has_timestamps.then(|| gpu.device.create_query_set(&descriptor));
        Self { queries, start: Instant::now() }
    }

    /// Begins to time; what it returns belongs into the pass.
    pub fn begin(&mut self) -> Option<wgpu::RenderPassTimestampWrites<'_>> {
        self.start = Instant::now();
        self.queries.as_ref().map(|query_set| wgpu::RenderPassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        })
    }

    /// Hands over what was recorded, waits for it, and returns the pass's milliseconds.
    pub fn submit(&self, gpu: &Gpu, mut encoder: wgpu::CommandEncoder) -> Result<f64, RenderError> {
        let buffer = |label, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: BYTES,
                usage,
                mapped_at_creation: false,
            })
        };
        let Some(queries) = &self.queries else {
            gpu.queue.submit([encoder.finish()]);
            gpu.wait()?;
            return Ok(self.start.elapsed().as_secs_f64() * 1e3);
        };
        let resolved =
            buffer("Timer::resolved", wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC);
        let read = buffer("Timer::read", wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ);
        encoder.resolve_query_set(queries, 0..2, &resolved, 0);
        encoder.copy_buffer_to_buffer(&resolved, 0, &read, 0, BYTES);
        gpu.queue.submit([encoder.finish()]);
        // Whether it was mapped is seen when its bytes are asked for.
        read.map_async(wgpu::MapMode::Read, .., |_| ());
        gpu.wait()?;
        let failed = |error: &dyn std::fmt::Display| RenderError::Device(error.to_string());
        let bytes = read.get_mapped_range(..).map_err(|error| failed(&error))?;
        let [begin, end] = bytemuck::pod_read_unaligned::<[u64; 2]>(&bytes);
        Ok(end.saturating_sub(begin) as f64 * f64::from(gpu.queue.get_timestamp_period()) * 1e-6)
    }
}
