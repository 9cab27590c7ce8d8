//! The truth of a picture bit by bit, for what must not wait for all of it: a window, a page.
//!
//! Pixels are traced coarse first, in the order of [`Tile`]s. What is known of a pixel is at once what [`Truth::new`]
//! says of it: nothing is guessed, and nothing changes later.

use std::sync::Arc;

use rayon::prelude::*;

use crate::sight::{Sight, surface};
use crate::truth::{central_ray, pixel};
use crate::{Eye, Hit, Light, Pixel, Receiver, Tally, Truth, Verdict, World};

mod tile;

pub use tile::Tile;
use tile::{Tiles, stand_ins};

/// The truth of a picture as far as it is traced.
#[derive(Clone, Debug)]
pub struct Progress {
    world: Arc<World>,
    eye: Eye,
    lights: Vec<Light>,
    distance: f64,
    /// Those to come.
    tiles: Tiles,
    /// What the eye meets, in the order of tracing. Receivers follow from it, and are three times as large.
    hits: Vec<Option<Hit>>,
    /// The pixels of each light, in the order of the picture.
    pixels: Vec<Vec<Option<Pixel>>>,
}

impl Progress {
    /// Makes a picture's truth of which nothing is traced yet. Surfaces deeper than `distance` metres are not judged.
    pub fn new(world: Arc<World>, eye: Eye, lights: Vec<Light>, distance: f64) -> Self {
        let count = eye.width as usize * eye.height as usize;
        let tiles = Tiles::new(eye.width, eye.height, lights.len());
        let pixels = vec![vec![None; count]; lights.len()];
        Self { world, eye, lights, distance, tiles, hits: Vec::with_capacity(count), pixels }
    }

    /// Traces tile after tile, each on all cores, until `enough` returns true; it is asked after each tile, so at least one
    /// is traced unless all are. Returns the tiles that were traced.
    pub fn advance(&mut self, mut enough: impl FnMut() -> bool) -> Vec<Tile> {
        let mut traced = Vec::new();
        while let Some(tile) = self.tiles.next() {
            self.trace(&tile);
            traced.push(tile);
            if enough() {
                break;
            }
        }
        traced
    }

    fn trace(&mut self, tile: &Tile) {
        let Self { world, eye, distance, .. } = self;
        let places: Vec<usize> = tile.samples().map(|(x, y)| index(eye, x, y)).collect();
        let sights: Vec<Sight> = places.par_iter().map(|i| Sight::of_pixel(world, eye, *i)).collect();
        for (light, pixels) in self.lights.iter().zip(&mut self.pixels) {
            let truth = |sight: &Sight| pixel(world, light, sight, *distance);
            let traced: Vec<Pixel> = sights.par_iter().map(truth).collect();
            for (i, pixel) in places.iter().zip(traced) {
                pixels[*i] = Some(pixel);
            }
        }
        let hit = |of: Receiver| Hit { distance: of.depth, triangle: of.triangle };
        self.hits.extend(sights.into_iter().map(|sight| sight.receiver.map(hit)));
    }

    /// Returns the share of the picture's pixels that are traced, 0 to 1.
    pub fn traced(&self) -> f64 {
        if self.is_done() { 1.0 } else { self.hits.len() as f64 / self.count() as f64 }
    }

    /// Whether every pixel is traced.
    pub fn is_done(&self) -> bool {
        self.hits.len() == self.count()
    }

    /// Returns what is true of each pixel by one of the lights; `None` where it is not traced yet.
    ///
    /// # Panics
    /// When there is no such light.
    pub fn pixels(&self, light: usize) -> &[Option<Pixel>] {
        &self.pixels[light]
    }

    /// Whether a share of any of the lights reaches a pixel that is traced.
    ///
    /// # Panics
    /// When there is no such pixel.
    pub fn is_partial(&self, pixel: usize) -> bool {
        self.pixels.iter().any(|pixels| matches!(pixels[pixel], Some(Pixel::Partial(_))))
    }

