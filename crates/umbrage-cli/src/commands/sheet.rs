//! `umbrage sheet`: a picture of each of many files, side by side on one sheet, each over its name.
//!
//! A file that cannot be drawn has its reason in its place: one bad file spoils no sheet.

use std::path::Path;
use std::sync::Arc;

use image::{ExtendedColorType, RgbaImage};
use umbrage::Settings;
use umbrage_lab::{Shot, files};
use umbrage_render::{Frame, Gpu, Renderer, Show};
use umbrage_scene::{Imported, Shining};

use crate::args::{SheetArgs, TimeArgs};
use crate::failure::{Failure, Outcome};
use crate::label::Sheet;
use crate::{output, progress, world};

/// White around tiles, pixels.
const GAP: u32 = 8;
/// Room for a line of letters, and how tall they are.
const LINE: u32 = 20;
const LETTERS: f32 = 16.0;
/// A letter is so wide in the mean, as a share of its height: a reason's lines end by it.
const LETTER_WIDTH: f32 = 0.5;

/// A file's name, and its picture or why there is none.
struct Tile {
    name: String,
    picture: Result<RgbaImage, String>,
}

pub fn run(args: &SheetArgs) -> Outcome {
    let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
    let size = args.size.unwrap_or((320, 240));
    let bar = progress::bar(args.files.len() as u64, "drawing");
    let mut tiles = Vec::new();
    for file in &args.files {
        let picture = draw(&gpu, file, &args.when, size).map_err(|why| why.to_string());
        if let Err(why) = &picture {
            eprintln!("warning: not drawn, {why}");
        }
        tiles.push(Tile { name: short_name(file), picture });
        bar.inc(1);
    }
    bar.finish_and_clear();
    if tiles.iter().all(|tile| tile.picture.is_err()) {
        return Err(anyhow::anyhow!("none of {} files can be drawn", tiles.len()).into());
    }
    let sheet = compose(&tiles, args.across, size)?;
    output::write_png(
        &args.output,
        sheet.width(),
        sheet.height(),
        &sheet.into_raw(),
        ExtendedColorType::Rgba8,
    )?;
    Ok(())
}

/// A picture from a file's first camera, under its lights, or as many as shine at once.
fn draw(gpu: &Gpu, file: &str, when: &TimeArgs, (width, height): (u32, u32)) -> Outcome<RgbaImage> {
    let Imported { mut scene, warnings } = files::load_world(file, 0)?;
    for warning in warnings {
        eprintln!("warning: {warning}: {file}");
    }
    let camera = scene.cameras.first().cloned().ok_or_else(|| Failure::usage("there is no camera"))?;
    world::play(&mut scene, when)?;
    let pose = Arc::new(world::pose(&scene, when)?);
    let Shining { lights, warnings } = Shining::choose(&scene.lights, &camera, &pose, umbrage::MAX_LIGHTS);
    for warning in warnings {
        eprintln!("warning: {warning}: {file}");
    }
    let shot = Shot { camera, lights, pose, width, height };
    let frame = Frame { samples: 4, ..shot.frame(Show::World).map_err(Failure::usage)? };
    let mut renderer = Renderer::new(gpu, &scene, Settings::default())?;
    let picture = renderer.render(&frame)?.drawn.picture()?;
    RgbaImage::from_raw(picture.width, picture.height, picture.rgba)
        .ok_or_else(|| anyhow::anyhow!("the picture is not {width} x {height} pixels").into())
}

/// The end of a path that tells files apart: the folder and the stem.
fn short_name(file: &str) -> String {
    let path = Path::new(file).with_extension("");
    let name = |path: &Path| path.file_name().map(|name| name.to_string_lossy().into_owned());
    let folder = path.parent().and_then(name).map_or_else(String::new, |folder| folder + "/");
    folder + &name(&path).unwrap_or_default()
}

/// Tiles in rows of `across`.
fn compose(tiles: &[Tile], across: u32, (width, height): (u32, u32)) -> anyhow::Result<RgbaImage> {
    let across = across.min(tiles.len() as u32).max(1);
    let (step_x, step_y) = (width + GAP, height + LINE + GAP);
    let rows = (tiles.len() as u32).div_ceil(across);
    let mut sheet = Sheet::new(GAP + across * step_x, GAP + rows * step_y)?;
    for (tile, i) in tiles.iter().zip(0..) {
        let (x, y) = (GAP + i % across * step_x, GAP + i / across * step_y);
        match &tile.picture {
            Ok(picture) => sheet.place(picture, x, y, width, height),
            Err(why) => {
                for (line, i) in
                    folded(why, (width as f32 / (LETTERS * LETTER_WIDTH)) as usize).iter().zip(0..)
                {
                    sheet.write(line, x, y + i * LINE, LETTERS);
                }
            }
        }
        sheet.write(&tile.name, x, y + height + 2, LETTERS);
    }
    Ok(sheet.image)
}

/// A text in lines of at most `most` letters, broken between words where there is a gap.
fn folded(text: &str, most: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        for piece in word.chars().collect::<Vec<_>>().chunks(most.max(1)) {
            let line = lines.len() - 1;
            if !lines[line].is_empty() && lines[line].chars().count() + 1 + piece.len() > most {
                lines.push(String::new());
            }
            let line = lines.len() - 1;
            if !lines[line].is_empty() {
                lines[line].push(' ');
            }
            lines[line].extend(piece);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use image::Rgba;

    use super::*;

    #[test]
    fn a_name_is_the_folder_and_the_stem() {
        assert_eq!(short_name("models/chair/left.glb"), "chair/left");
        assert_eq!(short_name("left.glb"), "left");
        assert_eq!(short_name("mining-terrain"), "mining-terrain");
    }

    #[test]
    fn reasons_are_folded_between_words_and_long_words_are_cut() {
        assert_eq!(folded("a file of no use", 7), ["a file", "of no", "use"]);
        assert_eq!(folded("abcdefgh", 3), ["abc", "def", "gh"]);
        assert_eq!(folded("", 3), [""]);
    }

    #[test]
    fn pictures_stand_over_their_names_and_a_refusal_leaves_white_paper() {
        let tile = |grey: u8| Tile {
            name: "n".to_owned(),
            picture: Ok(RgbaImage::from_pixel(16, 8, Rgba([grey, grey, grey, 255]))),
        };
        let refused = Tile { name: "n".to_owned(), picture: Err(String::new()) };
        let sheet = compose(&[tile(1), refused, tile(3)], 2, (16, 8)).expect("a sheet");
        assert_eq!(sheet.dimensions(), (8 + 2 * 24, 8 + 2 * 36));
        let at = |x, y| sheet.get_pixel(x, y).0[0];
        assert_eq!([at(8, 8), at(8 + 24, 8), at(8, 8 + 36)], [1, 255, 3]);
    }
}
