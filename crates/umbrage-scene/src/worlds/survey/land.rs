//! The land before it is measured: a valley between hills, as heights on an even grid, and what is built into it.
//!
//! Space of this file and its neighbours: that of surveys, metres east, north and up of the middle of the land.

use std::collections::HashMap;

use glam::{Vec2, Vec3};
use noise_functions::{Noise as _, Perlin};

/// The side of the land.
pub(super) const SIDE: f32 = 20_480.0;
/// Cells along the side; a power of two, so that triangles can be halved again and again.
pub(super) const CELLS: usize = 2048;
/// The side of a cell.
pub(super) const CELL: f32 = SIDE / CELLS as f32;

/// How far the ground is kept below a road, so that none of it shows through.
const BED: f32 = 0.35;

/// How far the ground lies at the middle of the stream below the water, and the water below the valley's floor.
const STREAM_DEPTH: f32 = 2.5;
const WATER_BELOW_FLOOR: f32 = 3.5;
/// Half the width of the water.
pub(super) const STREAM_HALF_WIDTH: f32 = 21.0;

/// Heights at the corners of the grid, row by row from the south.
#[derive(Clone, Debug)]
pub(super) struct Land {
    seed: i32,
    heights: Vec<f32>,
    /// Corners that no triangle may leave out.
    kept: Vec<bool>,
}

impl Land {
    /// Hills depend on the seed; the course of the valley does not.
    pub fn new(seed: i32) -> Self {
        let heights = (0..=CELLS)
            .flat_map(|row| (0..=CELLS).map(move |column| corner(column, row)))
            .map(|p| natural(p, seed))
            .collect();
        Self { seed, heights, kept: vec![false; (CELLS + 1) * (CELLS + 1)] }
    }

    /// The height at a corner of the grid, by its number.
    pub fn height_of(&self, index: usize) -> f32 {
        self.heights[index]
    }

    /// Whether a corner must be a corner of triangles.
    pub fn is_kept(&self, index: usize) -> bool {
        self.kept[index]
    }

    /// The height at a place, between the grid's corners; beyond the edge, that of the edge.
    pub fn height(&self, p: Vec2) -> f32 {
        let last = CELLS as f32;
        let [u, v] = [p.x, p.y].map(|along| ((along + SIDE * 0.5) / CELL).clamp(0.0, last));
        let (column, row) = ((u as usize).min(CELLS - 1), (v as usize).min(CELLS - 1));
        let (s, t) = (u - column as f32, v - row as f32);
        let at = |c: usize, r: usize| self.heights[(row + r) * (CELLS + 1) + column + c];
        let south = at(0, 0) + (at(1, 0) - at(0, 0)) * s;
        let north = at(0, 1) + (at(1, 1) - at(0, 1)) * s;
        south + (north - south) * t
    }

    /// The point of the land at a place.
    pub fn at(&self, p: Vec2) -> Vec3 {
        p.extend(self.height(p))
    }

    /// The slopes towards east and north.
    pub fn slopes(&self, p: Vec2) -> Vec2 {
        let rise = |step: Vec2| (self.height(p + step) - self.height(p - step)) / (2.0 * step.length());
        Vec2::new(rise(Vec2::X * 2.0 * CELL), rise(Vec2::Y * 2.0 * CELL))
    }

    /// How much of the ground is under trees, 0 to 1: woods on slopes, none on the valley's floor.
    pub fn wooded(&self, p: Vec2) -> f32 {
        let patches =
            Perlin.fbm(3, 0.5, 2.3).frequency(1.0 / 900.0).seed(self.seed + 5).sample2(p.to_array());
        let above = self.height(p) - floor(p.x);
        smooth(0.0, 0.16, patches) * smooth(14.0, 60.0, above) * (1.0 - smooth(420.0, 560.0, above))
    }

    /// Levels the ground across a road whose middle is `line`.
    pub fn grade(&mut self, line: &[Vec3], half_width: f32) {
        let (flat, end) = (half_width + 4.0, half_width + 20.0);
        self.shape(line, end, |height, middle, away| {
            let weight = 1.0 - smooth(flat, end, away);
            height + (middle - BED - height) * weight
        });
    }