    /// Returns the traced pixel that stands for a pixel: itself, or the nearest upper left one of a pass before. `None`
    /// where there is none yet.
    pub fn stand_in(&self, pixel: usize) -> Option<usize> {
        let (x, y) = ((pixel % self.eye.width as usize) as u32, (pixel / self.eye.width as usize) as u32);
        let is_traced = |i: &usize| self.pixels.first().is_some_and(|pixels| pixels[*i].is_some());
        stand_ins(x, y).map(|(x, y)| index(&self.eye, x, y)).find(is_traced)
    }

    /// Compares a result with the truth at a pixel, given each light's visibility of every pixel. Several lights are
    /// joined by [`Verdict::of_lights`].
    ///
    /// # Panics
    /// When there is no such pixel, or a visibility is missing.
    pub fn verdict(&self, visibility: &[&[f32]], pixel: usize) -> Verdict {
        let of_light = |i: usize| Verdict::new(self.pixels[i][pixel], visibility[i][pixel]);
        Verdict::of_lights((0..self.lights.len()).map(of_light))
    }

    /// Counts how often a result is wrong so far, all lights together, given each light's visibility of every pixel.
    ///
    /// All traced pixels count the same. While a pass is under way there are more of them in the picture's middle, and
    /// shares lean to what it shows; after each pass they are spread evenly.
    ///
    /// # Panics
    /// When there is not one visibility for each light and pixel.
    pub fn tally(&self, visibility: &[&[f32]]) -> Tally {
        self.tally_at(0..self.count(), visibility)
    }

    /// Counts as [`Self::tally`], but only the pixels that were traced with one tile: the tallies of all tiles add up to
    /// that of the picture.
    ///
    /// # Panics
    /// When there is not one visibility for each light and pixel, or the tile is none of this picture's.
    pub fn tally_of(&self, tile: &Tile, visibility: &[&[f32]]) -> Tally {
        self.tally_at(tile.samples().map(|(x, y)| self.index(x, y)), visibility)
    }

    fn tally_at(&self, places: impl Iterator<Item = usize> + Clone, visibility: &[&[f32]]) -> Tally {
        assert_eq!(visibility.len(), self.pixels.len(), "one picture of visibility a light");
        let mut tally = Tally::default();
        for (pixels, visibility) in self.pixels.iter().zip(visibility) {
            assert_eq!(visibility.len(), pixels.len(), "one visibility a pixel");
            places.clone().for_each(|i| tally.count(pixels[i], visibility[i]));
        }
        tally
    }

    /// Returns what [`Truth::new`] gives for each light, bit for bit, once all is traced; `None` before. It puts the whole
    /// picture together, which takes longer than a frame.
    pub fn truths(&self) -> Option<Vec<Truth>> {
        if !self.is_done() {
            return None;
        }
        let mut receivers = vec![None; self.count()];
        let order = Tiles::new(self.eye.width, self.eye.height, self.lights.len());
        for ((x, y), hit) in order.flat_map(|tile| tile.samples()).zip(&self.hits) {
            let i = index(&self.eye, x, y);
            receivers[i] = hit.map(|hit| surface(&self.world, &central_ray(&self.eye, i), hit));
        }
        let of_light = |(light, pixels): (&Light, &Vec<Option<Pixel>>)| {
            let pixels = pixels.iter().copied().collect::<Option<_>>()?;
            Some(Truth { eye: self.eye, light: *light, receivers: receivers.clone(), pixels })
        };
        self.lights.iter().zip(&self.pixels).map(of_light).collect()
    }

    /// Returns the index of the pixel in column `x` and row `y`, both counted from the upper left corner.
    pub fn index(&self, x: u32, y: u32) -> usize {
        index(&self.eye, x, y)
    }

    fn count(&self) -> usize {
        self.eye.width as usize * self.eye.height as usize
    }
}

/// Which pixel of the picture it is, row by row.
fn index(eye: &Eye, x: u32, y: u32) -> usize {
    y as usize * eye.width as usize + x as usize
}
