//! A mesh in one piece, welded: for those who need to know which triangles meet at an edge, as shadow volumes do.

use super::closed::is_closed;
use super::welded::Welded;
use crate::Mesh;

/// A welded mesh has one vertex at each place, so that triangles that meet there share it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WeldedMesh {
    /// The positions of the vertices, in mesh space.
    pub positions: Vec<[f32; 3]>,
    /// The vertices of the triangles, counter-clockwise seen from outside; none names a vertex twice.
    pub triangles: Vec<[u32; 3]>,
    /// Whether it encloses something, and faces outward: every edge has as many triangles on one side as on the other, and
    /// the volume within each piece that hangs together is positive, by more than rounding makes of a sheet and its back.
    pub closed: bool,
}

impl WeldedMesh {
    /// Welds those parts of a mesh that are `wanted`, by their number.
    pub fn of(mesh: &Mesh, wanted: impl Fn(usize) -> bool) -> Self {
        let Welded { positions, pieces, shared: _ } = Welded::of(mesh, wanted);
        let triangles: Vec<[u32; 3]> = pieces.into_iter().flat_map(|piece| piece.triangles).collect();
        let closed = is_closed(&positions, &triangles);
        Self { positions, triangles, closed }
    }
}