    /// Digs the bed of the stream.
    pub fn dig_stream(&mut self) {
        let line: Vec<Vec3> = stations(stream).map(|p| p.extend(water(p.x))).collect();
        let end = STREAM_HALF_WIDTH + 34.0;
        self.shape(&line, end, |height, water, away| {
            let bank = smooth(STREAM_HALF_WIDTH - 8.0, end, away);
            let bed = water - STREAM_DEPTH;
            bed + (height - bed) * bank
        });
    }

    /// Gives each corner within `reach` of a line a new height, made of its height, that of the line and its distance.
    fn shape(&mut self, line: &[Vec3], reach: f32, height: impl Fn(f32, f32, f32) -> f32) {
        let mut near: HashMap<usize, (f32, f32)> = HashMap::new();
        for (a, b) in line.iter().zip(&line[1..]) {
            let (low, high) = (a.min(*b) - reach, a.max(*b) + reach);
            let cells = |v: f32| (((v + SIDE * 0.5) / CELL).max(0.0) as usize).min(CELLS);
            for row in cells(low.y)..=cells(high.y) {
                for column in cells(low.x)..=cells(high.x) {
                    let (away, middle) = distance(corner(column, row), *a, *b);
                    let nearest = near.entry(row * (CELLS + 1) + column).or_insert((f32::INFINITY, 0.0));
                    if away < nearest.0 {
                        *nearest = (away, middle);
                    }
                }
            }
        }
        for (index, (away, middle)) in near.into_iter().filter(|(_, (away, _))| *away < reach) {
            self.heights[index] = height(self.heights[index], middle, away);
            self.kept[index] = true;
        }
    }
}

/// The north of the stream's middle, at an east.
pub(super) fn stream(east: f32) -> f32 {
    900.0 - 1400.0 * (east / 3900.0).sin() - 420.0 * (east / 1430.0 + 1.3).sin()
}

/// The height of the valley's floor, which falls eastwards.
pub(super) fn floor(east: f32) -> f32 {
    420.0 - 0.0035 * east
}

/// The height of the water.
pub(super) fn water(east: f32) -> f32 {
    floor(east) - WATER_BELOW_FLOOR
}

/// Places every 10 m from the western edge to the eastern, at the north that is given for each east.
pub(super) fn stations(north: impl Fn(f32) -> f32) -> impl Iterator<Item = Vec2> {
    (0..=CELLS).map(move |i| {
        let east = i as f32 * CELL - SIDE * 0.5;
        Vec2::new(east, north(east))
    })
}

/// The distance from the stream, whose course is close to straight at this scale.
pub(super) fn from_stream(p: Vec2) -> f32 {
    let slope = (stream(p.x + 5.0) - stream(p.x - 5.0)) * 0.1;
    (p.y - stream(p.x)) / (1.0 + slope * slope).sqrt()
}

/// The height that the ground has of itself.
fn natural(p: Vec2, seed: i32) -> f32 {
    let away = from_stream(p).abs();
    let hills = Perlin.fbm(5, 0.45, 2.1).frequency(1.0 / 1300.0).seed(seed).sample2(p.to_array());
    let ridges = Perlin.ridged().fbm(5, 0.45, 2.0).frequency(1.0 / 3600.0).seed(seed + 1);
    let ridge = ridges.sample2(p.to_array());
    let rise = smooth(650.0, 5200.0, away);
    floor(p.x) + rise * (270.0 + 290.0 * ridge) + hills * (3.0 + 95.0 * smooth(400.0, 2200.0, away))
}

/// Where a corner of the grid is.
pub(super) fn corner(column: usize, row: usize) -> Vec2 {
    Vec2::new(column as f32, row as f32) * CELL - SIDE * 0.5
}

/// How far a place is from a segment, seen from above, and the segment's height there.
fn distance(p: Vec2, a: Vec3, b: Vec3) -> (f32, f32) {
    let along = b.truncate() - a.truncate();
    let share = ((p - a.truncate()).dot(along) / along.length_squared().max(1e-6)).clamp(0.0, 1.0);
    (p.distance(a.truncate() + along * share), a.z + (b.z - a.z) * share)
}

/// From 0 at `low` to 1 at `high`, with level ends.
pub(super) fn smooth(low: f32, high: f32, value: f32) -> f32 {
    let t = ((value - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
