//! How far the CPU may run ahead of the device: frames that were handed over and are not known to be done.

use std::collections::VecDeque;

use crate::error::RenderError;
use crate::gpu::Gpu;

/// Frames in flight, at most so many at once, as a window has them: the CPU plans one while the device draws another.
#[derive(Debug)]
pub struct InFlight {
    gpu: Gpu,
    most: usize,
    handed_over: VecDeque<wgpu::SubmissionIndex>,
}

impl InFlight {
    /// Allows `most` frames in flight, 1 or more. A window has 2.
    pub fn new(gpu: &Gpu, most: usize) -> Self {
        Self { gpu: gpu.clone(), most: most.max(1), handed_over: VecDeque::new() }
    }

    /// Notes that [`Renderer::draw`](crate::Renderer::draw) handed a frame over, and waits until no more are in flight than
    /// may be, less the one that comes next.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn handed_over(&mut self) -> Result<(), RenderError> {
        // Nothing more is handed over: this asks for the number of what was.
        self.handed_over.push_back(self.gpu.queue.submit([]));
        while self.handed_over.len() >= self.most {
            self.wait_for_oldest()?;
        }
        Ok(())
    }

    /// Waits until none is in flight.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn finish(&mut self) -> Result<(), RenderError> {
        while !self.handed_over.is_empty() {
            self.wait_for_oldest()?;
        }
        Ok(())
    }

    /// Returns how many frames are in flight.
    pub fn count(&self) -> usize {
        self.handed_over.len()
    }

    fn wait_for_oldest(&mut self) -> Result<(), RenderError> {
        let Some(oldest) = self.handed_over.pop_front() else { return Ok(()) };
        let wait = wgpu::PollType::Wait { submission_index: Some(oldest), timeout: None };
        self.gpu.device.poll(wait).map(drop).map_err(|e| RenderError::Device(e.to_string()))
    }
}
