//! Bytes of a buffer on their way to the CPU, which nobody waits for.

use std::cell::Cell;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

use crate::error::DeviceError;

/// A copy of a buffer that comes when the commands are done that it was recorded among.
#[derive(Debug)]
pub(crate) struct Coming {
    copy: wgpu::Buffer,
    mapped: Receiver<Result<(), wgpu::BufferAsyncError>>,
    /// Whether it was read, or the failure told: either happens once.
    is_told: Cell<bool>,
}

impl Coming {
    /// Records a copy of a whole buffer.
    pub fn of(device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, buffer: &wgpu::Buffer) -> Self {
        let size = buffer.size();
        Self::copied(device, encoder, size, |encoder, copy| {
            encoder.copy_buffer_to_buffer(buffer, 0, copy, 0, size);
        })
    }

    /// Records what `record` copies into a buffer of so many bytes.
    pub fn copied(
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        size: u64,
        record: impl FnOnce(&mut wgpu::CommandEncoder, &wgpu::Buffer),
    ) -> Self {
        let copy = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("Coming::copy"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        record(encoder, &copy);
        let (sender, mapped) = channel();
        encoder.map_buffer_on_submit(&copy, wgpu::MapMode::Read, .., move |result| {
            // The receiver may be gone.
            let _ = sender.send(result);
        });
        Self { copy, mapped, is_told: Cell::new(false) }
    }

    /// The bytes once, or none where the device failed or the commands were never submitted; `None` before they have come, and after
    /// that.
    pub fn take(&self) -> Option<Vec<u8>> {
        self.read(<[u8]>::to_vec).map(Result::unwrap_or_default)
    }

    /// What `read` makes of the bytes, or why there are none, once; `None` before they have come, and after that.
    pub fn read<T>(&self, read: impl FnOnce(&[u8]) -> T) -> Option<Result<T, DeviceError>> {
        if self.is_told.get() {
            return None;
        }
        let mapped = match self.mapped.try_recv() {
            Err(TryRecvError::Empty) => return None,
            Err(error) => Err(DeviceError::new(error)),
            Ok(mapped) => mapped.map_err(DeviceError::new),
        };
        self.is_told.set(true);
        let bytes = mapped.and_then(|()| self.copy.get_mapped_range(..).map_err(DeviceError::new));
        Some(bytes.map(|bytes| read(&bytes)))
    }
}
