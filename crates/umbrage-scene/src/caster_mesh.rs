//! What a mesh casts its shadow with: positions alone, and coarser levels of detail of them.
//!
//! A shadow map of coarse texels cannot tell a mesh from a simpler one that lies within a share of a texel of it. So a mesh
//! is welded (vertices that only normals or texture coordinates part become one), simplified step by step (Garland and
//! Heckbert, *Surface Simplification Using Quadric Error Metrics*, SIGGRAPH 1997, in meshoptimizer's form), and the
//! deviation of each step is measured. The unit of a level is the whole mesh, so that no cracks let light through; each
//! level is cut into parts of its own, so that what is culled stays small.

mod closed;
mod deviation;
mod levels;
mod pages;
mod welded;
mod whole;

#[cfg(test)]
mod tests;

use std::ops::Range;

use glam::Vec3;

use crate::{Aabb, Mesh};

pub use whole::WeldedMesh;

/// A caster mesh is what a mesh casts with, in its own space: all levels of detail, finest first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CasterMesh {
    /// The positions of all levels' vertices.
    pub positions: Vec<[f32; 3]>,
    /// The vertices of the triangles, three each, counted from their part's first vertex.
    pub indices: Vec<u16>,
    /// The levels, finest first; the first holds all triangles. There is none where nothing casts.
    pub levels: Vec<CasterLevel>,
}

/// A level of detail is a whole mesh, simplified.
#[derive(Clone, Debug, PartialEq)]
pub struct CasterLevel {
    /// No vertex of the mesh is farther than this from the level, and no step of the simplifier moved the surface farther, in
    /// units of mesh space. It is 0 for the first level and grows from each to the next.
    pub error: f32,
    /// Whether it encloses something, and faces outward: whoever is outside sees no back of it, and a sun shines on none first.
    pub closed: bool,
    /// The parts of the level; their ranges of indices follow each other.
    pub parts: Vec<CasterPart>,
}

/// A part of a level is a piece of it, of neighbouring triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct CasterPart {
    /// The range of the caster mesh's `indices`; its length is a multiple of three.
    pub indices: Range<u32>,
    /// The number of the vertex that its indices count from.
    pub first_vertex: u32,
    /// The box around the part's triangles, in mesh space.
    pub bounds: Aabb,
}

impl CasterMesh {
    /// Makes the full geometry of those parts of a mesh that are `wanted`, by their number, as one level.
    pub fn full(mesh: &Mesh, wanted: impl Fn(usize) -> bool) -> Self {
        pages::packed(&welded::Welded::of(mesh, wanted), &[])
    }

    /// Makes the same with as many coarser levels as are worth it. It takes one to three seconds a million triangles.
    ///
    /// What cannot be simplified has the full geometry alone, and so has a mesh of less than
    /// [`CasterMesh::MIN_TRIANGLES`] triangles.
    pub fn with_levels(mesh: &Mesh, wanted: impl Fn(usize) -> bool) -> Self {
        let welded = welded::Welded::of(mesh, wanted);
        let levels = levels::coarser(&welded);
        pages::packed(&welded, &levels)
    }

    /// Meshes of fewer triangles have no coarser levels: a draw of theirs costs more than their triangles do.
    pub const MIN_TRIANGLES: usize = 128;
}

impl CasterLevel {
    /// Returns the number of triangles.
    pub fn triangles(&self) -> usize {
        self.parts.iter().map(|part| part.indices.len() / 3).sum()
    }
}

/// Pieces of a mesh, as welded vertices.
#[derive(Clone, Debug)]
struct Piece {
    triangles: Vec<[u32; 3]>,
    bounds: Aabb,
}

/// A coarser level, before it is packed.
#[derive(Debug)]
struct Coarser {
    error: f32,
    pieces: Vec<Piece>,
}

fn place(positions: &[[f32; 3]], vertex: u32) -> Vec3 {
    Vec3::from_array(positions[vertex as usize])
}
