//! The colours that tell splits apart: those of the tint in the picture.

use eframe::egui::{Color32, Rgba};
use umbrage_render::SPLIT_COLOURS;

/// Returns the colour of a split, or of a face of a point light's cube.
pub fn of_split(split: usize) -> Color32 {
    let [red, green, blue] = SPLIT_COLOURS[split % SPLIT_COLOURS.len()];
    Rgba::from_rgb(red, green, blue).into()
}
