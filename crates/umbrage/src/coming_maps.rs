//! The texels of all shadow maps on their way to the CPU: waited for, or polled until they are there.

use std::sync::mpsc::{Receiver, TryRecvError, channel};

use umbrage_core::{DepthFormat, MapLayout, MapTexels};

use crate::error::{DeviceError, ShadowError};

/// Shadow maps on their way to the CPU, as they are when [`Shadows::request_maps`](crate::Shadows::request_maps) is called.
#[derive(Debug)]
pub struct ComingMaps {
    buffer: wgpu::Buffer,
    mapped: Receiver<Result<(), wgpu::BufferAsyncError>>,
    layout: MapLayout,
    stride: u32,
}

impl ComingMaps {
    /// Starts to copy a texture of maps that lie so.
    pub(crate) fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        texture: &wgpu::Texture,
        layout: MapLayout,
    ) -> Result<Self, ShadowError> {
        let [width, height] = [texture.width(), texture.height()];
        let stride =
            (width * layout.depth.bytes() as u32).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let size = u64::from(stride) * u64::from(height) * u64::from(layout.layers);
        let max = device.limits().max_buffer_size;
        if size > max {
            return Err(ShadowError::CopyTooLarge { bytes: size, max });
        }
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("ComingMaps::buffer"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let label = Some("ComingMaps::encoder");
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label });
        encoder.copy_texture_to_buffer(
            wgpu::TexelCopyTextureInfo {
                texture,
                mip_level: 0,
                origin: wgpu::Origin3d::ZERO,
                aspect: wgpu::TextureAspect::DepthOnly,
            },
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(stride),
                    rows_per_image: Some(height),
                },
            },
            wgpu::Extent3d { width, height, depth_or_array_layers: layout.layers },
        );
        queue.submit([encoder.finish()]);
        let (sender, mapped) = channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // Nobody may want it any more.
            let _ = sender.send(result);
        });
        Ok(Self { buffer, mapped, layout, stride })
    }

    /// Waits for them.
    pub(crate) fn wait(&self, device: &wgpu::Device) -> Result<MapTexels, ShadowError> {
        device.poll(wgpu::PollType::wait_indefinitely()).map_err(failed)?;
        self.mapped.recv().map_err(failed)?.map_err(failed)?;
        self.texels()
    }

    /// Takes the maps, once; `None` where they have not come yet. It never waits: poll the device, or submit, between two
    /// calls.
    ///
    /// # Errors
    /// When the device fails.
    pub fn take(&self) -> Option<Result<MapTexels, ShadowError>> {
        match self.mapped.try_recv() {
            Err(TryRecvError::Empty) => None,
            Err(why) => Some(Err(failed(why))),
            Ok(Err(why)) => Some(Err(failed(why))),
            Ok(Ok(())) => Some(self.texels()),
        }
    }

    fn texels(&self) -> Result<MapTexels, ShadowError> {
        let Self { buffer, layout, stride, .. } = self;
        let mapped = buffer.get_mapped_range(..).map_err(failed)?;
        let used = layout.width as usize * layout.depth.bytes() as usize;
        let row = |row: &[u8]| -> Vec<f32> {
            let row = &row[..used];
            match layout.depth {
                DepthFormat::F32 => row.as_chunks().0.iter().map(|b| f32::from_le_bytes(*b)).collect(),
                DepthFormat::U16 => {
                    row.as_chunks().0.iter().map(|b| f32::from(u16::from_le_bytes(*b)) / 65535.0).collect()
                }
            }
        };
        let depths = mapped.chunks_exact(*stride as usize).flat_map(row).collect();
        Ok(MapTexels { layout: *layout, depths })
    }
}

fn failed(error: impl std::error::Error + Send + Sync + 'static) -> ShadowError {
    ShadowError::ReadBack(DeviceError::new(error))
}
