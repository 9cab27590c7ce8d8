//! How wrong the shadows are that another renderer drew of a shot.
//!
//! Its visibility is not known, but its light is: with shadows (S), without (U), and with ambient light alone (A). Where light
//! adds up, visibility is (S − A) / (U − A), in linear light. That says something only where U − A is not small: other pixels are
//! left out, of what it drew and of what it is compared with alike.

use std::path::Path;

use image::RgbImage;
use serde::Serialize;
use umbrage_judge::{Edges, Error, Pixel, ShadowResult, Truth, World};

use crate::error::LabError;

/// So many of a channel's 255 steps must lie between U and A. Each picture is rounded by up to half a step, so that
/// visibility is wrong by up to a twentieth there, and by less elsewhere.
const LEAST_STEPS: u8 = 24;

/// The visibility that another renderer's pictures of one light come to, row by row; `None` where it cannot be told.
#[derive(Clone, Debug, PartialEq)]
pub struct Foreign {
    /// The width of the pictures, in pixels.
    pub width: u32,
    /// The height of the pictures, in pixels.
    pub height: u32,
    /// The visibility of every pixel, 0 to 1.
    pub visibility: Vec<Option<f32>>,
}

/// What is wrong with another renderer's shadows, and with ours in the same pixels.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForeignError {
    /// The number of pixels that are judged of both: the truth is sure, and the other's visibility can be told.
    pub pixels: usize,
    /// The share of the pixels with a sure truth that this is.
    pub share: f64,
    /// The error of the other's shadows.
    pub error: Wrong,
    /// The error of ours, over the same pixels.
    pub ours: Wrong,
}

/// The figures of [`Error`] that need nothing of how shadows were made.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Wrong {
    /// Share of judged pixels that are wrong in either direction.
    pub mis_shadowed: f64,
    /// Share of judged pixels that are shadowed and should be lit.
    pub false_shadow: f64,
    /// Share of judged pixels that are lit and should be shadowed.
    pub false_light: f64,
    /// Mean absolute error of visibility.
    pub mae: f64,
    /// Root mean square error of visibility.
    pub rmse: f64,
}

impl Foreign {
    /// Reads the pictures of a folder: `lit.png`, `unshadowed.png` and `ambient.png`, of one size, in sRGB.
    ///
    /// # Errors
    /// When one cannot be read, or they are of different sizes; the error names it.
    pub fn read(folder: &Path) -> Result<Self, LabError> {
        let read = |name: &str| -> Result<RgbImage, LabError> {
            let path = folder.join(name);
            let failed = |action, source| LabError::File { action, path: path.clone(), source };
            let bytes = std::fs::read(&path).map_err(|why| failed("read", why))?;
            let picture = image::load_from_memory(&bytes);
            Ok(picture.map_err(|why| failed("decode", std::io::Error::other(why)))?.into_rgb8())
        };
        let (lit, unshadowed, ambient) = (read("lit.png")?, read("unshadowed.png")?, read("ambient.png")?);
        let size = lit.dimensions();
        for (name, other) in [("unshadowed.png", &unshadowed), ("ambient.png", &ambient)] {
            if other.dimensions() != size {
                return Err(LabError::Sizes { name, wanted: size, got: other.dimensions() });
            }
        }
        Ok(Self::of(&lit, &unshadowed, &ambient))
    }

    /// Takes visibility from pictures of one size: with shadows, without, and by ambient light alone.
    pub fn of(lit: &RgbImage, unshadowed: &RgbImage, ambient: &RgbImage) -> Self {
        let pixels = lit.pixels().zip(unshadowed.pixels()).zip(ambient.pixels());
        let visibility =
            pixels.map(|((lit, unshadowed), ambient)| visibility(lit.0, unshadowed.0, ambient.0));
        Self { width: lit.width(), height: lit.height(), visibility: visibility.collect() }
    }

    /// Judges it, and what is ours, by the truth of the same shot. `None` where no pixel can be judged.
    pub(crate) fn judge(&self, world: &World, truth: &Truth, ours: &[f32]) -> Option<ForeignError> {
        let sure = truth.judged();
        let mut truth = truth.clone();
        for (pixel, visibility) in truth.pixels.iter_mut().zip(&self.visibility) {
            if visibility.is_none() && pixel.is_judged() {
                // As far as pictures tell, the light does not reach it.
                *pixel = Pixel::Unreached;
            }
        }
        let theirs: Vec<f32> = self.visibility.iter().map(|visibility| visibility.unwrap_or(1.0)).collect();
        let (edges, pixels) = (Edges::new(&truth), truth.judged());
        let wrong = |visibility: &[f32]| wrong(world, &truth, &edges, visibility);
        let (error, ours) = (wrong(&theirs)?, wrong(ours)?);
        Some(ForeignError { pixels, share: pixels as f64 / sure as f64, error, ours })
    }
}

fn wrong(world: &World, truth: &Truth, edges: &Edges, visibility: &[f32]) -> Option<Wrong> {
    let texel_metres = vec![0.0; truth.pixels.len()];
    let result = ShadowResult { visibility, texel_metres: &texel_metres };
    let error = Error::new(world, truth, edges, None, &result)?;
    let Error { mis_shadowed, false_shadow, false_light, mae, rmse, .. } = error;
    Some(Wrong { mis_shadowed, false_shadow, false_light, mae, rmse })
}

/// The visibility of a pixel, from the channel in which shadows tell most. One that is as bright as a picture can be may be
/// brighter, and says nothing.
fn visibility(lit: [u8; 3], unshadowed: [u8; 3], ambient: [u8; 3]) -> Option<f32> {
    let steps = |channel: &usize| unshadowed[*channel].saturating_sub(ambient[*channel]);
    let channel = (0..3).filter(|channel| unshadowed[*channel] < u8::MAX).max_by_key(steps)?;
    if steps(&channel) < LEAST_STEPS {
        return None;
    }
    let [lit, unshadowed, ambient] = [lit, unshadowed, ambient].map(|pixel| linear(pixel[channel]));
    Some(((lit - ambient) / (unshadowed - ambient)).clamp(0.0, 1.0))
}

/// sRGB to linear light (IEC 61966-2-1).
fn linear(byte: u8) -> f32 {
    let share = f32::from(byte) / 255.0;
    if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_the_suns_light_is_half_visible() {
        // 0.2158 and 0.0 in linear light, and half of it: 0.1079.
        assert_eq!(visibility([93, 0, 0], [128, 0, 0], [0, 0, 0]).map(|v| (100.0 * v).round()), Some(50.0));
        assert_eq!(visibility([40, 40, 40], [128, 128, 128], [40, 40, 40]), Some(0.0));
        assert_eq!(visibility([128, 90, 9], [128, 90, 9], [40, 40, 9]), Some(1.0));
    }

    #[test]
    fn what_is_dark_or_too_bright_says_nothing() {
        assert_eq!(visibility([50, 50, 50], [63, 60, 60], [40, 40, 40]), None);
        assert_eq!(visibility([50, 50, 50], [255, 255, 255], [40, 40, 40]), None);
        // Another channel may.
        assert_eq!(visibility([50, 128, 50], [255, 128, 255], [40, 40, 40]), Some(1.0));
    }
}
