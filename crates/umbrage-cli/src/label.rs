//! A sheet that pictures and words are put on.

use ab_glyph::{Font as _, FontRef, ScaleFont as _, point};
use image::{Rgba, RgbaImage, imageops};

/// A sheet of paper, and a font.
pub struct Sheet {
    pub image: RgbaImage,
    font: FontRef<'static>,
}

/// Dark grey, as print.
const INK: [u8; 3] = [34, 34, 38];

impl Sheet {
    /// White paper of so many pixels.
    pub fn new(width: u32, height: u32) -> anyhow::Result<Self> {
        let font = FontRef::try_from_slice(epaint_default_fonts::UBUNTU_LIGHT)?;
        Ok(Self { image: RgbaImage::from_pixel(width, height, Rgba([255; 4])), font })
    }

    /// Puts a picture with its upper left corner at x, y; scaled to `width` × `height`.
    pub fn place(&mut self, picture: &RgbaImage, x: u32, y: u32, width: u32, height: u32) {
        let scaled = if picture.dimensions() == (width, height) {
            picture.clone()
        } else {
            imageops::resize(picture, width, height, imageops::FilterType::Triangle)
        };
        imageops::overlay(&mut self.image, &scaled, i64::from(x), i64::from(y));
    }

    /// Writes a line with its upper left corner at x, y, letters `size` pixels tall or as much smaller as it takes to stay
    /// `width` pixels wide.
    pub fn write_within(&mut self, text: &str, x: u32, y: u32, (width, size): (u32, f32)) {
        let font = self.font.as_scaled(size);
        let wide: f32 = text.chars().map(|letter| font.h_advance(font.glyph_id(letter))).sum();
        self.write(text, x, y, size * (width as f32 / wide.max(1.0)).min(1.0));
    }

    /// Writes a line with its upper left corner at x, y, letters `size` pixels tall.
    pub fn write(&mut self, text: &str, x: u32, y: u32, size: f32) {
        let font = self.font.as_scaled(size);
        let mut pen = point(x as f32, y as f32 + font.ascent());
        let mut before = None;
        let mut covered = Vec::new();
        for letter in text.chars() {
            let id = font.glyph_id(letter);
            pen.x += before.map_or(0.0, |before| font.kern(before, id));
            if let Some(outline) = font.outline_glyph(id.with_scale_and_position(size, pen)) {
                let corner = outline.px_bounds().min;
                outline.draw(|dx, dy, cover| {
                    covered.push((corner.x as i64 + i64::from(dx), corner.y as i64 + i64::from(dy), cover));
                });
            }
            pen.x += font.h_advance(id);
            before = Some(id);
        }
        for (x, y, cover) in covered {
            let Some(pixel) = u32::try_from(x)
                .ok()
                .zip(u32::try_from(y).ok())
                .and_then(|(x, y)| self.image.get_pixel_mut_checked(x, y))
            else {
                continue;
            };
            for (channel, ink) in pixel.0.iter_mut().zip(INK) {
                *channel = (f32::from(*channel)
                    + (f32::from(ink) - f32::from(*channel)) * cover.clamp(0.0, 1.0))
                    as u8;
            }
        }
    }
}
