//! A picture at another size, at least as large: bilinear, as if it were repeated for ever, which is how textures are read.

use std::borrow::Cow;

/// The picture at a size; the same one where it has that size. Sizes are width and height, pixels.
pub(in crate::import) fn resized<const N: usize>(
    pixels: &[[u8; N]],
    (width, height): (u32, u32),
    (wide, high): (u32, u32),
) -> Cow<'_, [[u8; N]]> {
    if (width, height) == (wide, high) {
        return Cow::Borrowed(pixels);
    }
    let columns: Vec<Between> = (0..wide).map(|x| Between::new(x, wide, width)).collect();
    let mut all = Vec::with_capacity(wide as usize * high as usize);
    for y in 0..high {
        let rows = Between::new(y, high, height);
        let row = |y: usize| &pixels[y * width as usize..][..width as usize];
        let (upper, lower) = (row(rows.first), row(rows.second));
        all.extend(columns.iter().map(|column| {
            let at = |row: &[[u8; N]], i: usize| column.mean(row[column.first][i], row[column.second][i]);
            std::array::from_fn(|i| {
                let (above, below) = (at(upper, i), at(lower, i));
                (above + (below - above) * rows.share).round() as u8
            })
        }));
    }
    Cow::Owned(all)
}

/// Two neighbours, and how near to the second a place between them is, 0 to 1.
struct Between {
    first: usize,
    second: usize,
    share: f32,
}

impl Between {
    /// Where the centre of pixel `i` of `large` lies among `small`.
    fn new(i: u32, large: u32, small: u32) -> Self {
        let at = (f64::from(i) + 0.5) * f64::from(small) / f64::from(large) - 0.5;
        let wrapped = |at: f64| at.rem_euclid(f64::from(small)) as usize % small as usize;
        Self {
            first: wrapped(at.floor()),
            second: wrapped(at.floor() + 1.0),
            share: (at - at.floor()) as f32,
        }
    }

    fn mean(&self, first: u8, second: u8) -> f32 {
        let (first, second) = (f32::from(first), f32::from(second));
        first + (second - first) * self.share
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_of_twice_the_size_lies_between_its_pixels_and_wraps() {
        let wide = resized(&[[0], [100]], (2, 1), (4, 1));
        assert_eq!(*wide, [[25], [25], [75], [75]], "a quarter, and three quarters, of the way");
        assert_eq!(*resized(&[[0], [100]], (1, 2), (1, 4)), *wide, "down as across");
        assert!(matches!(resized(&[[7, 8]], (1, 1), (1, 1)), Cow::Borrowed([[7, 8]])));
        assert_eq!(*resized(&[[7, 8]], (1, 1), (3, 2)), [[7, 8]; 6]);
    }
}
