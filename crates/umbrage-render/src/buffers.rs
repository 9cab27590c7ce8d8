//! Buffers with something in them: of a fixed size, or growing.

use crate::error::RenderError;
use crate::gpu::Gpu;

/// The binding type of a whole buffer.
pub(crate) fn binding(ty: wgpu::BufferBindingType) -> wgpu::BindingType {
    wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None }
}

/// The binding type of a buffer that shaders only read.
pub(crate) const READ: wgpu::BufferBindingType = wgpu::BufferBindingType::Storage { read_only: true };

/// The binding type of a buffer that shaders write.
pub(crate) const WRITE: wgpu::BufferBindingType = wgpu::BufferBindingType::Storage { read_only: false };

/// A buffer with something in it; never of no size, which cannot be bound.
pub(crate) fn filled(
    gpu: &Gpu,
    what: &'static str,
    bytes: &[u8],
    usage: wgpu::BufferUsages,
) -> Result<wgpu::Buffer, RenderError> {
    let buffer = sized(gpu, what, bytes.len() as u64, usage)?;
    gpu.queue.write_buffer(&buffer, 0, bytes);
    Ok(buffer)
}

/// A buffer of a size, 16 bytes at least, within the device's limits.
fn sized(
    gpu: &Gpu,
    what: &'static str,
    bytes: u64,
    usage: wgpu::BufferUsages,
) -> Result<wgpu::Buffer, RenderError> {
    let (size, most) = (bytes.max(16), limit(gpu, usage));
    if size > most {
        return Err(RenderError::TooLarge { what, bytes: size, most });
    }
    Ok(gpu.buffer(&wgpu::BufferDescriptor {
        label: Some(what),
        size,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    }))
}

fn limit(gpu: &Gpu, usage: wgpu::BufferUsages) -> u64 {
    let limits = gpu.device.limits();
    // Vertices that shaders write are bound in part only.
    if usage.contains(wgpu::BufferUsages::STORAGE) && !usage.contains(wgpu::BufferUsages::VERTEX) {
        limits.max_storage_buffer_binding_size.min(limits.max_buffer_size)
    } else {
        limits.max_buffer_size
    }
}

/// A buffer that grows to the largest that was written into it, and is kept.
#[derive(Debug)]
pub(crate) struct Growing {
    what: &'static str,
    usage: wgpu::BufferUsages,
    pub buffer: wgpu::Buffer,
}

impl Growing {
    pub fn new(gpu: &Gpu, what: &'static str, usage: wgpu::BufferUsages) -> Result<Self, RenderError> {
        Ok(Self { what, usage, buffer: sized(gpu, what, 0, usage)? })
    }

    /// Writes bytes at the start. Whether the buffer is another one now, and bind groups must be made anew.
    pub fn write(&mut self, gpu: &Gpu, bytes: &[u8]) -> Result<bool, RenderError> {
        let wanted = bytes.len() as u64;
        let grows = self.buffer.size() < wanted;
        if grows {
            // Twice as much as before, so that a world that grows bit by bit makes few buffers.
            let size = wanted.max((2 * self.buffer.size()).min(limit(gpu, self.usage)));
            self.buffer = sized(gpu, self.what, size, self.usage)?;
        }
        gpu.queue.write_buffer(&self.buffer, 0, bytes);
        Ok(grows)
    }
}
