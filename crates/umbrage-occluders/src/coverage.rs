//! How much of their place triangles cover that are not solid, as words that a shader reads.
//!
//! First come the surfaces, eight words each; then the corners of those surfaces, three words each (u, v, alpha); then the
//! pictures, four pixels a word. A surface's corners follow each other in the order of the mesh's: `corner + corners` is the
//! place of one.

use std::collections::HashMap;

use crate::source::{AlphaMode, AlphaPicture, Cover};

/// The words of a surface.
const SURFACE: usize = 8;

/// What was found so far.
pub(crate) struct Coverage<'a> {
    pictures: &'a [AlphaPicture],
    surfaces: Vec<Surface>,
}

struct Surface {
    words: [u32; SURFACE],
    picture: Option<usize>,
    /// The corners, by their number in the mesh.
    corners: Vec<(u32, [f32; 3])>,
}

impl<'a> Coverage<'a> {
    pub fn new(pictures: &'a [AlphaPicture]) -> Self {
        Self { pictures, surfaces: Vec::new() }
    }

    /// The index of a new surface.
    pub fn surface(&mut self, cover: &Cover<'_>) -> u32 {
        let (mode, cutoff) = match cover.mode {
            AlphaMode::Opaque => (0, 0.0),
            AlphaMode::Mask { cutoff } => (1, cutoff),
            AlphaMode::Blend => (2, 0.0),
        };
        let picture = cover.picture.filter(|picture| *picture < self.pictures.len());
        let [width, height] = picture.map_or([0; 2], |i| [self.pictures[i].width, self.pictures[i].height]);
        let (transmission, factor) = (cover.transmission.to_bits(), cover.factor.to_bits());
        let words = [mode, f32::to_bits(cutoff), transmission, factor, 0, width, height, 0];
        self.surfaces.push(Surface { words, picture, corners: Vec::new() });
        self.surfaces.len() as u32 - 1
    }

    /// Says where a corner of a surface lies on its picture.
    pub fn add_corner(&mut self, surface: u32, cover: &Cover<'_>, vertex: u32, corner: u32) {
        let uv = cover.uvs.get(vertex as usize).copied().filter(|uv| uv.is_finite()).unwrap_or_default();
        let alpha = cover.alphas.get(vertex as usize).copied().unwrap_or(1.0);
        self.surfaces[surface as usize].corners.push((corner, [uv.x, uv.y, alpha]));
    }

    /// Counts the corners of a surface from the first of all meshes, where `by` of other meshes come before its own.
    pub fn move_corners(words: &mut [u32], surface: u32, by: u32) {
        let base = &mut words[SURFACE * surface as usize + 7];
        *base = base.wrapping_sub(3 * by);
    }

    /// All words. Corners are counted from the first of their mesh.
    pub fn finish(self) -> Vec<u32> {
        let mut words = vec![0; self.surfaces.len() * SURFACE];
        let mut places = HashMap::new();
        for (i, mut surface) in self.surfaces.into_iter().enumerate() {
            let first = surface.corners.first().map_or(0, |(corner, _)| *corner);
            // What a shader adds to three times a corner; it wraps around where corners begin later than their words.
            surface.words[7] = (words.len() as u32).wrapping_sub(3 * first);
            for (corner, of) in &surface.corners {
                let place = (surface.words[7].wrapping_add(3 * corner)) as usize;
                words.resize(words.len().max(place + 3), 0);
                words[place..place + 3].copy_from_slice(&of.map(f32::to_bits));
            }
            if let Some(picture) = surface.picture {
                surface.words[4] = *places.entry(picture).or_insert_with(|| {
                    let place = words.len() as u32;
                    words.extend(self.pictures[picture].alpha.chunks(4).map(packed));
                    place
                });
            }
            words[SURFACE * i..SURFACE * (i + 1)].copy_from_slice(&surface.words);
        }
        words
    }
}

/// Four pixels, the first in the lowest bits.
fn packed(pixels: &[u8]) -> u32 {
    pixels.iter().rev().fold(0, |word, pixel| word << 8 | u32::from(*pixel))
}
