//! Masks in mip-maps: a mean of alpha lets leaves thin out with distance, or close up. So the alpha of each level is scaled
//! until as much of it passes the cut-off as of the first level.
//!
//! Source: Castaño, *Computing Alpha Mipmaps*, 2010.

/// A picture of up to so many texels is looked at between its texels too, where filtering makes edges.
const FINE_TEXELS: usize = 65_536;

/// So many points a texel and axis are looked at between texels.
const POINTS: u32 = 4;

/// How much of a mask covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Coverage {
    /// The least alpha that covers, 0 to 255.
    cut: u8,
    /// The share that covers, 0 to 1.
    share: f32,
}

impl Coverage {
    /// Measures how much of a picture covers.
    pub fn of(width: u32, height: u32, rgba: &[u8], cut: u8) -> Self {
        let alphas = alphas(width, height, rgba);
        let covering = alphas.iter().filter(|alpha| **alpha >= f32::from(cut)).count();
        Self { cut, share: covering as f32 / alphas.len().max(1) as f32 }
    }

    /// Scales the alpha of a smaller level so that the same share of it covers. A level that is covered nowhere or everywhere
    /// stays as it is.
    pub fn keep(self, width: u32, height: u32, rgba: &mut [u8]) {
        if self.share <= 0.0 || self.share >= 1.0 {
            return;
        }
        let scaled = |scale: f32| -> Vec<u8> {
            let texel = |texel: &[u8; 4]| {
                let [red, green, blue, alpha] = *texel;
                [red, green, blue, (f32::from(alpha) * scale).round().min(255.0) as u8]
            };
            rgba.as_chunks().0.iter().flat_map(texel).collect()
        };
        let share = |scale: f32| Self::of(width, height, &scaled(scale), self.cut).share;
        let (mut low, mut high) = (0.0, MOST_SCALE);
        for _ in 0..STEPS {
            let middle = 0.5 * (low + high);
            if share(middle) < self.share { low = middle } else { high = middle }
        }
        let nearer = |a: f32, b: f32| (share(a) - self.share).abs() <= (share(b) - self.share).abs();
        let best = scaled(if nearer(high, low) { high } else { low });
        rgba.copy_from_slice(&best);
    }
}

/// Alpha is scaled by no more than this, in so many halvings of the range.
const MOST_SCALE: f32 = 16.0;
const STEPS: usize = 12;

/// The alphas of a picture, 0 to 255, as bilinear filtering has them at evenly spread points.
fn alphas(width: u32, height: u32, rgba: &[u8]) -> Vec<f32> {
    let texel = |x: u32, y: u32| f32::from(rgba[((y % height) * width + x % width) as usize * 4 + 3]);
    if (width as usize).saturating_mul(height as usize) > FINE_TEXELS {
        return rgba.iter().skip(3).step_by(4).map(|alpha| f32::from(*alpha)).collect();
    }
    let steps =
        |size: u32| (0..size * POINTS).map(|i| (i / POINTS, (i % POINTS) as f32 / POINTS as f32 + 0.125));
    let mut alphas = Vec::with_capacity((width * height * POINTS * POINTS) as usize);
    for (y, down) in steps(height) {
        for (x, across) in steps(width) {
            let row = |y: u32| texel(x, y) * (1.0 - across) + texel(x + 1, y) * across;
            alphas.push(row(y) * (1.0 - down) + row(y + 1) * down);
        }
    }
    alphas
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::textures::{Numbers, mip_chain};

    /// A leaf of round holes: one in each tile of 16 by 16 texels, here and there beside its middle.
    fn holes(side: u32, radius: f32) -> Vec<u8> {
        let is_open = |i: u32| {
            let tile = i % side / 16 * 7 + i / side / 16 * 13;
            let aside = [tile % 5, tile % 11].map(|aside| aside as f32 - 4.5);
            let (x, y) = ((i % side % 16) as f32 - 7.5, (i / side % 16) as f32 - 7.5);
            (x - 0.8 * aside[0]).hypot(y - 0.4 * aside[1]) < radius
        };
        (0..side * side).flat_map(|i| [90, 140, 60, if is_open(i) { 0 } else { 255 }]).collect()
    }

    #[test]
    fn masks_cover_as_much_in_every_level() {
        for (radius, cut) in [(3.0, 128), (6.0, 128), (7.5, 128), (5.0, 30), (5.0, 200)] {
            let picture = holes(256, radius);
            let share = Coverage::of(256, 256, &picture, cut).share;
            for (width, height, rgba) in &mip_chain(256, 256, &picture, Numbers::Mask(cut))[1..3] {
                let kept = Coverage::of(*width, *height, rgba, cut).share;
                assert!(
                    (kept - share).abs() < 0.03,
                    "radius {radius}, cut {cut}: {share} became {kept} at {width}"
                );
            }
            let thinned = &mip_chain(256, 256, &picture, Numbers::Veil)[3];
            let plain = Coverage::of(thinned.0, thinned.1, &thinned.2, cut).share;
            assert!((plain - share).abs() > 0.1, "without it {share} becomes {plain}");
        }
    }

    #[test]
    fn what_is_all_covered_or_all_open_stays_so() {
        for alpha in [0, 255] {
            let picture: Vec<u8> = [1, 2, 3, alpha].repeat(64);
            for (_, _, rgba) in mip_chain(8, 8, &picture, Numbers::Mask(128)) {
                assert!(rgba.iter().skip(3).step_by(4).all(|a| *a == alpha), "{alpha}");
            }
        }
    }
}
