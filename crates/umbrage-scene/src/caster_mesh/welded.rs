//! A mesh whose vertices at the same place are one, and whose triangles without an inside are gone.

use super::{Piece, place};
use crate::{Aabb, Mesh};

/// The casting triangles of a mesh.
#[derive(Debug)]
pub(super) struct Welded {
    pub positions: Vec<[f32; 3]>,
    /// The parts of the mesh that are wanted, in order.
    pub pieces: Vec<Piece>,
    /// Whether each vertex belongs to what is not wanted too: if it moved, a gap would open there.
    pub shared: Vec<bool>,
}

impl Welded {
    pub fn of(mesh: &Mesh, wanted: impl Fn(usize) -> bool) -> Self {
        let all: Vec<[f32; 3]> = mesh.positions.iter().map(|place| place.to_array()).collect();
        let mut first_at: Vec<u32> = (0..all.len() as u32).collect();
        // It refuses only slices of unequal lengths; without it every vertex is its own.
        if meshoptimizer::generate_position_remap(&mut first_at, all.as_flattened(), all.len(), 12).is_err() {
            first_at = (0..all.len() as u32).collect();
        }
        let mut welded = Self { positions: Vec::new(), pieces: Vec::new(), shared: Vec::new() };
        let mut numbers = vec![u32::MAX; all.len()];
        let mut left_out = Vec::new();
        for (number, part) in mesh.parts.iter().enumerate() {
            let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
            if !wanted(number) {
                left_out.extend(indices.iter().map(|i| first_at[*i as usize]));
                continue;
            }
            let mut piece = Piece { triangles: Vec::new(), bounds: part.bounds };
            for triangle in indices.as_chunks::<3>().0 {
                let [a, b, c] = triangle.map(|i| first_at[i as usize]);
                if a != b && b != c && c != a {
                    piece.triangles.push([a, b, c].map(|first| {
                        let vertex = &mut numbers[first as usize];
                        if *vertex == u32::MAX {
                            *vertex = welded.positions.len() as u32;
                            welded.positions.push(all[first as usize]);
                        }
                        *vertex
                    }));
                }
            }
            if !piece.triangles.is_empty() {
                welded.pieces.push(piece);
            }
        }
        welded.shared = vec![false; welded.positions.len()];
        for first in left_out {
            if let Some(shared) = welded.shared.get_mut(numbers[first as usize] as usize) {
                *shared = true;
            }
        }
        welded
    }

    /// The size of the box around it, in units of mesh space.
    pub fn size(&self) -> f32 {
        let bounds = self.pieces.iter().fold(Aabb::EMPTY, |sum, piece| sum.union(piece.bounds));
        if bounds.is_empty() { 0.0 } else { bounds.size().max_element() }
    }
}

impl Piece {
    pub fn of(positions: &[[f32; 3]], triangles: Vec<[u32; 3]>) -> Self {
        let bounds = Aabb::of_points(triangles.iter().flatten().map(|vertex| place(positions, *vertex)));
        Self { triangles, bounds }
    }
}
