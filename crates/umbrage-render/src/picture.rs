//! A picture on the CPU, and on its way there.

use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::read_back::Coming;

/// A picture on the CPU, rows from top to bottom: sRGB, or linear where it shows visibility.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// `4 · width · height` bytes.
    pub rgba: Vec<u8>,
}

impl Picture {
    /// Returns the visibility of every pixel, 0 shadowed to 1 lit, of a picture that shows it as grey
    /// ([`Show::Visibility`](crate::Show::Visibility)).
    pub fn visibility(&self) -> Vec<f32> {
        self.rgba.iter().step_by(4).map(|grey| f32::from(*grey) / 255.0).collect()
    }
}

/// A picture on its way to the CPU.
#[derive(Debug)]
pub struct ComingPicture {
    bytes: Coming,
    width: u32,
    height: u32,
    stride: u32,
}

impl ComingPicture {
    /// Starts to copy a texture of four bytes a texel to the CPU.
    ///
    /// # Errors
    /// When it exceeds the adapter's buffers.
    pub fn of_texture(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Self, RenderError> {
        let (width, height) = (texture.width(), texture.height());
        let stride = (width * 4).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let size = u64::from(stride) * u64::from(height);
        let most = gpu.device.limits().max_buffer_size;
        if size > most {
            return Err(RenderError::TooLarge { what: "picture", bytes: size, most });
        }
        let buffer = gpu.buffer(&wgpu::BufferDescriptor {
            label: Some("ComingPicture::buffer"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = gpu.encoder("ComingPicture::encoder");
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(stride),
                    rows_per_image: Some(height),
                },
            },
            wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        );
        gpu.queue.submit([encoder.finish()]);
        Ok(ComingPicture { bytes: Coming::new(buffer), width, height, stride })
    }

    /// Waits for it.
    pub(crate) fn wait(&self, gpu: &Gpu) -> Result<Picture, RenderError> {
        gpu.wait()?;
        self.take().unwrap_or_else(|| Err(RenderError::Device("the picture did not come".to_owned())))
    }

    /// Takes the picture, once; `None` where it has not come yet. It never waits: poll the device, or submit, between two
    /// calls.
    ///
    /// # Errors
    /// When the device fails.
    pub fn take(&self) -> Option<Result<Picture, RenderError>> {
        let Self { bytes, width, height, stride } = self;
        let rgba = bytes.take(|bytes| {
            let rows = bytes.chunks_exact(*stride as usize);
            rows.flat_map(|row| &row[..*width as usize * 4]).copied().collect()
        })?;
        Some(rgba.map(|rgba| Picture { width: *width, height: *height, rgba }))
    }
}
