//! A picture of everything around a scene, which lights it from all sides and is seen behind it.
//!
//! It is equirectangular: rows go from straight up to straight down, columns once around, and its middle lies ahead of a camera
//! that looks along −Z. A Radiance HDR file holds luminance as it is; of other pictures white is 1 candela a square metre.
//! The six pictures of a cube are made such a picture (`cube.rs`).

mod cube;

use std::f32::consts::{PI, TAU};
use std::fs;
use std::io::Cursor;
use std::path::Path;

use glam::Vec3;
use image::{ColorType, DynamicImage, ImageError, ImageReader, Limits};

use crate::error::{Fault, SceneError};

/// The largest width that is kept, pixels; larger pictures are halved until they fit.
const MOST_WIDTH: u32 = 2048;

/// The most pixels that are read: those of 8192 × 4096.
const MOST_PIXELS: u64 = 1 << 25;

/// What a decoder may allocate, bytes.
const DECODER_BYTES: u64 = 1 << 30;

/// The light of a pixel is at most this, candela a square metre: the sun's own disc, and a little more.
const BRIGHTEST: f32 = 4e9;

/// An environment is a picture of everything around a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Environment {
    /// The name of the picture's file.
    pub name: String,
    /// The width, in pixels.
    pub width: u32,
    /// The height, in pixels.
    pub height: u32,
    /// The light of every pixel in rows from top to bottom, as linear RGB, candela a square metre, each 0 or more.
    pub light: Vec<[f32; 3]>,
}

/// Reads an environment: an equirectangular picture, as Radiance HDR or any picture that a texture may be; the six faces of a
/// cube texture as KTX2; or a folder with six square pictures, whose names end in `px`, `nx`, `py`, `ny`, `pz` and `nz`, or in
/// `posx` … `negz`, or in `right`, `left`, `top`, `bottom`, `front` and `back`.
///
/// A cube's faces are as OpenGL has them: with `pz` ahead, which is along the world's −Z, `px` lies to the right, along +X.
///
/// # Errors
/// When a file cannot be read, is no such picture, or has more than 8192 × 4096 pixels; when a cube lacks a face, or its faces
/// are no squares of one size.
pub fn load_environment(path: &Path) -> Result<Environment, SceneError> {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    if path.is_dir() {
        return cube::of_folder(path, name);
    }
    let bytes = fs::read(path).map_err(|why| SceneError::read(why, path))?;
    let read = if bytes.starts_with(&ktx2::MAGIC) { cube::of_ktx2 } else { decode };
    read(&bytes, name).map_err(|fault| fault.in_file(path.display()))
}

fn decode(bytes: &[u8], name: String) -> Result<Environment, Fault> {
    let mut environment = picture(bytes, name)?;
    while environment.width > MOST_WIDTH {
        environment = environment.halved();
    }
    Ok(environment)
}

/// A picture, as large as it is.
fn picture(bytes: &[u8], name: String) -> Result<Environment, Fault> {
    let fault = |why: ImageError| Fault(format!("the environment {name:?} is not a readable picture, {why}"));
    let reader = || {
        let mut reader = ImageReader::new(Cursor::new(bytes));
        let mut limits = Limits::default();
        limits.max_alloc = Some(DECODER_BYTES);
        reader.limits(limits);
        reader.with_guessed_format().map_err(|why| fault(why.into()))
    };
    let (width, height) = reader()?.into_dimensions().map_err(fault)?;
    if !(1..=MOST_PIXELS).contains(&(u64::from(width) * u64::from(height))) {
        let got = format!("the environment {name:?} has {width} by {height} pixels");
        return Err(Fault(format!("{got}, need 1 to {MOST_PIXELS} of them")));
    }
    let picture = reader()?.decode().map_err(fault)?;
    let (width, height) = (picture.width(), picture.height());
    Ok(Environment { name, width, height, light: light_of(picture) })
}

/// The light of an sRGB number, both 0 to 1.
fn linear(s: f32) -> f32 {
    if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }
}

