//! What a material library says of coverage: `d`, `Tr` and `map_d`, as a material's alpha.
//!
//! The format knows no cut-off, and no mask: a picture of coverage that is nearly black and white makes one, since that is
//! what leaves and fences are, and any other blends. A picture's own alpha counts for nothing but in `map_d`.

use std::collections::HashMap;

use super::picture_options::{Channel, Picture};
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::pictures;
use crate::{Alpha, Material, Texture};

/// Half: the cut-off of a mask.
const CUTOFF: f32 = 0.5;

/// A picture of coverage is a mask where no more than this share of its pixels ...
const BETWEEN_SHARE: f64 = 0.2;

/// ... is farther from black and from white than this, of 255: edges of drawn leaves are soft.
const NEARLY: u8 = 32;

/// The pictures with coverage in their alpha that were made so far, by the index of the picture of colours and by what the
/// coverage was read from.
#[derive(Debug, Default)]
pub(super) struct Combined(HashMap<Key, Option<(usize, bool)>>);

/// The pictures of colours and of coverage by their numbers, the channel, and the bits of what is added and multiplied.
type Key = (Option<usize>, usize, Channel, [u32; 2]);

/// The material's coverage by a number alone, 0 to 1.
pub(super) fn by_number(material: &mut Material, dissolve: f32) {
    material.base_colour.w = if dissolve > 1.0 { 1.0 } else { dissolve.max(0.0) };
    if material.base_colour.w < 1.0 {
        material.alpha = Alpha::Blend;
    }
}

/// Gives a material the coverage that a picture shows, which is given with its number: in the alpha of its colours, or of
/// white where it has no picture of those. A picture that covers all changes nothing.
pub(super) fn by_picture(
    material: &mut Material,
    picture: &Picture,
    (number, mask): (usize, &Texture),
    textures: &mut Vec<Texture>,
    combined: &mut Combined,
    budget: &mut Budget,
) -> Result<(), Fault> {
    let gain = [picture.base.to_bits(), picture.gain.to_bits()];
    let key = (material.texture, number, picture.channel, gain);
    let made = match combined.0.get(&key) {
        Some(made) => *made,
        None => {
            let made = combine(material.texture.map(|i| &textures[i]), picture, mask, budget)?;
            let made = made.map(|(texture, is_mask)| {
                textures.push(texture);
                (textures.len() - 1, is_mask)
            });
            combined.0.insert(key, made);
            made
        }
    };
    if let Some((texture, is_mask)) = made {
        material.texture = Some(texture);
        let is_binary = is_mask && material.base_colour.w >= 1.0;
        material.alpha = if is_binary { Alpha::Mask { cutoff: CUTOFF } } else { Alpha::Blend };
    }
    Ok(())
}

/// Colours with coverage as their alpha, and whether that is a mask; `None` where all is covered. It is as large as the
/// larger picture, on each axis.
fn combine(
    colours: Option<&Texture>,
    picture: &Picture,
    mask: &Texture,
    budget: &mut Budget,
) -> Result<Option<(Texture, bool)>, Fault> {
    let coverage = coverage(picture, mask);
    if coverage.iter().all(|covered| *covered == u8::MAX) {
        return Ok(None);
    }
    let between = coverage.iter().filter(|covered| (NEARLY..=u8::MAX - NEARLY).contains(*covered)).count();
    let is_mask = between as f64 <= BETWEEN_SHARE * coverage.len() as f64;
    let white = Texture { name: mask.name.clone(), width: 1, height: 1, rgba: vec![u8::MAX; 4] };
    let colours = colours.unwrap_or(&white);
    let (width, height) = (colours.width.max(mask.width), colours.height.max(mask.height));
    budget.pixels(width, height)?;
    let covered: Vec<[u8; 1]> = coverage.into_iter().map(|covered| [covered]).collect();
    let covered = pictures::resized(&covered, (mask.width, mask.height), (width, height));
    let (colour, _) = colours.rgba.as_chunks::<4>();
    let mut rgba = pictures::resized(colour, (colours.width, colours.height), (width, height)).into_owned();
    for (pixel, [covered]) in rgba.iter_mut().zip(covered.iter()) {
        pixel[3] = *covered;
    }
    let name = format!("{} with {}", colours.name, mask.name);
    let name = if colours.name == mask.name { mask.name.clone() } else { name };
    Ok(Some((Texture { name, width, height, rgba: rgba.into_flattened() }, is_mask)))
}

