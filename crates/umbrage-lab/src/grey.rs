//! Visibility as a picture shows it, pixel by pixel.

use umbrage_render::Picture;

/// Returns the visibility of every pixel, 0 to 1, of a picture that shows visibility as grey: 255 is lit, and 0 is shadowed.
pub fn visibility_from(picture: &Picture) -> Vec<f32> {
    picture.rgba.iter().step_by(4).map(|grey| f32::from(*grey) / 255.0).collect()
}
