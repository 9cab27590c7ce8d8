//! How long the passes between two points of a submission take, by the device's clock.

use umbrage_render::{Gpu, RenderError};

/// Two timestamps; none where the device has none.
#[derive(Debug)]
pub(crate) struct Stopwatch {
    queries: Option<wgpu::QuerySet>,
}

/// The bytes of two timestamps.
const BYTES: u64 = 16;

impl Stopwatch {
    pub fn new(gpu: &Gpu) -> Self {
        let has_timestamps = gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY);
        let make = || {
            gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("Stopwatch::queries"),
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            })
        };
        Self { queries: has_timestamps.then(make) }
    }

    /// For the first compute pass.
    pub fn starts(&self) -> Option<wgpu::ComputePassTimestampWrites<'_>> {
        self.queries.as_ref().map(|query_set| wgpu::ComputePassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: None,
        })
    }

    /// For a first render pass.
    pub fn starts_drawing(&self) -> Option<wgpu::RenderPassTimestampWrites<'_>> {
        self.queries.as_ref().map(|query_set| wgpu::RenderPassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: None,
        })
    }

    /// For the last render pass.
    pub fn stops(&self) -> Option<wgpu::RenderPassTimestampWrites<'_>> {
        self.queries.as_ref().map(|query_set| wgpu::RenderPassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: None,
            end_of_pass_write_index: Some(1),
        })
    }

    /// For a render pass that is all that is timed.
    pub fn times_drawing(&self) -> Option<wgpu::RenderPassTimestampWrites<'_>> {
        self.queries.as_ref().map(|query_set| wgpu::RenderPassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        })
    }

    /// A buffer that will hold the two timestamps of what was recorded before.
    pub fn resolve(&self, gpu: &Gpu, encoder: &mut wgpu::CommandEncoder) -> Option<wgpu::Buffer> {
        let queries = self.queries.as_ref()?;
        let buffer = |usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("Stopwatch::buffer"),
                size: BYTES,
                usage,
                mapped_at_creation: false,
            })
        };
        let resolved = buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC);
        let copy = buffer(wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
        encoder.resolve_query_set(queries, 0..2, &resolved, 0);
        encoder.copy_buffer_to_buffer(&resolved, 0, &copy, 0, BYTES);
        Some(copy)
    }

    /// Milliseconds between two timestamps, waited for.
    pub fn read(gpu: &Gpu, buffer: wgpu::Buffer) -> Result<f64, RenderError> {
        let period = f64::from(gpu.queue.get_timestamp_period());
        gpu.read_mapped(buffer, |bytes| {
            let mut ticks = bytes.as_chunks().0.iter().map(|eight| u64::from_ne_bytes(*eight));
            let (start, stop) = (ticks.next().unwrap_or_default(), ticks.next().unwrap_or_default());
            stop.saturating_sub(start) as f64 * period * 1e-6
        })
    }
}
