//! In which order do the texels of a dither appear, as coverage grows from 0 to 1?
//!
//! As evenly as can be at every coverage: a void-and-cluster array (Ulichney, *The Void-and-Cluster Method for Dither Array
//! Generation*, 1993), whose unevenness is too fine for filters of a few texels to see. Each caster sees it shifted, turned and
//! mirrored by its number, so that the texels of two casters have nothing to do with each other. `shaders/caster/covers.wgsl` reads it.

use std::sync::LazyLock;

use glam::UVec4;

/// Texels a side of the array, which repeats.
const SIDE: usize = 32;
const COUNT: usize = SIDE * SIDE;

/// The levels of all texels, 8 bits each, row by row, as the frame holds them.
pub(crate) type Levels = [[UVec4; SIDE / 16]; SIDE];

/// The level, from 0 to 255, of a texel of a light's lattice for a caster: the caster is drawn in the texel where its coverage
/// exceeds (level + ½) / 256. Mirrors `umbrage_lattice_level` of the shaders; for lattices see
/// [`ShadowView::lattice`](umbrage_core::ShadowView::lattice).
pub fn lattice_level(texel: [u32; 2], id: u32) -> u32 {
    let turn = pcg(id);
    let [x, y] = texel;
    let (x, y) = if turn & 1024 == 0 { (x, y) } else { (y, x) };
    let last = SIDE as u32 - 1;
    let mirrored = |bit: u32| 0u32.wrapping_sub((turn >> bit) & 1);
    let x = (x.wrapping_add(turn) ^ mirrored(11)) & last;
    let y = (y.wrapping_add(turn >> 5) ^ mirrored(12)) & last;
    u32::from(ORDER[y as usize * SIDE + x as usize] / 4)
}

/// What the frame holds.
pub(crate) fn levels() -> Levels {
    *LEVELS
}

static LEVELS: LazyLock<Levels> = LazyLock::new(|| {
    let level = |place: usize| u32::from(ORDER[place] / 4);
    let word = |place| (0..4).map(|byte| level(place + byte) << (8 * byte)).sum();
    let words = |place| UVec4::from_array(std::array::from_fn(|lane| word(place + 4 * lane)));
    std::array::from_fn(|y| std::array::from_fn(|part| words(y * SIDE + part * 16)))
});

/// The place of each texel in the order in which they appear.
static ORDER: LazyLock<[u16; COUNT]> = LazyLock::new(order);

/// `umbrage_pcg` of the shaders.
fn pcg(value: u32) -> u32 {
    let state = value.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// Texels that are there, and how crowded it is at each: in whole numbers, so that every machine finds the same order.
#[derive(Clone)]
struct Crowd {
    is_there: [bool; COUNT],
    crowding: [u64; COUNT],
}

impl Crowd {
    /// Adds a texel, or takes it away. It crowds others by 2^(−d²/2) at distance d: a Gaussian of 1.2 texels.
    fn set(&mut self, texel: usize, is_there: bool) {
        self.is_there[texel] = is_there;
        let (x, y) = (texel % SIDE, texel / SIDE);
        for (aside, below) in (0..13).flat_map(|aside| (0..13).map(move |below| (aside, below))) {
            let squared = (aside as i32 - 6).pow(2) + (below as i32 - 6).pow(2);
            // √½ of a power of two, where the exponent is odd.
            let whole = if squared % 2 == 0 { 1u64 << 40 } else { 777_472_127_994 };
            let crowding = whole >> (squared / 2);
            let at = (y + SIDE + below - 6) % SIDE * SIDE + (x + SIDE + aside - 6) % SIDE;
            self.crowding[at] = match is_there {
                true => self.crowding[at] + crowding,
                false => self.crowding[at] - crowding,
            };
        }
    }

    /// The most crowded texel of those that are there.
    fn tightest(&self) -> usize {
        (0..COUNT).filter(|i| self.is_there[*i]).max_by_key(|i| self.crowding[*i]).unwrap_or_default()
    }

    /// The least crowded place of those where none is.
    fn emptiest(&self) -> usize {
        (0..COUNT).filter(|i| !self.is_there[*i]).min_by_key(|i| self.crowding[*i]).unwrap_or_default()
    }
}

/// The order of the texels.
fn order() -> [u16; COUNT] {
    const FIRST: usize = COUNT / 10;
    let mut start = Crowd { is_there: [false; COUNT], crowding: [0; COUNT] };
    for texel in (0..).map(|i| pcg(i) as usize % COUNT) {
        if start.is_there.iter().filter(|is_there| **is_there).count() == FIRST {
            break;
        }
        if !start.is_there[texel] {
            start.set(texel, true);
        }
    }
    // Some texels at random, moved apart until each is where it is emptiest.
    loop {
        let moved = start.tightest();
        start.set(moved, false);
        let to = start.emptiest();
        start.set(to, true);
        if to == moved {
            break;
        }
    }
    let mut order = [0; COUNT];
    let mut fewer = start.clone();
    for place in (0..FIRST).rev() {
        let texel = fewer.tightest();
        fewer.set(texel, false);
        order[texel] = place as u16;
    }
    for place in FIRST..COUNT {
        let texel = start.emptiest();
        start.set(texel, true);
        order[texel] = place as u16;
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where a coverage draws, of 64 × 64 texels.
    fn drawn(id: u32, coverage: f64) -> Vec<bool> {
        let texel = |i: u32| f64::from(lattice_level([i % 64, i / 64], id)) + 0.5 < 256.0 * coverage;
        (0..64 * 64).map(texel).collect()
    }

    fn share(drawn: impl IntoIterator<Item = bool>) -> f64 {
        let (count, of) = drawn.into_iter().fold((0, 0), |(count, of), is| (count + u32::from(is), of + 1));
        f64::from(count) / f64::from(of)
    }

    #[test]
    fn every_level_is_as_frequent_and_each_caster_sees_all() {
        for id in [0, 1, 2, 77, 1 << 16, u32::MAX] {
            let mut counts = [0; 256];
            for i in 0..COUNT as u32 {
                counts[lattice_level([i % 32 + 1000, u32::MAX - i / 32], id) as usize] += 1;
            }
            assert_eq!(counts, [4; 256], "caster {id}");
        }
    }

    #[test]
    fn a_coverage_draws_its_share_of_any_few_texels() {
        for id in 0..8 {
            for sixteenths in 0..=16 {
                let coverage = f64::from(sixteenths) / 16.0;
                let drawn = drawn(id, coverage);
                assert!((share(drawn.iter().copied()) - coverage).abs() < 1e-9);
                for corner in (0..48).flat_map(|x| (0..48).map(move |y| y * 64 + x)) {
                    let share = share((0..256).map(|i| drawn[corner + i / 16 * 64 + i % 16]));
                    assert!((share - coverage).abs() < 1.0 / 16.0, "{share} of 16 × 16 for {coverage}");
                }
            }
        }
    }

    #[test]
    fn casters_behind_one_another_let_through_the_product() {
        let mut worst: f64 = 0.0;
        for first in 0..30 {
            for second in first + 1..30 {
                let (a, b) = (drawn(first, 0.5), drawn(second, 0.5));
                let through = share(a.iter().zip(&b).map(|(a, b)| !a && !b));
                worst = worst.max((through - 0.25).abs());
            }
        }
        println!("{worst}");
        assert!(worst < 0.05, "0.25 of the light should get through, and {worst} more or less does");
    }
}