/// The light of every pixel.
fn light_of(picture: DynamicImage) -> Vec<[f32; 3]> {
    let is_light = matches!(picture.color(), ColorType::Rgb32F | ColorType::Rgba32F);
    let light = |number: f32| if number > 0.0 { number.min(BRIGHTEST) } else { 0.0 };
    let rgb = picture.into_rgb32f();
    let pixels = rgb.pixels().map(|pixel| pixel.0);
    pixels.map(|rgb| rgb.map(|number| light(if is_light { number } else { linear(number) }))).collect()
}

impl Environment {
    /// Returns the unit direction, in world space, that a place of any environment picture shows, by its shares of the width and
    /// of the height.
    pub fn direction(across: f32, down: f32) -> Vec3 {
        let (turn, drop) = ((across - 0.5) * TAU, down * PI);
        Vec3::new(turn.sin() * drop.sin(), drop.cos(), -turn.cos() * drop.sin())
    }

    /// Half as wide and high: the mean of four pixels each.
    #[must_use]
    pub fn halved(&self) -> Self {
        let Self { name, width, height, light } = self;
        let (half_width, half_height) = ((width / 2).max(1), (height / 2).max(1));
        let pixel = |x: u32, y: u32| light[(y.min(height - 1) * width + x.min(width - 1)) as usize];
        let mean = |x: u32, y: u32| {
            let four = [
                pixel(2 * x, 2 * y),
                pixel(2 * x + 1, 2 * y),
                pixel(2 * x, 2 * y + 1),
                pixel(2 * x + 1, 2 * y + 1),
            ];
            std::array::from_fn(|channel| four.iter().map(|pixel| 0.25 * pixel[channel]).sum())
        };
        let light = (0..half_height)
            .flat_map(|y| (0..half_width).map(move |x| (x, y)))
            .map(|(x, y)| mean(x, y))
            .collect();
        Self { name: name.clone(), width: half_width, height: half_height, light }
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use image::codecs::hdr::HdrEncoder;
    use image::{ImageFormat, Rgb, RgbImage};

    use super::*;

    #[test]
    fn radiance_holds_light_as_it_is_and_other_pictures_are_srgb() {
        let mut hdr = Vec::new();
        let light = [Rgb([8.0, 0.5, 0.0]), Rgb([0.25, 0.25, 1024.0])];
        HdrEncoder::new(&mut hdr).encode(&light, 2, 1).unwrap();
        let read = decode(&hdr, "a.hdr".to_owned()).unwrap();
        assert_eq!((read.width, read.height), (2, 1));
        for (got, want) in read.light.iter().zip(light) {
            // Eight bits for the brightest of the three.
            let close = got
                .iter()
                .zip(want.0)
                .all(|(a, b)| (a - b).abs() <= want.0.iter().fold(0.0, |m, n| f32::max(m, *n)) / 128.0);
            assert!(close, "{got:?} instead of {want:?}");
        }
        let mut png = Cursor::new(Vec::new());
        RgbImage::from_pixel(2, 2, Rgb([188, 255, 0])).write_to(&mut png, ImageFormat::Png).unwrap();
        let [red, green, blue] = decode(png.get_ref(), "a.png".to_owned()).unwrap().light[3];
        assert!((red - 0.5).abs() < 0.01 && green == 1.0 && blue == 0.0, "{red} {green} {blue}");
    }

    #[test]
    fn what_is_no_picture_is_refused_in_a_line() {
        for bytes in [&b""[..], b"#?RADIANCE\n", b"not a picture"] {
            let Fault(why) = decode(bytes, "a.hdr".to_owned()).unwrap_err();
            assert!(why.contains("a.hdr") && !why.contains('\n'), "{why}");
        }
    }

    #[test]
    fn half_a_picture_has_the_same_mean() {
        let light: Vec<[f32; 3]> = (0..32u8).map(|i| [f32::from(i), 1.0, 0.0]).collect();
        let whole = Environment { name: String::new(), width: 8, height: 4, light };
        let half = whole.halved();
        assert_eq!((half.width, half.height, half.light.len()), (4, 2, 8));
        let mean =
            |of: &Environment| of.light.iter().map(|pixel| pixel[0]).sum::<f32>() / of.light.len() as f32;
        assert_eq!(mean(&whole), mean(&half));
    }
}
