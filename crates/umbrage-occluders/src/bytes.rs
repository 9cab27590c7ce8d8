//! Geometry as bytes: so that a program which shares no memory with this one, as a web page's worker, can build it. They are no
//! file format: the program that reads them must be the one that wrote them.

use bytemuck::{Pod, Zeroable, cast_slice, pod_collect_to_vec};

use crate::geometry::{Geometry, MeshRange};
use crate::refit::Refit;

/// The numbers of nodes, triangles, corners, words of coverage, meshes and words of refits that follow, and of triangles that were
/// left out.
type Header = [u64; 7];

/// A mesh's range of nodes, its box, and how it bends.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct Range {
    nodes: [u32; 2],
    low: [f32; 3],
    high: [f32; 3],
    corner_offset: u32,
    /// One more than the refit, or 0.
    refit: u32,
}

impl Geometry {
    /// Writes the value as bytes, for [`Self::from_bytes`] of the same program.
    pub fn to_bytes(&self) -> Vec<u8> {
        let Self { nodes, triangles, corners, coverage, meshes, refits, left_out } = self;
        let refits: Vec<u32> = refits.iter().flat_map(words).collect();
        let counts = [
            nodes.len(),
            triangles.len(),
            corners.len(),
            coverage.len(),
            meshes.len(),
            refits.len(),
            *left_out,
        ];
        let header: Header = counts.map(|count| count as u64);
        let range = |MeshRange { first, end, low, high, corner_offset, refit }: &MeshRange| Range {
            nodes: [*first, *end],
            low: low.to_array(),
            high: high.to_array(),
            corner_offset: *corner_offset,
            refit: refit.map_or(0, |refit| refit as u32 + 1),
        };
        let ranges: Vec<Range> = meshes.iter().map(range).collect();
        [
            bytemuck::bytes_of(&header),
            cast_slice(nodes),
            cast_slice(triangles),
            cast_slice(corners),
            cast_slice(coverage),
            cast_slice(&ranges),
            cast_slice(&refits),
        ]
        .concat()
    }

    /// Reads what [`Self::to_bytes`] made; `None` for bytes whose lists are shorter or longer than they say. What stands in the lists is
    /// believed.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (header, mut rest) = bytes.split_first_chunk::<{ size_of::<Header>() }>()?;
        let header = bytemuck::pod_read_unaligned::<Header>(header);
        let [nodes, triangles, corners, coverage, meshes, refits, left_out] =
            header.map(|count| usize::try_from(count).ok());
        let all = Self {
            nodes: taken(&mut rest, nodes?)?,
            triangles: taken(&mut rest, triangles?)?,
            corners: taken(&mut rest, corners?)?,
            coverage: taken(&mut rest, coverage?)?,
            meshes: taken::<Range>(&mut rest, meshes?)?
                .into_iter()
                .map(|Range { nodes: [first, end], low, high, corner_offset, refit }| MeshRange {
                    first,
                    end,
                    low: low.into(),
                    high: high.into(),
                    corner_offset,
                    refit: refit.checked_sub(1).map(|refit| refit as usize),
                })
                .collect(),
            refits: read_refits(&taken(&mut rest, refits?)?)?,
            left_out: left_out?,
        };
        rest.is_empty().then_some(all)
    }
}

/// A refit as words: its first corner, the lengths of its lists, and the lists.
fn words(Refit { first_corner, vertices, nodes, heights }: &Refit) -> Vec<u32> {
    let lengths = [vertices.len(), nodes.len(), heights.len()].map(|length| length as u32);
    [&[*first_corner], &lengths[..], vertices, nodes, heights].concat()
}

/// All refits of their words.
fn read_refits(mut words: &[u32]) -> Option<Vec<Refit>> {
    let mut refits = Vec::new();
    while let Some(([first_corner, lengths @ ..], rest)) = words.split_first_chunk::<4>() {
        let mut rest = rest;
        let mut list = |length: u32| {
            let (list, behind) = rest.split_at_checked(length as usize)?;
            rest = behind;
            Some(list.to_vec())
        };
        let [vertices, nodes, heights] = lengths.map(&mut list);
        refits.push(Refit {
            first_corner: *first_corner,
            vertices: vertices?,
            nodes: nodes?,
            heights: heights?,
        });
        words = rest;
    }
    words.is_empty().then_some(refits)
}

/// Takes so many values from where the bytes begin.
fn taken<T: Pod>(rest: &mut &[u8], count: usize) -> Option<Vec<T>> {
    let (values, behind) = rest.split_at_checked(count.checked_mul(size_of::<T>())?)?;
    *rest = behind;
    Some(pod_collect_to_vec(values))
}

#[cfg(test)]
mod tests {
    use glam::{Vec2, Vec3};

    use super::*;
    use crate::source::{AlphaMode, AlphaPicture, Cover, Mesh, Part};

    fn geometry() -> Geometry {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Z, Vec3::ONE];
        let uvs = [Vec2::ZERO, Vec2::X, Vec2::Y, Vec2::ONE];
        let cover = Cover {
            mode: AlphaMode::Mask { cutoff: 0.5 },
            transmission: 0.0,
            factor: 1.0,
            uvs: &uvs,
            alphas: &[],
            picture: Some(0),
        };
        let parts = vec![
            Part { indices: &[0, 1, 2, 0, 0, 0], cover: None },
            Part { indices: &[1, 2, 3], cover: Some(cover) },
        ];
        let picture = AlphaPicture { width: 2, height: 3, alpha: vec![0, 50, 100, 150, 200, 250] };
        let bent = Mesh {
            positions: &positions,
            parts: vec![Part { indices: &[0, 1, 2], cover: None }],
            bends: true,
        };
        let mut all =
            Geometry::build(&[Mesh { positions: &positions, parts, bends: false }, bent], &[picture]);
        assert_eq!(all.copy(1), Some(2));
        all
    }

    #[test]
    fn what_was_built_elsewhere_is_what_was_built_here() {
        let here = geometry();
        assert_eq!((here.triangles(), here.left_out), (3, 1));
        let there = Geometry::from_bytes(&here.to_bytes()).expect("the same");
        assert_eq!(format!("{there:?}"), format!("{here:?}"));
        assert!(
            Geometry::from_bytes(&Geometry::default().to_bytes()).is_some_and(|all| all.triangles() == 0)
        );
    }

    #[test]
    fn bytes_that_are_cut_or_go_on_are_none_of_ours() {
        let bytes = geometry().to_bytes();
        for cut in 0..bytes.len() {
            assert!(Geometry::from_bytes(&bytes[..cut]).is_none(), "{cut} bytes");
        }
        assert!(Geometry::from_bytes(&[&bytes[..], &[0]].concat()).is_none());
        assert!(Geometry::from_bytes(&[0xff; 64]).is_none(), "a list that has no end");
    }
}
