//! PNG and JPEG files to textures, with limits against pictures that unpack to more than they weigh.

use std::io::Cursor;

use image::{ImageReader, Limits};

use super::budget::Budget;
use crate::Texture;
use crate::error::Fault;

/// The longest side a texture may have, pixels: what common GPUs can hold.
pub(crate) const MAX_SIDE_PX: u32 = 16384;

/// What a decoder may allocate, bytes.
const DECODER_BYTES: u64 = 1 << 30;

/// Unpacks a PNG or JPEG file that the scene calls `name`.
pub(super) fn decode(bytes: &[u8], name: String, budget: &mut Budget) -> Result<Texture, Fault> {
    let fault =
        |why: image::ImageError| Fault(format!("texture {name:?} is not a readable PNG or JPEG, {why}"));
    let reader = || {
        let mut reader = ImageReader::new(Cursor::new(bytes));
        let mut limits = Limits::default();
        limits.max_image_width = Some(MAX_SIDE_PX);
        limits.max_image_height = Some(MAX_SIDE_PX);
        limits.max_alloc = Some(DECODER_BYTES);
        reader.limits(limits);
        reader.with_guessed_format().map_err(|why| fault(why.into()))
    };
    let (width, height) = reader()?.into_dimensions().map_err(fault)?;
    if width.max(height) > MAX_SIDE_PX {
        let fault =
            format!("texture {name:?} has {width} by {height} pixels, need at most {MAX_SIDE_PX} a side");
        return Err(Fault(fault));
    }
    budget.pixels(width, height)?;
    let picture = reader()?.decode().map_err(fault)?.into_rgba8();
    let (width, height) = picture.dimensions();
    Ok(Texture { name, width, height, rgba: picture.into_raw() })
}