/// The coverage that a picture shows, pixel by pixel.
fn coverage(picture: &Picture, mask: &Texture) -> Vec<u8> {
    let (pixels, _) = mask.rgba.as_chunks::<4>();
    let has_alpha = pixels.iter().any(|pixel| pixel[3] < u8::MAX);
    let value = |[red, green, blue, alpha]: [u8; 4]| match picture.channel {
        Channel::Red => red,
        Channel::Green => green,
        Channel::Blue => blue,
        Channel::Matte => alpha,
        Channel::Any if has_alpha => alpha,
        Channel::Any | Channel::Luminance => luminance(red, green, blue),
    };
    let scaled = |value: u8| {
        let scaled = f32::from(value) * picture.gain + 255.0 * picture.base;
        scaled.round().clamp(0.0, 255.0) as u8
    };
    pixels.iter().map(|pixel| scaled(value(*pixel))).collect()
}

/// By the weights of Rec. 709, of 256; greys stay as they are.
fn luminance(red: u8, green: u8, blue: u8) -> u8 {
    ((54 * u32::from(red) + 183 * u32::from(green) + 19 * u32::from(blue)) / 256) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texture(width: u32, height: u32, pixels: &[[u8; 4]]) -> Texture {
        Texture { name: "m".to_owned(), width, height, rgba: pixels.concat() }
    }

    fn picture(text: &str) -> Picture {
        Picture::read(&format!("{text} m.png")).unwrap()
    }

    fn alphas(colours: Option<&Texture>, text: &str, mask: &Texture) -> Option<(Vec<u8>, bool)> {
        let made = combine(colours, &picture(text), mask, &mut Budget::new()).unwrap();
        made.map(|(texture, is_mask)| (texture.rgba.iter().skip(3).step_by(4).copied().collect(), is_mask))
    }

    #[test]
    fn coverage_is_alpha_where_there_is_some_and_grey_where_not() {
        let grey = texture(2, 1, &[[0, 0, 0, 255], [255; 4]]);
        assert_eq!(alphas(None, "", &grey), Some((vec![0, 255], true)));
        let clear = texture(2, 1, &[[255, 255, 255, 0], [9, 9, 9, 255]]);
        assert_eq!(alphas(None, "", &clear), Some((vec![0, 255], true)));
        assert_eq!(alphas(None, "-imfchan l", &clear), Some((vec![255, 9], true)));
        assert_eq!(alphas(None, "-mm 1 -1", &grey), Some((vec![255, 0], true)), "inverted");
        let red = texture(1, 1, &[[200, 0, 100, 255]]);
        let of = |channel: &str| alphas(None, channel, &red).map(|(alphas, _)| alphas[0]);
        assert_eq!([of("-imfchan r"), of("-imfchan g"), of("-imfchan b")], [Some(200), Some(0), Some(100)]);
        assert_eq!(of("-imfchan m"), None, "all is covered");
    }

    #[test]
    fn greys_between_make_no_mask() {
        let ramp =
            |inner: u8| texture(4, 1, &[[0, 0, 0, 255], [inner, inner, inner, 255], [255; 4], [255; 4]]);
        assert_eq!(alphas(None, "", &ramp(100)).map(|(_, is_mask)| is_mask), Some(false));
        assert_eq!(alphas(None, "", &ramp(240)).map(|(_, is_mask)| is_mask), Some(true));
    }

    #[test]
    fn pictures_of_other_sizes_are_resampled_to_the_larger_on_each_axis() {
        let colours = texture(1, 4, &[[1, 2, 3, 0]; 4]);
        let mask = texture(2, 1, &[[0, 0, 0, 255], [255; 4]]);
        let (made, _) = combine(Some(&colours), &picture(""), &mask, &mut Budget::new()).unwrap().unwrap();
        assert_eq!((made.width, made.height), (2, 4));
        assert_eq!(made.rgba, [[1, 2, 3, 0], [1, 2, 3, 255]].repeat(4).concat());
    }

    #[test]
    fn what_finds_no_room_is_a_fault() {
        let mut budget = Budget::new();
        budget.pixels(1 << 14, 1 << 14).unwrap();
        let mask = texture(1, 1, &[[0; 4]]);
        combine(None, &picture(""), &mask, &mut budget).unwrap_err();
    }
}
