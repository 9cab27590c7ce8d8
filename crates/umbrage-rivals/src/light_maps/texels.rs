//! Which points of the world the texels of an atlas show, a band of rows at a time.
//!
//! A texel shows points of its square, as many as there are rays. Those that no triangle covers are left out. Where none is
//! covered but a triangle's edge goes through the square, the texel shows a point of that edge, so that every texel which
//! bilinear reading of a surface may touch is at most one texel from one that shows something.

use std::collections::HashMap;
use std::ops::Range;

use glam::DVec2;
use umbrage_scene::Scene;

use super::unwrap::{Placed, Unwrapped, has_texels};

/// A band is some rows of a page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Band {
    pub page: u32,
    pub rows: Range<u32>,
}

/// The bands that an atlas is baked in: 16 or more a page, of 64 rows at most.
pub(super) fn bands(unwrapped: &Unwrapped) -> Vec<Band> {
    let [_, height] = unwrapped.size;
    let rows = band_rows(height);
    let of_page = |page| {
        (0..height.div_ceil(rows))
            .map(move |band| Band { page, rows: band * rows..((band + 1) * rows).min(height) })
    };
    (0..unwrapped.pages).flat_map(of_page).collect()
}

fn band_rows(height: u32) -> u32 {
    height.div_ceil(16).clamp(1, 64)
}

/// A triangle of an instance, where it lies in the atlas.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    /// The index of the instance's shape, and of the instance within it.
    pub place: [u32; 2],
    /// The index of the triangle in its mesh.
    pub triangle: u32,
}

impl Face {
    /// Where the instance has its rectangle.
    pub fn placed<'a>(&self, unwrapped: &'a Unwrapped) -> &'a Placed {
        let [shape, place] = self.place.map(|index| index as usize);
        &unwrapped.shapes[shape].placed[place]
    }

    /// The corners within the page, in texels.
    fn corners(&self, unwrapped: &Unwrapped) -> [DVec2; 3] {
        let texels = DVec2::from(unwrapped.size.map(f64::from));
        let corners =
            unwrapped.shapes[self.place[0] as usize].corners(self.placed(unwrapped), self.triangle as usize);
        corners.map(|corner| corner.as_dvec2() * texels)
    }
}

/// The faces that each band shows, in the order of [`bands`].
pub(super) fn faces(scene: &Scene, unwrapped: &Unwrapped) -> Vec<Vec<Face>> {
    let [_, height] = unwrapped.size;
    let rows = band_rows(height);
    let bands_of_page = height.div_ceil(rows);
    let mut faces = vec![Vec::new(); (unwrapped.pages * bands_of_page) as usize];
    for (shape, of) in unwrapped.shapes.iter().enumerate() {
        let has_texels: Vec<bool> = has_texels(scene, &scene.meshes[of.mesh]).collect();
        for (place, placed) in of.placed.iter().enumerate() {
            for triangle in (0..has_texels.len()).filter(|triangle| has_texels[*triangle]) {
                let face = Face { place: [shape as u32, place as u32], triangle: triangle as u32 };
                let [a, b, c] = face.corners(unwrapped).map(|corner| corner.y);
                let band = |row: f64| ((row.max(0.0) as u32) / rows).min(bands_of_page - 1);
                for band in band(a.min(b).min(c))..=band(a.max(b).max(c)) {
                    faces[(placed.page * bands_of_page + band) as usize].push(face);
                }
            }
        }
    }
    faces
}

/// A point that a texel shows: a face of the band, and how much each of its corners counts.
pub(super) type Shown = (Face, [f64; 3]);

/// What the texels of a band show.
pub(super) struct Texels<'a> {
    unwrapped: &'a Unwrapped,
    faces: &'a [Face],
    first_row: u32,
    pattern: &'a [DVec2],
    /// The face at each point of each texel, row by row.
    owners: Vec<u32>,
    /// What texels show that have no such point: a face, and a point of the page in texels.
    edges: HashMap<usize, (u32, DVec2)>,
}

/// No face.
const NONE: u32 = u32::MAX;

