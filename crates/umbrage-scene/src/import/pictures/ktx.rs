//! KTX2 pictures: the largest level of the first layer, one face of it or all of a cube, unpacked to RGBA.
//!
//! Source: the KTX File Format Specification, version 2.0. Block formats are unpacked by `texture2ddecoder`, and Zstandard
//! by `ruzstd`. Not read are pictures packed with Basis Universal, those of floats, and ASTC: its decoder panics on blocks
//! that are malformed.

use std::io::Read as _;

use ktx2::{Format, Header, Reader, SupercompressionScheme};
use texture2ddecoder as blocks;

use super::take;
use crate::Texture;
use crate::error::Fault;
use crate::import::budget::Budget;

/// A block decoder: packed bytes, width and height in pixels, and where the pixels go, each 0xAARRGGBB.
type Unpack = fn(&[u8], usize, usize, &mut [u32]) -> Result<(), &'static str>;

/// How pixels lie in a level.
enum Layout {
    /// One byte for each channel that is there, in this order: the place in the pixel of each of R, G, B and A.
    Bytes { size: usize, channels: [Option<usize>; 4] },
    /// Blocks of so many pixels and bytes.
    Blocks { width: u32, height: u32, bytes: usize, unpack: Unpack },
}

/// Unpacks the first face of a KTX2 file that the scene calls `name`.
pub(super) fn decode(bytes: &[u8], name: &str, budget: &mut Budget) -> Result<Texture, Fault> {
    let mut faces = faces(bytes, name, 1, budget)?;
    faces.pop().ok_or_else(|| Fault(format!("texture {name:?} has no faces")))
}

/// Unpacks as many faces of a KTX2 file as there are, or are wanted.
pub(super) fn faces(
    bytes: &[u8],
    name: &str,
    wanted: usize,
    budget: &mut Budget,
) -> Result<Vec<Texture>, Fault> {
    let fault = |why: String| Fault(format!("texture {name:?} is a KTX2 picture that is not read, {why}"));
    let file = Reader::new(bytes).map_err(|why| fault(why.to_string()))?;
    let Header {
        format, pixel_width, pixel_height, pixel_depth, face_count, supercompression_scheme, ..
    } = file.header();
    let layout = match format {
        Some(format) => layout(format).ok_or_else(|| fault(format!("its format is {format:?}")))?,
        None => {
            return Err(fault(
                "it is packed with Basis Universal: write it as PNG, or with blocks".to_owned(),
            ));
        }
    };
    if pixel_depth > 1 {
        return Err(fault(format!("it is {pixel_depth} pixels deep")));
    }
    let (width, height) = (pixel_width, pixel_height.max(1));
    // There are 1 or 6 of them, whatever a file says.
    let count = wanted.min(face_count.min(6) as usize);
    for _ in 0..count {
        take(name, width, height, budget)?;
    }
    let level = file.levels().next().ok_or_else(|| fault("it has no levels".to_owned()))?;
    let of_one = layout.bytes(width, height);
    let need = count * of_one;
    let unpacked;
    let data = match supercompression_scheme {
        None => level.data,
        Some(SupercompressionScheme::Zstandard) => {
            unpacked = unzstd(level.data, need).map_err(fault)?;
            &unpacked
        }
        Some(scheme) => return Err(fault(format!("it is packed with {scheme:?}"))),
    };
    let data = data
        .get(..need)
        .ok_or_else(|| fault(format!("its largest level has {} bytes, need {need}", data.len())))?;
    let face = |data: &[u8]| {
        let rgba = layout.rgba(data, width as usize, height as usize).map_err(|why| fault(why.to_owned()))?;
        Ok(Texture { name: name.to_owned(), width, height, rgba })
    };
    data.chunks_exact(of_one).map(face).collect()
}

/// At most `need` bytes of what was packed.
fn unzstd(packed: &[u8], need: usize) -> Result<Vec<u8>, String> {
    let decoder =
        ruzstd::decoding::StreamingDecoder::new(packed).map_err(|why| format!("Zstandard: {why}"))?;
    let mut bytes = Vec::new();
    decoder.take(need as u64).read_to_end(&mut bytes).map_err(|why| format!("Zstandard: {why}"))?;
    Ok(bytes)
}

