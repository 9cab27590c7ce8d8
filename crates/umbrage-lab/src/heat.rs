//! Where a picture's shadows are wrong, and which way: the picture in dim grey, under two colours.
//!
//! The colours are Okabe and Ito's (*Color Universal Design*, 2008), a shade deeper: people of every kind of colour vision
//! tell orange from blue, and both from grey.

/// What is falsely shadowed.
pub const FALSE_SHADOW: [u8; 3] = [230, 120, 0];

/// What is falsely lit.
pub const FALSE_LIGHT: [u8; 3] = [0, 90, 200];

/// The picture's own grey, from black to white: bright enough to tell its shadows from what is not judged, and dim enough
/// for both colours to stand out from it.
const GREYS: [u32; 2] = [60, 160];

/// How much darker what is not judged is.
const NOT_JUDGED_DIVISOR: u32 = 3;

/// What a pixel's shadow is, against the truth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrongness {
    /// The pixel is left out: sky, a surface turned away, or a truth that depends on rounding.
    NotJudged,
    /// As it should be.
    Right,
    /// Shadowed, and should be lit.
    FalseShadow,
    /// Lit, and should be shadowed.
    FalseLight,
}

/// A picture of RGBA bytes, from one of RGBA bytes and a judgement of each of its pixels. What one of them has more pixels
/// of than the other is left out.
pub fn heat_map(shaded: &[u8], wrongness: &[Wrongness]) -> Vec<u8> {
    let (pixels, _) = shaded.as_chunks::<4>();
    pixels
        .iter()
        .zip(wrongness)
        .flat_map(|([red, green, blue, _], wrong)| {
            let grey = dim_grey(*red, *green, *blue);
            let [red, green, blue] = match wrong {
                Wrongness::NotJudged => [(grey / NOT_JUDGED_DIVISOR) as u8; 3],
                Wrongness::Right => [grey as u8; 3],
                Wrongness::FalseShadow => FALSE_SHADOW,
                Wrongness::FalseLight => FALSE_LIGHT,
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
        use Wrongness::{FalseLight, FalseShadow, NotJudged, Right};
        let white = [255; 16];
        let map = heat_map(&white, &[NotJudged, Right, FalseShadow, FalseLight]);
        assert_eq!(map, [53, 53, 53, 255, 160, 160, 160, 255, 230, 120, 0, 255, 0, 90, 200, 255]);
    }

    #[test]
    fn a_picture_and_judgements_of_different_lengths_make_the_shorter_map() {
        assert_eq!(heat_map(&[255; 8], &[Wrongness::Right]).len(), 4);
        assert_eq!(heat_map(&[], &[Wrongness::Right]).len(), 0);
    }
}