impl<'a> Texels<'a> {
    /// Finds what the texels of a band show at the points of a pattern within the unit square.
    pub fn new(unwrapped: &'a Unwrapped, faces: &'a [Face], band: &Band, pattern: &'a [DVec2]) -> Self {
        let texels = unwrapped.size[0] as usize * band.rows.len();
        let owners = vec![NONE; texels * pattern.len()];
        let mut found =
            Self { unwrapped, faces, first_row: band.rows.start, pattern, owners, edges: HashMap::new() };
        for (i, face) in faces.iter().enumerate() {
            found.cover(i as u32, face.corners(unwrapped), &band.rows);
        }
        for (i, face) in faces.iter().enumerate() {
            let [a, b, c] = face.corners(unwrapped);
            for ends in [(a, b), (b, c), (c, a)] {
                found.walk(i as u32, ends, &band.rows);
            }
        }
        found
    }

    /// What a texel of the band shows.
    pub fn shown(&self, texel: usize) -> impl Iterator<Item = Shown> + '_ {
        let [width, count] = [self.unwrapped.size[0] as usize, self.pattern.len()];
        let corner = DVec2::new((texel % width) as f64, f64::from(self.first_row) + (texel / width) as f64);
        let owners = &self.owners[texel * count..][..count];
        let covered = owners.iter().zip(self.pattern).filter(|(owner, _)| **owner != NONE);
        let covered = covered.map(move |(owner, place)| (*owner, corner + *place));
        covered.chain(self.edges.get(&texel).copied()).map(move |(owner, point)| {
            let face = self.faces[owner as usize];
            let weights = weights(&face.corners(self.unwrapped), point).map_or([1.0 / 3.0; 3], clamped);
            (face, weights)
        })
    }

    /// Gives a face the points that it covers and nobody has.
    fn cover(&mut self, face: u32, corners: [DVec2; 3], rows: &Range<u32>) {
        let [a, b, c] = corners;
        let (min, max) = (a.min(b).min(c), a.max(b).max(c));
        let width = self.unwrapped.size[0];
        let from = |low: f64, first: u32| (low.max(0.0) as u32).max(first);
        for y in from(min.y, rows.start)..rows.end.min(max.y as u32 + 1) {
            for x in from(min.x, 0)..width.min(max.x as u32 + 1) {
                let texel = ((y - rows.start) * width + x) as usize;
                for (i, place) in self.pattern.iter().enumerate() {
                    let point = DVec2::new(f64::from(x), f64::from(y)) + *place;
                    let owner = &mut self.owners[texel * self.pattern.len() + i];
                    let covers = |weights: [f64; 3]| weights.iter().all(|weight| *weight >= -1e-9);
                    if *owner == NONE && weights(&corners, point).is_some_and(covers) {
                        *owner = face;
                    }
                }
            }
        }
    }

    /// Gives a face's edge the texels that it goes through and that show nothing.
    fn walk(&mut self, face: u32, (from, to): (DVec2, DVec2), rows: &Range<u32>) {
        let steps = (2.0 * (to - from).abs().max_element()).ceil().max(1.0);
        let width = self.unwrapped.size[0];
        for step in 0..=steps as u32 {
            let point = from.lerp(to, f64::from(step) / steps);
            let (x, y) = (point.x.max(0.0) as u32, point.y.max(0.0) as u32);
            if x >= width || !rows.contains(&y) {
                continue;
            }
            let texel = ((y - rows.start) * width + x) as usize;
            let count = self.pattern.len();
            if self.owners[texel * count..][..count].iter().all(|owner| *owner == NONE) {
                self.edges.entry(texel).or_insert((face, point));
            }
        }
    }
}

/// How much each corner of a triangle counts at a point; `None` for a triangle without area.
fn weights([a, b, c]: &[DVec2; 3], point: DVec2) -> Option<[f64; 3]> {
    let area = (b - a).perp_dot(c - a);
    let [u, v] = [(c - b).perp_dot(point - b) / area, (a - c).perp_dot(point - c) / area];
    (area != 0.0).then_some([u, v, 1.0 - u - v])
}

/// The same of the point moved into the triangle.
fn clamped(weights: [f64; 3]) -> [f64; 3] {
    let weights = weights.map(|weight| weight.max(0.0));
    let sum: f64 = weights.iter().sum();
    weights.map(|weight| weight / sum)
}

/// Points of the unit square, of which the first few are spread as evenly as all are, which lie around its middle: the Sobol
/// sequence.
pub(super) fn pattern(rays: u32) -> Vec<DVec2> {
    let middle = DVec2::splat(0.5 / f64::from(rays));
    let place = |i| DVec2::from(umbrage_judge::sobol(i).map(|share| f64::from(share) / 2f64.powi(32)));
    (0..rays).map(|i| (place(i) + middle).fract()).collect()
}
