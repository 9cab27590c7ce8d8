//! The texels of all shadow maps on their way to the CPU, and how they lie in a copy.

use umbrage_core::{DepthFormat, MapLayout, MapTexels};

use crate::coming::Coming;
use crate::error::ShadowError;

/// Texels of the maps on their way to the CPU, which nobody waits for: a page may not, since nothing comes while it does.
///
/// ```no_run
/// # fn look(device: &wgpu::Device, queue: &wgpu::Queue, shadows: &umbrage::Shadows) -> Result<(), umbrage::ShadowError> {
/// let mut encoder = device.create_command_encoder(&Default::default());
/// let coming = shadows.copy_maps(device, &mut encoder)?;
/// queue.submit([encoder.finish()]);
/// // In each frame from then on, until they have come:
/// if let Some(maps) = coming.take() {
///     println!("{} depths", maps?.depths.len());
/// }
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct ComingMaps {
    coming: Coming,
    layout: MapLayout,
}

impl ComingMaps {
    /// Texels of a copy of maps that lie so.
    pub(crate) fn new(coming: Coming, layout: MapLayout) -> Self {
        Self { coming, layout }
    }

    /// Returns the texels once, when they have come; `None` before that and after it.
    ///
    /// # Errors
    /// When the device is lost, or the commands were dropped that the copy was recorded among.
    pub fn take(&self) -> Option<Result<MapTexels, ShadowError>> {
        let read =
            self.coming.read(|bytes| MapTexels { layout: self.layout, depths: depths(bytes, self.layout) });
        read.map(|read| read.map_err(ShadowError::ReadBack))
    }
}

/// The bytes from one row of a copy to the next.
pub(crate) fn stride(layout: MapLayout) -> u32 {
    (layout.width * layout.depth.bytes() as u32).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT)
}

/// The depths of a copy.
fn depths(bytes: &[u8], layout: MapLayout) -> Vec<f32> {
    let row = |row: &[u8]| -> Vec<f32> {
        let row = &row[..layout.width as usize * layout.depth.bytes() as usize];
        match layout.depth {
            DepthFormat::F32 => bytemuck::pod_collect_to_vec(row),
            DepthFormat::U16 => {
                let steps: Vec<u16> = bytemuck::pod_collect_to_vec(row);
                steps.into_iter().map(|step| f32::from(step) / 65535.0).collect()
            }
        }
    };
    bytes.chunks_exact(stride(layout) as usize).flat_map(row).collect()
}
