//! The alpha of a picture between its pixels: bilinear, at its full size, as if it were repeated for ever.
//!
//! Space: u right and v down, the whole picture from 0 to 1, pixels' centres at halves.

/// Filters may know where they are between two pixels to 8 bits only (`subTexelPrecisionBits` of Vulkan, and the least that
/// Direct3D wants), which cuts or rounds: at most so much off, pixels.
const WEIGHT_STEP: f64 = 1.0 / 256.0;

/// Filters may round the alpha between pixels to 8 bits, once for each axis: at most so much off.
const FILTERED_STEP: f64 = 2.0 / 255.0;

/// The share of the largest of its corners' by which f32 may have moved a texture coordinate: sixteen roundings.
const MOVED: f64 = 8.0 * f32::EPSILON as f64;

/// The alpha of a picture, 8 bits each, in rows from top to bottom.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AlphaPicture {
    pub width: u32,
    pub height: u32,
    pub alpha: Vec<u8>,
}

impl AlphaPicture {
    /// The alpha at a place.
    pub fn value(&self, [u, v]: [f64; 2]) -> f64 {
        let (x, y) = self.place(u, v);
        self.between(x, y)
    }

    /// The least and the most that a filter may make of the alpha at a place. `largest` is the largest coordinate of the
    /// triangle's corners.
    pub fn drawn(&self, [u, v]: [f64; 2], largest: f64) -> [f64; 2] {
        let reach = |size: u32| WEIGHT_STEP + MOVED * largest * f64::from(size);
        let reaches = [reach(self.width), reach(self.height)];
        if reaches.iter().any(|reach| *reach > 0.5) {
            return [0.0, 1.0];
        }
        // Between lines of pixels' centres it is bilinear: the extremes lie on them, or at the ends.
        let ends = |at: f64, reach: f64| {
            let (low, high) = (at - reach, at + reach);
            [low, low.ceil().min(high), high]
        };
        let (x, y) = self.place(u, v);
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for y in ends(y, reaches[1]) {
            for x in ends(x, reaches[0]) {
                let alpha = self.between(x, y);
                (least, most) = (least.min(alpha), most.max(alpha));
            }
        }
        if least == most {
            return [least, most];
        }
        [(least - FILTERED_STEP).max(0.0), (most + FILTERED_STEP).min(1.0)]
    }

    /// A place in pixels from the first one's centre.
    fn place(&self, u: f64, v: f64) -> (f64, f64) {
        (u * f64::from(self.width) - 0.5, v * f64::from(self.height) - 0.5)
    }

    /// The bilinear alpha at a place, given in pixels from the first one's centre.
    fn between(&self, x: f64, y: f64) -> f64 {
        let (left, top) = (x.floor(), y.floor());
        let pixel = |x: f64, y: f64| {
            let wrapped = |at: f64, size: u32| at.rem_euclid(f64::from(size)) as usize % size as usize;
            let index = wrapped(y, self.height) * self.width as usize + wrapped(x, self.width);
            f64::from(self.alpha[index])
        };
        let row = |y: f64| {
            let (a, b) = (pixel(left, y), pixel(left + 1.0, y));
            a + (b - a) * (x - left)
        };
        let (upper, lower) = (row(top), row(top + 1.0));
        (upper + (lower - upper) * (y - top)) / 255.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two by two pixels: 0 and 1 above 1 and 0.2.
    fn picture() -> AlphaPicture {
        AlphaPicture { width: 2, height: 2, alpha: vec![0, 255, 255, 51] }
    }

    fn at(u: f64, v: f64) -> f64 {
        picture().value([u, v])
    }

    #[test]
    fn centres_are_at_halves_and_between_them_it_is_bilinear() {
        assert_eq!([at(0.25, 0.25), at(0.75, 0.25), at(0.25, 0.75), at(0.75, 0.75)], [0.0, 1.0, 1.0, 0.2]);
        assert_eq!([at(0.5, 0.25), at(0.25, 0.375)], [0.5, 0.25]);
        assert!((at(0.5, 0.5) - 0.55).abs() < 1e-12, "the mean of all four");
    }

    #[test]
    fn it_repeats_for_ever() {
        assert_eq!([at(0.0, 0.25), at(1.0, 0.25)], [0.5; 2], "between the last and the first");
        for (u, v) in [(0.3, 0.6), (0.0, 0.99), (0.51, 0.01)] {
            for (across, down) in [(1.0, 0.0), (-3.0, 2.0), (0.0, -1.0)] {
                assert!((at(u, v) - at(u + across, v + down)).abs() < 1e-12, "{u} {v} {across} {down}");
            }
        }
    }

    #[test]
    fn what_filters_can_make_of_it_is_bounded() {
        let [least, most] = picture().drawn([0.5, 0.25], 1.0);
        // A step of 1/256 pixel, and two of 1/255, each way; a step down the picture changes nothing there.
        let reach = WEIGHT_STEP + FILTERED_STEP;
        assert!(
            (least - (0.5 - reach)).abs() < 2e-3 && (most - (0.5 + reach)).abs() < 2e-3,
            "{least} {most}"
        );
        let flat = AlphaPicture { width: 1, height: 1, alpha: vec![51] };
        assert_eq!((flat.value([0.3, -7.0]), flat.drawn([0.3, -7.0], 9.0)), (0.2, [0.2; 2]));
        assert_eq!(picture().drawn([1e9, 0.0], 1e9), [0.0, 1.0], "f32 does not know where that is");
    }
}