impl Layout {
    /// How many bytes a picture of this size takes.
    fn bytes(&self, width: u32, height: u32) -> usize {
        match *self {
            Self::Bytes { size, .. } => width as usize * height as usize * size,
            Self::Blocks { width: across, height: down, bytes, .. } => {
                width.div_ceil(across) as usize * height.div_ceil(down) as usize * bytes
            }
        }
    }

    fn rgba(&self, data: &[u8], width: usize, height: usize) -> Result<Vec<u8>, &'static str> {
        match *self {
            Self::Bytes { size, channels } => {
                let opaque_black = [0, 0, 0, 255];
                let pixel = |pixel: &[u8]| {
                    let channel = |c: usize| channels[c].map_or(opaque_black[c], |place| pixel[place]);
                    [0, 1, 2, 3].map(channel)
                };
                Ok(data.chunks_exact(size).flat_map(pixel).collect())
            }
            Self::Blocks { unpack, .. } => {
                let mut pixels = vec![0u32; width * height];
                unpack(data, width, height, &mut pixels)?;
                let rgba = |pixel: u32| {
                    let [b, g, r, a] = pixel.to_le_bytes();
                    [r, g, b, a]
                };
                Ok(pixels.into_iter().flat_map(rgba).collect())
            }
        }
    }
}

/// The layout of a format that is read.
fn layout(format: Format) -> Option<Layout> {
    let bytes = |size, channels| Some(Layout::Bytes { size, channels });
    let blocks = |width, height, bytes, unpack| Some(Layout::Blocks { width, height, bytes, unpack });
    match format {
        Format::R8_UNORM | Format::R8_SRGB => bytes(1, [Some(0), None, None, None]),
        Format::R8G8_UNORM | Format::R8G8_SRGB => bytes(2, [Some(0), Some(1), None, None]),
        Format::R8G8B8_UNORM | Format::R8G8B8_SRGB => bytes(3, [Some(0), Some(1), Some(2), None]),
        Format::B8G8R8_UNORM | Format::B8G8R8_SRGB => bytes(3, [Some(2), Some(1), Some(0), None]),
        Format::R8G8B8A8_UNORM | Format::R8G8B8A8_SRGB => bytes(4, [Some(0), Some(1), Some(2), Some(3)]),
        Format::B8G8R8A8_UNORM | Format::B8G8R8A8_SRGB => bytes(4, [Some(2), Some(1), Some(0), Some(3)]),
        Format::BC1_RGB_UNORM_BLOCK | Format::BC1_RGB_SRGB_BLOCK => blocks(4, 4, 8, blocks::decode_bc1),
        Format::BC1_RGBA_UNORM_BLOCK | Format::BC1_RGBA_SRGB_BLOCK => blocks(4, 4, 8, blocks::decode_bc1a),
        Format::BC2_UNORM_BLOCK | Format::BC2_SRGB_BLOCK => blocks(4, 4, 16, blocks::decode_bc2),
        Format::BC3_UNORM_BLOCK | Format::BC3_SRGB_BLOCK => blocks(4, 4, 16, blocks::decode_bc3),
        Format::BC4_UNORM_BLOCK => blocks(4, 4, 8, blocks::decode_bc4),
        Format::BC5_UNORM_BLOCK => blocks(4, 4, 16, blocks::decode_bc5),
        Format::BC7_UNORM_BLOCK | Format::BC7_SRGB_BLOCK => blocks(4, 4, 16, blocks::decode_bc7),
        Format::ETC2_R8G8B8_UNORM_BLOCK | Format::ETC2_R8G8B8_SRGB_BLOCK => {
            blocks(4, 4, 8, blocks::decode_etc2_rgb)
        }
        Format::ETC2_R8G8B8A1_UNORM_BLOCK | Format::ETC2_R8G8B8A1_SRGB_BLOCK => {
            blocks(4, 4, 8, blocks::decode_etc2_rgba1)
        }
        Format::ETC2_R8G8B8A8_UNORM_BLOCK | Format::ETC2_R8G8B8A8_SRGB_BLOCK => {
            blocks(4, 4, 16, blocks::decode_etc2_rgba8)
        }
        Format::EAC_R11_UNORM_BLOCK => blocks(4, 4, 8, blocks::decode_eacr),
        Format::EAC_R11G11_UNORM_BLOCK => blocks(4, 4, 16, blocks::decode_eacrg),
        _ => None,
    }
}

#[cfg(test)]
mod tests;
#[cfg(test)]
pub(crate) use tests::file;
