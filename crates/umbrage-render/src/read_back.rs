//! Bytes of a buffer on their way to the CPU: waited for, or polled until they are there.

use crate::error::RenderError;
use crate::gpu::Gpu;

impl Gpu {
    /// Copies the first `count` numbers of a buffer to the CPU, and waits for them.
    ///
    /// # Errors
    /// When the device fails.
    pub(crate) fn read_floats(&self, buffer: &wgpu::Buffer, count: usize) -> Result<Vec<f32>, RenderError> {
        self.read_floats_from(buffer, 0, count)
    }

    /// Copies `count` numbers of a buffer, from number `first` on, to the CPU, and waits for them.
    ///
    /// # Errors
    /// When the device fails.
    pub(crate) fn read_floats_from(
        &self,
        buffer: &wgpu::Buffer,
        first: u64,
        count: usize,
    ) -> Result<Vec<f32>, RenderError> {
        let words = self.read_words_from(buffer, first, count)?;
        Ok(words.into_iter().map(f32::from_bits).collect())
    }

    /// Copies the first `count` words of a buffer to the CPU, and waits for them.
    ///
    /// # Errors
    /// When the device fails.
    pub(crate) fn read_words(&self, buffer: &wgpu::Buffer, count: usize) -> Result<Vec<u32>, RenderError> {
        self.read_words_from(buffer, 0, count)
    }

    fn read_words_from(
        &self,
        buffer: &wgpu::Buffer,
        first: u64,
        count: usize,
    ) -> Result<Vec<u32>, RenderError> {
        let size = 4 * count as u64;
        let copy = self.buffer(&wgpu::BufferDescriptor {
            label: Some("Gpu::read_words"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.encoder("Gpu::read_words");
        encoder.copy_buffer_to_buffer(buffer, 4 * first, &copy, 0, size);
        self.queue.submit([encoder.finish()]);
        self.read_mapped(copy, |bytes| {
            bytes.as_chunks().0.iter().map(|four| u32::from_ne_bytes(*four)).collect()
        })
    }

    /// Returns what `read` makes of the bytes of a buffer that can be mapped, once everything handed over is done.
    ///
    /// # Errors
    /// When the device fails.
    pub fn read_mapped<T>(
        &self,
        buffer: wgpu::Buffer,
        read: impl FnOnce(&[u8]) -> T,
    ) -> Result<T, RenderError> {
        let coming = Coming::new(buffer);
        self.wait()?;
        coming.take(read).unwrap_or_else(|| Err(RenderError::Device("a buffer was not mapped".to_owned())))
    }
}

/// The bytes of a buffer on their way to the CPU.
#[derive(Debug)]
pub(crate) struct Coming {
    buffer: wgpu::Buffer,
    mapped: std::sync::mpsc::Receiver<Result<(), wgpu::BufferAsyncError>>,
}

impl Coming {
    /// Starts to map the buffer: the bytes come when everything that was handed over before is done.
    pub fn new(buffer: wgpu::Buffer) -> Self {
        let (sender, mapped) = std::sync::mpsc::channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // The receiver may be gone.
            let _ = sender.send(result);
        });
        Self { buffer, mapped }
    }

    /// What `read` makes of them; `None` where they have not come yet.
    pub fn take<T>(&self, read: impl FnOnce(&[u8]) -> T) -> Option<Result<T, RenderError>> {
        let failed = |error: &dyn std::fmt::Display| RenderError::Device(error.to_string());
        match self.mapped.try_recv() {
            Err(std::sync::mpsc::TryRecvError::Empty) => None,
            Err(error) => Some(Err(failed(&error))),
            Ok(Err(error)) => Some(Err(failed(&error))),
            Ok(Ok(())) => Some(self.buffer.get_mapped_range(..).map(|b| read(&b)).map_err(|e| failed(&e))),
        }
    }
}
