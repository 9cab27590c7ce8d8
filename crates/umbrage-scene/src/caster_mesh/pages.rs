//! Levels packed for a device: indices of 16 bits, in an order that suits vertex caches.
//!
//! Vertices lie in pages of at most 65,536. A part's are all in one page, whose first vertex its indices count from; what
//! parts of two pages share is there twice. Most meshes have one page for all levels.

use super::closed::is_closed;
use super::welded::Welded;
use super::{CasterLevel, CasterMesh, CasterPart, Coarser, Piece};

/// The vertices that an index of 16 bits tells apart.
const PAGE: usize = 1 << 16;

/// The full geometry, and the coarser levels behind it.
pub(super) fn packed(welded: &Welded, coarser: &[Coarser]) -> CasterMesh {
    let mut packer = Packer {
        positions: &welded.positions,
        page_of: vec![u32::MAX; welded.positions.len()],
        number_of: vec![0; welded.positions.len()],
        page: 0,
        first_vertex: 0,
        packed: CasterMesh::default(),
    };
    if !welded.pieces.is_empty() {
        packer.add_level(0.0, &welded.pieces);
        coarser.iter().for_each(|level| packer.add_level(level.error, &level.pieces));
    }
    packer.packed
}

struct Packer<'a> {
    positions: &'a [[f32; 3]],
    /// The last page that each vertex is in, and its number there.
    page_of: Vec<u32>,
    number_of: Vec<u16>,
    page: u32,
    first_vertex: usize,
    packed: CasterMesh,
}

impl Packer<'_> {
    fn add_level(&mut self, error: f32, pieces: &[Piece]) {
        let triangles: Vec<[u32; 3]> = pieces.iter().flat_map(|piece| &piece.triangles).copied().collect();
        let closed = is_closed(self.positions, &triangles);
        let parts = pieces.iter().map(|piece| self.add_piece(piece)).collect();
        self.packed.levels.push(CasterLevel { error, closed, parts });
    }

    fn add_piece(&mut self, piece: &Piece) -> CasterPart {
        let vertices = ordered(&piece.triangles);
        // Counted as if no vertex came twice: a page may end a little early.
        let new = vertices.iter().filter(|vertex| self.page_of[**vertex as usize] != self.page).count();
        if self.packed.positions.len() - self.first_vertex + new > PAGE {
            self.page += 1;
            self.first_vertex = self.packed.positions.len();
        }
        let start = self.packed.indices.len() as u32;
        for vertex in vertices {
            let at = vertex as usize;
            if self.page_of[at] != self.page {
                self.page_of[at] = self.page;
                self.number_of[at] = (self.packed.positions.len() - self.first_vertex) as u16;
                self.packed.positions.push(self.positions[at]);
            }
            self.packed.indices.push(self.number_of[at]);
        }
        let indices = start..self.packed.indices.len() as u32;
        CasterPart { indices, first_vertex: self.first_vertex as u32, bounds: piece.bounds }
    }
}

/// The vertices of triangles, these in an order that suits vertex caches.
fn ordered(triangles: &[[u32; 3]]) -> Vec<u32> {
    let vertices = triangles.as_flattened();
    let mut used = vertices.to_vec();
    used.sort_unstable();
    used.dedup();
    // Every vertex is among those that are used.
    let number = |vertex: &u32| used.binary_search(vertex).unwrap_or_default() as u32;
    let mut order: Vec<u32> = vertices.iter().map(number).collect();
    // It refuses only indices out of range; the order is then as it was.
    let _ordered = meshoptimizer::optimize_vertex_cache_in_place(&mut order, vertices.len(), used.len());
    order.iter().map(|number| used[*number as usize]).collect()
}
