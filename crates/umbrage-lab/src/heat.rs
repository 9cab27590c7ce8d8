//! Where a picture's shadows are wrong, and in which direction: the picture in dim grey, under two colours.
//!
//! The colours are Okabe and Ito's (*Color Universal Design*, 2008), a shade deeper: people of every kind of colour vision
//! tell orange from blue, and both from grey.

use umbrage_judge::Verdict;

/// The colour of what is falsely shadowed, as sRGB.
pub const FALSE_SHADOW: [u8; 3] = [230, 120, 0];

/// The colour of what is falsely lit, as sRGB.
pub const FALSE_LIGHT: [u8; 3] = [0, 90, 200];

/// The picture's own grey, from black to white: bright enough to tell its shadows from what is not judged, and dim enough
/// for both colours to stand out from it.
const GREYS: [u32; 2] = [60, 160];

/// How much darker what is not judged is.
const NOT_JUDGED_DIVISOR: u32 = 3;

/// Makes a heat map, as RGBA bytes, of a picture of RGBA bytes and a verdict on each of its pixels. Where one has more
/// pixels than the other, these are left out.
pub fn heat_map(shaded: &[u8], verdicts: &[Verdict]) -> Vec<u8> {
    let (pixels, _) = shaded.as_chunks::<4>();
    pixels
        .iter()
        .zip(verdicts)
        .flat_map(|([red, green, blue, _], verdict)| {
            let grey = dim_grey(*red, *green, *blue);
            let [red, green, blue] = match verdict {
                Verdict::NotTraced | Verdict::NotJudged => [(grey / NOT_JUDGED_DIVISOR) as u8; 3],
                Verdict::Right => [grey as u8; 3],
                Verdict::FalseShadow => FALSE_SHADOW,
                Verdict::FalseLight => FALSE_LIGHT,
            };
            [red, green, blue, 255]
        })
        .collect()
}

/// Luma by the weights of Rec. 709, of 256, within [`GREYS`].
fn dim_grey(red: u8, green: u8, blue: u8) -> u32 {
    let luma = (54 * u32::from(red) + 183 * u32::from(green) + 19 * u32::from(blue)) / 256;
    let [black, white] = GREYS;
    black + luma * (white - black) / 255
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_of_pixel_has_its_colour() {
        use Verdict::{FalseLight, FalseShadow, NotJudged, Right};
        let white = [255; 16];
        let map = heat_map(&white, &[NotJudged, Right, FalseShadow, FalseLight]);
        assert_eq!(map, [53, 53, 53, 255, 160, 160, 160, 255, 230, 120, 0, 255, 0, 90, 200, 255]);
    }

    #[test]
    fn a_picture_and_judgements_of_different_lengths_make_the_shorter_map() {
        assert_eq!(heat_map(&[255; 8], &[Verdict::Right]).len(), 4);
        assert_eq!(heat_map(&[], &[Verdict::Right]).len(), 0);
    }
}
