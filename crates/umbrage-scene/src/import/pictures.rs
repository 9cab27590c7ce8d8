//! Picture files to textures, with limits against pictures that unpack to more than they weigh.
//!
//! PNG, JPEG, WebP, BMP and KTX2 begin with bytes that say what they are, and are believed before any name. TGA does not:
//! it is what its name says.

mod ktx;
mod resize;

use std::io::Cursor;

use image::{ImageFormat, ImageReader, Limits};

#[cfg(test)]
pub(crate) use ktx::file as ktx_file;
pub(super) use resize::resized;

use super::budget::Budget;
use crate::Texture;
use crate::error::Fault;

/// The longest side a texture may have, pixels: what common GPUs can hold.
pub(crate) const MAX_SIDE_PX: u32 = 16384;

/// What a decoder may allocate, bytes.
const DECODER_BYTES: u64 = 1 << 30;

/// What is read, as an error tells it.
const KINDS: &str = "a readable PNG, JPEG, WebP, BMP, TGA or KTX2";

/// Unpacks a picture that the scene calls `name`. `hint` is the name of its file or its media type, for kinds of picture
/// that cannot be told by their content.
pub(super) fn decode(bytes: &[u8], name: String, hint: &str, budget: &mut Budget) -> Result<Texture, Fault> {
    if bytes.starts_with(&ktx2::MAGIC) {
        return ktx::decode(bytes, &name, budget);
    }
    let fault = |why: &dyn std::fmt::Display| Fault(format!("texture {name:?} is not {KINDS}, {why}"));
    let format = format(bytes, hint).ok_or_else(|| fault(&"it begins like none of them"))?;
    let reader = || {
        let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
        let mut limits = Limits::default();
        limits.max_image_width = Some(MAX_SIDE_PX);
        limits.max_image_height = Some(MAX_SIDE_PX);
        limits.max_alloc = Some(DECODER_BYTES);
        reader.limits(limits);
        reader
    };
    let (width, height) = reader().into_dimensions().map_err(|why| fault(&why))?;
    take(&name, width, height, budget)?;
    let picture = reader().decode().map_err(|why| fault(&why))?.into_rgba8();
    let (width, height) = picture.dimensions();
    Ok(Texture { name, width, height, rgba: picture.into_raw() })
}

/// Unpacks the six faces of a KTX2 cube that its environment calls `name`.
pub(crate) fn cube_faces(bytes: &[u8], name: &str) -> Result<[Texture; 6], Fault> {
    let faces = ktx::faces(bytes, name, usize::MAX, &mut Budget::new())?;
    let count = faces.len();
    faces.try_into().map_err(|_| {
        let many = if count == 1 { "face" } else { "faces" };
        Fault(format!(
            "the environment {name:?} has {count} {many}, need the six of a cube or another kind of file"
        ))
    })
}

/// Takes room for a picture of that size, where it is not too large.
fn take(name: &str, width: u32, height: u32, budget: &mut Budget) -> Result<(), Fault> {
    if width.max(height) > MAX_SIDE_PX || width.min(height) == 0 {
        return Err(Fault(format!(
            "texture {name:?} has {width} by {height} pixels, need 1 to {MAX_SIDE_PX} a side"
        )));
    }
    budget.pixels(width, height)
}

/// The format by content first, and by name or media type second.
fn format(bytes: &[u8], hint: &str) -> Option<ImageFormat> {
    image::guess_format(bytes).ok().or_else(|| {
        let hint = hint.to_lowercase();
        let is_tga = hint.ends_with(".tga") || hint.ends_with("/tga") || hint.ends_with("/x-tga");
        is_tga.then_some(ImageFormat::Tga)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(format: ImageFormat) -> Vec<u8> {
        let mut bytes = Cursor::new(Vec::new());
        let picture = image::RgbImage::from_fn(4, 2, |x, _| image::Rgb([250 * (x as u8 / 2), 20, 90]));
        picture.write_to(&mut bytes, format).unwrap();
        bytes.into_inner()
    }

    fn read(bytes: &[u8], hint: &str) -> Result<Texture, Fault> {
        decode(bytes, "p".to_owned(), hint, &mut Budget::new())
    }

    #[test]
    fn content_decides_and_names_are_for_tga_alone() {
        for format in [ImageFormat::Png, ImageFormat::WebP, ImageFormat::Bmp] {
            let texture = read(&written(format), "wrong.tga").unwrap();
            assert_eq!((texture.width, texture.height), (4, 2), "{format:?}");
            assert_eq!(texture.rgba[..4], [0, 20, 90, 255], "{format:?}");
            assert_eq!(texture.rgba[8..12], [250, 20, 90, 255], "{format:?}");
        }
        let tga = written(ImageFormat::Tga);
        for hint in ["a.TGA", "image/tga", "image/x-tga"] {
            assert_eq!(read(&tga, hint).unwrap().rgba[8..12], [250, 20, 90, 255], "{hint}");
        }
        read(&tga, "a.png").unwrap_err();
    }

    #[test]
    fn what_is_no_picture_is_said_with_all_that_would_be_one() {
        let Fault(why) = read(b"GIF89a and so on", "a.gif").unwrap_err();
        assert!(why.contains("\"p\"") && why.contains("WebP"), "{why}");
        read(b"", "").unwrap_err();
        read(&[0; 30], "a.tga").unwrap_err();
    }

    #[test]
    fn pictures_beyond_the_budget_are_faults() {
        let mut budget = Budget::new();
        for _ in 0..4 {
            budget.pixels(8192, 8192).unwrap();
        }
        assert!(decode(&written(ImageFormat::Png), "p".to_owned(), "", &mut budget).is_err(), "it is spent");
    }
}
