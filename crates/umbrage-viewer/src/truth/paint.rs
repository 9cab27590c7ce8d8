//! Verdicts as colours over the picture.

use eframe::egui;
use umbrage_judge::{Progress, Tile, Verdict};
use umbrage_lab::heat::{FALSE_LIGHT, FALSE_SHADOW};

/// A tile of the overlay: every pixel has the colour of the traced pixel that stands in for it.
pub fn tile(tile: &Tile, progress: &Progress, visibility: &[&[f32]]) -> egui::ColorImage {
    let size = [tile.width as usize, tile.height as usize];
    let places =
        (tile.y..tile.y + tile.height).flat_map(|y| (tile.x..tile.x + tile.width).map(move |x| (x, y)));
    let colour = |(x, y): (u32, u32)| {
        let traced = progress.stand_in(progress.index(x, y));
        traced.map_or(colour(Verdict::NotTraced, false), |i| {
            colour(progress.verdict(visibility, i), progress.is_partial(i))
        })
    };
    egui::ColorImage::new(size, places.map(colour).collect())
}

/// The colour over a pixel: right ones are darkened, so that wrong ones stand out, and grey where only a share of some light
/// should come through glass.
fn colour(verdict: Verdict, is_partial: bool) -> egui::Color32 {
    let opaque = |[red, green, blue]: [u8; 3]| egui::Color32::from_rgb(red, green, blue);
    match verdict {
        Verdict::NotTraced => egui::Color32::TRANSPARENT,
        Verdict::Right if is_partial => egui::Color32::from_rgba_unmultiplied(128, 128, 128, 110),
        Verdict::Right => egui::Color32::from_black_alpha(60),
        Verdict::NotJudged => egui::Color32::from_black_alpha(140),
        Verdict::FalseShadow => opaque(FALSE_SHADOW),
        Verdict::FalseLight => opaque(FALSE_LIGHT),
    }
}
