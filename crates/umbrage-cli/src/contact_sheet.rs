//! A contact sheet of an experiment: the part of a world's picture that its page enlarges, a tile for each variant and one
//! with exact shadows, in a row of its own from each camera.

use std::path::Path;

use anyhow::Context as _;
use image::codecs::png::{CompressionType, FilterType as PngFilterType, PngEncoder};
use image::imageops::FilterType;
use image::{DynamicImage, RgbaImage};
use umbrage_lab::tabulate::{Group, groups};
use umbrage_lab::{Experiment, Row, files};

use crate::label::Sheet;

/// Tiles a row; more go on in the next.
const ACROSS: u32 = 6;
/// The longer side of a tile, pixels, or somewhat less: parts are enlarged by whole numbers.
const SIDE: u32 = 224;
/// White around tiles.
const GAP: u32 = 8;
/// Room for a tile's name above it, and how tall its letters are.
const LINE: u32 = 22;
const LETTERS: f32 = 19.0;

/// Writes a sheet for each world that is enlarged and has pictures: `NAME-WORLD.png` in a folder.
pub fn write(experiment: &Experiment, rows: &[Row], folder: &Path, name: &str) -> anyhow::Result<()> {
    let groups = groups(experiment, rows);
    for (world, part) in &experiment.enlarged {
        let of_world = groups.iter().filter(|group| group.world == world).collect::<Vec<_>>();
        let by_camera = of_world
            .chunk_by(|a, b| a.stands_beside(b))
            .map(|beside| tiles(experiment, beside, *part))
            .collect::<anyhow::Result<Vec<_>>>()
            .with_context(|| format!("a stored picture of {world} cannot be read"))?;
        if by_camera.iter().all(Vec::is_empty) {
            continue;
        }
        let sheet = compose(&by_camera)?;
        let stem = Path::new(world).file_stem().unwrap_or_default().to_string_lossy();
        let path = folder.join(format!("{name}-{stem}.png"));
        let mut png = Vec::new();
        let encoder = PngEncoder::new_with_quality(&mut png, CompressionType::Best, PngFilterType::NoFilter);
        DynamicImage::from(sheet).into_rgb8().write_with_encoder(encoder)?;
        files::write(&path, &png)?;
        eprintln!("contact sheet: {}", path.display());
    }
    Ok(())
}

/// A name, and its part of a picture.
type Tile = (String, RgbaImage);

/// A name and its part of a picture, as large as a tile, for each of some variants that kept a picture, and then for the exact
/// picture that the first was judged by.
fn tiles(experiment: &Experiment, beside: &[&Group<'_>], part: [u32; 4]) -> anyhow::Result<Vec<Tile>> {
    let kept = |group: &Group<'_>| group.rows.iter().find_map(|row| row.outcome.pictures.clone());
    let kept: Vec<_> = beside.iter().filter_map(|group| Some((*group, kept(group)?))).collect();
    let named = |name: String, camera: &str| match experiment.cameras.len() {
        1 => name,
        _ => format!("{name}, {camera}"),
    };
    let drawn =
        kept.iter().map(|(group, pictures)| (named(group.name(experiment), group.camera), &pictures.shaded));
    let exact =
        kept.first().map(|(group, pictures)| (named("exact".to_owned(), group.camera), &pictures.exact));
    drawn.chain(exact).map(|(name, picture)| Ok((name, tile(picture, part)?))).collect()
}

fn tile(picture: &[u8], [left, top, width, height]: [u32; 4]) -> anyhow::Result<RgbaImage> {
    let part = image::load_from_memory(picture)?.crop_imm(left, top, width, height);
    Ok(in_few_colours(&sized(&part)).into_rgba8())
}

/// A picture with its pixels made large, or made small where it is larger than a tile.
fn sized(part: &DynamicImage) -> DynamicImage {
    let longer = part.width().max(part.height());
    match SIDE / longer.max(1) {
        0 => part.resize(SIDE, SIDE, FilterType::Triangle),
        times => part.resize_exact(part.width() * times, part.height() * times, FilterType::Nearest),
    }
}

/// 64 steps a channel: what a JPEG has added is rounded away, and a sheet is half as large.
fn in_few_colours(picture: &DynamicImage) -> DynamicImage {
    const STEP: u8 = 4;
    let mut picture = picture.to_rgb8();
    for channel in picture.iter_mut() {
        *channel = *channel / STEP * STEP + STEP / 2;
    }
    picture.into()
}

/// Tiles side by side, each under its name, and in rows of their own by each camera.
fn compose(by_camera: &[Vec<Tile>]) -> anyhow::Result<RgbaImage> {
    let all = || by_camera.iter().flatten().map(|(_, tile)| tile);
    let width = GAP + all().map(|tile| tile.width()).max().unwrap_or(0);
    let height = LINE + GAP + all().map(|tile| tile.height()).max().unwrap_or(0);
    let rows: Vec<&[Tile]> = by_camera.iter().flat_map(|tiles| tiles.chunks(ACROSS as usize)).collect();
    let across = rows.iter().map(|row| row.len()).max().unwrap_or(0) as u32;
    let mut sheet = Sheet::new(GAP + across * width, GAP + rows.len() as u32 * height)?;
    for (row, y) in rows.iter().zip((GAP..).step_by(height as usize)) {
        for ((name, tile), x) in row.iter().zip((GAP..).step_by(width as usize)) {
            sheet.write_within(name, x, y, (width - GAP, LETTERS));
            sheet.place(tile, x, y + LINE, tile.width(), tile.height());
        }
    }
    Ok(sheet.image)
}

#[cfg(test)]
mod tests {
    use image::{Rgb, RgbImage};

    use super::*;

    #[test]
    fn a_part_is_enlarged_by_a_whole_number_or_made_as_small_as_a_tile() {
        let size = |width, height| {
            let sized = sized(&RgbImage::from_pixel(width, height, Rgb([9; 3])).into());
            (sized.width(), sized.height())
        };
        assert_eq!(size(112, 63), (224, 126));
        assert_eq!(size(100, 80), (200, 160));
        assert_eq!(size(896, 448), (224, 112));
        assert_eq!(size(1, 500), (1, 224));
    }

    #[test]
    fn tiles_stand_in_rows_under_their_names() {
        let tile = |grey| (String::new(), RgbaImage::from_pixel(16, 8, image::Rgba([grey, grey, grey, 255])));
        let tiles: Vec<_> = (0..7).map(tile).collect();
        let sheet = compose(&[tiles]).expect("a sheet");
        assert_eq!((sheet.width(), sheet.height()), (8 + 6 * 24, 8 + 2 * 38));
        let at = |x, y| sheet.get_pixel(x, y).0[0];
        assert_eq!((at(8 + 24, 8 + 22), at(8, 8 + 38 + 22), at(8 + 24, 8 + 38 + 22)), (1, 6, 255));
    }

    #[test]
    fn each_camera_has_rows_of_its_own() {
        let tile = |grey| (String::new(), RgbaImage::from_pixel(16, 8, image::Rgba([grey, grey, grey, 255])));
        let by_camera: Vec<Vec<_>> = [2, 0, 3].map(|count| (0..count).map(tile).collect()).into();
        let sheet = compose(&by_camera).expect("a sheet");
        assert_eq!((sheet.width(), sheet.height()), (8 + 3 * 24, 8 + 2 * 38), "what has no tile has no row");
        let at = |x, y| sheet.get_pixel(x, y).0[0];
        assert_eq!((at(8 + 24, 8 + 22), at(8 + 48, 8 + 22), at(8 + 48, 8 + 38 + 22)), (1, 255, 2));
    }
}
