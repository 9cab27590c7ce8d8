//! In what order a picture's pixels are traced: pass after pass from coarse to fine, and within a pass tile after tile
//! from the picture's middle outward.
//!
//! A pass has a step, and traces the pixels whose x and y are multiples of it and that no pass before has traced. So a
//! traced pixel is the upper left one of a block of step × step pixels, and stands for it until a finer pass comes.

/// The first pass's step, pixels.
const COARSEST: u32 = 16;

/// The maximum number of rays for a tile, about: a millisecond or two of a slow core, in a world of a million triangles.
const MAX_RAYS: usize = 1024;

/// A tile's minimum side, in steps, however many lights there are: smaller ones would be more to keep than to trace.
const MIN_SIDE: usize = 8;

/// A tile is a part of a picture that is traced at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// The tile's left side, in pixels.
    pub x: u32,
    /// The tile's upper side, in pixels.
    pub y: u32,
    /// The tile's width, in pixels; it ends at the picture's side.
    pub width: u32,
    /// The tile's height, in pixels; it ends at the picture's side.
    pub height: u32,
    /// The distance between traced pixels, in pixels: each stands for a block of `step` × `step`, as far as the picture
    /// goes.
    pub step: u32,
}

impl Tile {
    /// Returns the pixels that are traced with this tile, as x and y. Those of passes before are not among them.
    pub fn samples(&self) -> impl Iterator<Item = (u32, u32)> + Clone + use<> {
        let Self { x, y, width, height, step } = *self;
        let is_new = move |x: u32, y: u32| step == COARSEST || (x | y) & step != 0;
        let row = move |y: u32| (x..x + width).step_by(step as usize).map(move |x| (x, y));
        (y..y + height).step_by(step as usize).flat_map(row).filter(move |(x, y)| is_new(*x, *y))
    }
}

/// The pixel that stands for one, as x and y: from itself to that of the first pass.
pub(crate) fn stand_ins(x: u32, y: u32) -> impl Iterator<Item = (u32, u32)> {
    (0..=COARSEST.ilog2()).map(move |bits| (x >> bits << bits, y >> bits << bits))
}

/// All tiles of a picture, in their order. Each has something to trace.
#[derive(Clone, Debug)]
pub(crate) struct Tiles {
    width: u32,
    height: u32,
    /// The side of a tile, steps.
    side: u32,
    /// That of the next pass, pixels; 0 after the last.
    step: u32,
    /// What is left of this pass.
    pass: std::vec::IntoIter<Tile>,
}

impl Tiles {
    /// Makes the tiles of a picture of `width` × `height` pixels, by so many lights.
    pub fn new(width: u32, height: u32, lights: usize) -> Self {
        // A pixel takes a ray of the eye, and two to each light.
        let side = (MAX_RAYS / (1 + 2 * lights)).isqrt().max(MIN_SIDE) as u32;
        Self { width, height, side, step: COARSEST, pass: Vec::new().into_iter() }
    }

    fn of_pass(&self, step: u32) -> Vec<Tile> {
        let Self { width, height, .. } = *self;
        let side = self.side * step;
        let row = |y: u32| (0..width).step_by(side as usize).map(move |x| (x, y));
        let places = (0..height).step_by(side as usize).flat_map(row);
        let mut tiles: Vec<Tile> = places
            .map(|(x, y)| Tile { x, y, width: side.min(width - x), height: side.min(height - y), step })
            .filter(|tile| tile.samples().next().is_some())
            .collect();
        // Twice the way from the picture's middle to the tile's, so that halves are whole; squared.
        let off = |start: u32, length: u32, whole: u32| {
            (2 * i64::from(start) + i64::from(length) - i64::from(whole)).pow(2)
        };
        tiles.sort_by_key(|tile| off(tile.x, tile.width, width) + off(tile.y, tile.height, height));
        tiles
    }
}

impl Iterator for Tiles {
    type Item = Tile;

    fn next(&mut self) -> Option<Tile> {
        loop {
            match self.pass.next() {
                Some(tile) => return Some(tile),
                None if self.step == 0 => return None,
                None => self.pass = self.of_pass(self.step).into_iter(),
            }
            self.step /= 2;
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn every_pixel_is_traced_once_and_each_pass_paints_the_whole_picture(
            width in 1u32..200, height in 1u32..200, lights in 0usize..17,
        ) {
            let pixels = || (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
            let at = |x: u32, y: u32| (y * width + x) as usize;
            let mut times = vec![0; at(0, height)];
            let mut painted_by = vec![None; at(0, height)];
            for pass in 0..=4 {
                let step = COARSEST >> pass;
                for tile in Tiles::new(width, height, lights).filter(|tile| tile.step == step) {
                    for (x, y) in tile.samples() {
                        prop_assert!((tile.x..tile.x + tile.width).contains(&x), "{:?}", tile);
                        prop_assert!((tile.y..tile.y + tile.height).contains(&y), "{:?}", tile);
                        times[at(x, y)] += 1;
                        for v in y..(y + step).min(height) {
                            painted_by[at(x, v)..at((x + step).min(width), v)].fill(Some((x, y)));
                        }
                    }
                }
                for (x, y) in pixels() {
                    prop_assert_eq!(painted_by[at(x, y)], stand_ins(x, y).nth(4 - pass));
                }
            }
            prop_assert!(times.iter().all(|times| *times == 1), "{:?}", times);
        }
    }

    #[test]
    fn coarse_passes_come_first() {
        let steps: Vec<u32> = Tiles::new(700, 500, 1).map(|tile| tile.step).collect();
        assert!(steps.is_sorted_by(|a, b| a >= b), "{steps:?}");
        assert_eq!((steps.first(), steps.last()), (Some(&16), Some(&1)));
    }

    #[test]
    fn a_tile_is_little_work() {
        for (lights, max) in [(0, 1024), (1, 324), (2, 196), (16, 64)] {
            let samples = Tiles::new(1000, 1000, lights).map(|tile| tile.samples().count()).max();
            assert_eq!(samples, Some(max), "{lights} lights");
        }
    }

    #[test]
    fn a_pass_begins_in_the_middle_and_ends_in_a_corner() {
        // Five by five tiles of 18 × 18 pixels.
        let last_pass: Vec<Tile> = Tiles::new(90, 90, 1).filter(|tile| tile.step == 1).collect();
        let at = |tile: &Tile| (tile.x, tile.y);
        assert_eq!(last_pass.len(), 25);
        assert_eq!(last_pass.first().map(at), Some((36, 36)));
        assert_eq!(last_pass.last().map(at), Some((72, 72)));
    }
}
