//! The colours that tell splits apart: those of the tint in `umbrage-render`'s shader, after Okabe and Ito.

use eframe::egui::{Color32, Rgba};

/// Linear red, green and blue, as in `shade.wgsl`.
const SPLITS: [[f32; 3]; 9] = [
    [0.80, 0.15, 0.05],
    [0.90, 0.55, 0.05],
    [0.05, 0.45, 0.25],
    [0.05, 0.30, 0.70],
    [0.55, 0.15, 0.50],
    [0.10, 0.60, 0.75],
    [0.75, 0.70, 0.10],
    [0.40, 0.25, 0.10],
    [0.50, 0.50, 0.50],
];

/// The colour of a split, or of a face of a point light's cube.
pub fn of_split(split: usize) -> Color32 {
    let [red, green, blue] = SPLITS[split % SPLITS.len()];
    Rgba::from_rgb(red, green, blue).into()
}
