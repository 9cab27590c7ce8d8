//! Bytes of a buffer on their way to the CPU, which nobody waits for.

use std::sync::mpsc::{Receiver, channel};

/// A copy of a buffer that comes when the commands are done that it was recorded among.
#[derive(Debug)]
pub(crate) struct Coming {
    copy: wgpu::Buffer,
    mapped: Receiver<Result<(), wgpu::BufferAsyncError>>,
}

impl Coming {
    /// Records a copy of a whole buffer.
    pub fn of(device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, buffer: &wgpu::Buffer) -> Self {
        let copy = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("Coming::copy"),
            size: buffer.size(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, buffer.size());
        let (sender, mapped) = channel();
        encoder.map_buffer_on_submit(&copy, wgpu::MapMode::Read, .., move |result| {
            // The receiver may be gone.
            let _ = sender.send(result);
        });
        Self { copy, mapped }
    }

    /// The bytes, or none where the device failed or the commands were never submitted; `None` where they have not come yet.
    pub fn take(&self) -> Option<Vec<u8>> {
        match self.mapped.try_recv() {
            Err(std::sync::mpsc::TryRecvError::Empty) => None,
            Err(std::sync::mpsc::TryRecvError::Disconnected) | Ok(Err(_)) => Some(Vec::new()),
            Ok(Ok(())) => {
                Some(self.copy.get_mapped_range(..).map_or_else(|_| Vec::new(), |bytes| bytes.to_vec()))
            }
        }
    }
}
