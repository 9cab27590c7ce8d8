//! What texels hold that show nothing: the mean of their neighbours, so that bilinear reading at the border of a chart reads
//! what is beside it.

use rayon::prelude::*;

use super::rays::EMPTY;
use super::unwrap::GUTTER_TEXELS;

/// Fills the empty texels of a page that are near others, and makes of all of them visibility in 255ths; what stays empty is 0.
pub(super) fn filled(mut page: Vec<u8>, width: usize) -> Vec<u8> {
    for _ in 0..GUTTER_TEXELS {
        page = (0..page.len()).into_par_iter().with_min_len(4096).map(|i| grown(&page, width, i)).collect();
    }
    page.par_iter_mut().for_each(|texel| {
        let share = f32::from(texel.saturating_sub(1)) / 254.0;
        *texel = (255.0 * share).round() as u8;
    });
    page
}

/// A texel, or the mean of those around it that are not empty.
fn grown(page: &[u8], width: usize, texel: usize) -> u8 {
    if page[texel] != EMPTY {
        return page[texel];
    }
    let (x, y) = (texel % width, texel / width);
    let columns = x.saturating_sub(1)..(x + 2).min(width);
    let rows = y.saturating_sub(1)..(y + 2).min(page.len() / width);
    let around = rows.flat_map(|row| &page[row * width..][columns.clone()]);
    let (mut sum, mut count) = (0u32, 0u32);
    for value in around.filter(|value| **value != EMPTY) {
        sum += u32::from(*value);
        count += 1;
    }
    (sum + count / 2).checked_div(count).map_or(EMPTY, |mean| mean as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn empty_texels_take_the_mean_of_their_neighbours_as_far_as_the_gutter_reaches() {
        let page = filled(vec![0, 1, 255, 0, 0, 0], 6);
        assert_eq!(page, [0, 0, 255, 255, 255, 0]);
        let between = filled(vec![1, 0, 255], 3);
        assert_eq!(between, [0, 128, 255]);
    }
}
