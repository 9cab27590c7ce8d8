//! Geometry as bytes: so that a program which shares no memory with this one, as a web page's worker, can build it. They are no
//! file format: the program that reads them must be the one that wrote them.

use bytemuck::{Pod, Zeroable, cast_slice, pod_collect_to_vec};

use crate::geometry::{Geometry, MeshRange};

/// The numbers of nodes, triangles, corners, words of coverage and meshes that follow, and of triangles that were left out.
type Header = [u64; 6];

/// A mesh's range of nodes and its box.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct Range {
    nodes: [u32; 2],
    low: [f32; 3],
    high: [f32; 3],
}

impl Geometry {
    /// Writes the value as bytes, for [`Self::from_bytes`] of the same program.
    pub fn to_bytes(&self) -> Vec<u8> {
        let Self { nodes, triangles, corners, coverage, meshes, left_out } = self;
        let counts = [nodes.len(), triangles.len(), corners.len(), coverage.len(), meshes.len(), *left_out];
        let header: Header = counts.map(|count| count as u64);
        let range = |MeshRange { first, end, low, high }: &MeshRange| Range {
            nodes: [*first, *end],
            low: low.to_array(),
            high: high.to_array(),
        };
        let ranges: Vec<Range> = meshes.iter().map(range).collect();
        [
            bytemuck::bytes_of(&header),
            cast_slice(nodes),
            cast_slice(triangles),
            cast_slice(corners),
            cast_slice(coverage),
            cast_slice(&ranges),
        ]
        .concat()
    }

    /// Reads what [`Self::to_bytes`] made; `None` for any other bytes.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (header, mut rest) = bytes.split_first_chunk::<{ size_of::<Header>() }>()?;
        let header = bytemuck::pod_read_unaligned::<Header>(header);
        let [nodes, triangles, corners, coverage, meshes, left_out] =
            header.map(|count| usize::try_from(count).ok());
        let all = Self {
            nodes: taken(&mut rest, nodes?)?,
            triangles: taken(&mut rest, triangles?)?,
            corners: taken(&mut rest, corners?)?,
            coverage: taken(&mut rest, coverage?)?,
            meshes: taken::<Range>(&mut rest, meshes?)?
                .into_iter()
                .map(|Range { nodes: [first, end], low, high }| MeshRange {
                    first,
                    end,
                    low: low.into(),
                    high: high.into(),
                })
                .collect(),
            left_out: left_out?,
        };
        rest.is_empty().then_some(all)
    }
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
        Geometry::build(&[Mesh { positions: &positions, parts }], &[picture])
    }

    #[test]
    fn what_was_built_elsewhere_is_what_was_built_here() {
        let here = geometry();
        assert_eq!((here.triangles(), here.left_out), (2, 1));
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
