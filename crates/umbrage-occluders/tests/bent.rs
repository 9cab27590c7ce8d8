//! Meshes that bend: their copies, the order in which their boxes are made anew, and what is known of those that nobody refits.

use glam::{DVec3, Mat4, Vec2, Vec3};
use proptest::prelude::*;
use umbrage_occluders::{
    AlphaMode, Cover, Geometry, InstanceRecord, Mesh, MeshRange, Part, Placed, Shape, TopLevel,
};

fn build(positions: &[Vec3], indices: &[u32], bends: bool) -> Geometry {
    let parts = vec![Part { indices, cover: None }];
    Geometry::build(&[Mesh { positions, parts, bends }], &[])
}

/// The least and the largest coordinates of some corners.
fn around(corners: impl Iterator<Item = Vec3> + Clone) -> [Vec3; 2] {
    [corners.clone().fold(Vec3::INFINITY, Vec3::min), corners.fold(Vec3::NEG_INFINITY, Vec3::max)]
}

/// Refits a mesh as the shader does, but for the margin.
fn refit(geometry: &mut Geometry, mesh: usize, vertices: &[Vec3]) {
    let range = geometry.meshes[mesh];
    let refit = geometry.refits[range.refit.expect("it bends")].clone();
    let first_corner = refit.first_corner + range.corner_offset;
    for (corner, vertex) in (first_corner as usize..).zip(&refit.vertices) {
        geometry.corners[corner] = vertices[*vertex as usize].to_array();
    }
    let mut begin = 0;
    for end in &refit.heights {
        for node in &refit.nodes[begin..*end as usize] {
            let place = (range.first + node) as usize;
            let leaf = geometry.nodes[place].leaf;
            let [low, high] = if leaf > 0 {
                around(corners(geometry, &range, leaf).into_iter())
            } else {
                let children = [place + 1, geometry.nodes[place + 1].next as usize];
                let boxes = children.map(|child| [geometry.nodes[child].low, geometry.nodes[child].high]);
                around(boxes.into_iter().flatten().map(Vec3::from_array))
            };
            (geometry.nodes[place].low, geometry.nodes[place].high) = (low.into(), high.into());
        }
        begin = *end as usize;
    }
}

/// The corners of the triangles of a leaf.
fn corners(geometry: &Geometry, range: &MeshRange, leaf: u32) -> Vec<Vec3> {
    let triangles = (leaf >> 3) as usize..((leaf >> 3) + (leaf & 7)) as usize;
    let of = |corner: u32| Vec3::from_array(geometry.corners[(corner + range.corner_offset) as usize]);
    geometry.triangles[triangles].iter().flat_map(|[a, b, c, _]| [*a, *b, *c].map(of)).collect()
}

/// Walks through all of a mesh as a ray does that meets every box: whether each triangle comes once, within the boxes of all nodes
/// above it.
fn check(geometry: &Geometry, mesh: usize, triangles: &mut Vec<[Vec3; 3]>) {
    let range = geometry.meshes[mesh];
    let mut above: Vec<u32> = Vec::new();
    for place in range.first..range.end {
        let node = geometry.nodes[place as usize];
        above.retain(|other| geometry.nodes[*other as usize].next > place);
        assert!(node.next > place && node.next <= range.end, "node {place} links to {}", node.next);
        above.push(place);
        if node.leaf == 0 {
            continue;
        }
        assert_eq!(node.next, place + 1, "a leaf has no subtree");
        let corners = corners(geometry, &range, node.leaf);
        for other in &above {
            let [low, high] = [geometry.nodes[*other as usize].low, geometry.nodes[*other as usize].high]
                .map(Vec3::from_array);
            assert!(corners.iter().all(|corner| corner.cmpge(low).all() && corner.cmple(high).all()));
        }
        triangles.extend(corners.chunks_exact(3).map(|corners| [corners[0], corners[1], corners[2]]));
    }
}

fn sorted(mut triangles: Vec<[Vec3; 3]>) -> Vec<[[u32; 3]; 3]> {
    let bits = |triangle: [Vec3; 3]| triangle.map(|corner| corner.to_array().map(f32::to_bits));
    let mut bits: Vec<_> = triangles.drain(..).map(bits).collect();
    bits.sort_unstable();
    bits
}

fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![Just(0.0f32), -8.0f32..8.0, -1e4f32..1e4]
}

fn place() -> impl Strategy<Value = Vec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(Vec3::from_array)
}

proptest! {
    #[test]
    fn a_mesh_and_its_copies_hold_every_triangle_once_however_they_are_refitted(
        rest in prop::collection::vec(place(), 3..80),
        seed in prop::collection::vec(0usize..1000, 3..240),
        poses in prop::array::uniform3(prop::collection::vec(place(), 80)),
    ) {
        let indices: Vec<u32> = seed.chunks_exact(3).flatten().map(|i| (i % rest.len()) as u32).collect();
        let mut geometry = build(&rest, &indices, true);
        let wanted: Vec<[u32; 3]> = indices.as_chunks::<3>().0.iter().copied()
            .filter(|[a, b, c]| a != b && b != c && c != a).collect();
        prop_assert_eq!(geometry.triangles(), wanted.len());
        prop_assert_eq!(geometry.left_out, indices.len() / 3 - wanted.len());
        if wanted.is_empty() {
            prop_assert_eq!(geometry.copy(0), None);
            return Ok(());
        }
        let meshes = [Some(0), geometry.copy(0), geometry.copy(1)];
        prop_assert_eq!(meshes, [Some(0), Some(1), Some(2)]);
        prop_assert_eq!(geometry.triangles(), wanted.len(), "copies share triangles");
        let heights = &geometry.refits[0].heights;
        prop_assert!(heights.is_sorted() && heights.last() == Some(&(geometry.refits[0].nodes.len() as u32)));
        for (mesh, pose) in poses.iter().enumerate() {
            refit(&mut geometry, mesh, pose);
        }
        for (mesh, pose) in poses.iter().enumerate() {
            let mut found = Vec::new();
            check(&geometry, mesh, &mut found);
            let posed = wanted.iter().map(|triangle| triangle.map(|i| pose[i as usize])).collect();
            prop_assert_eq!(sorted(found), sorted(posed));
        }
    }
}

#[test]
fn only_what_bends_keeps_vertices_apart_and_triangles_without_area() {
    // Two triangles beside each other with vertices of their own, and one that is a line at rest.
    let positions =
        [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::X, Vec3::ONE, Vec3::Y, Vec3::ZERO, Vec3::X, Vec3::X * 2.0];
    let indices: Vec<u32> = (0..9).collect();
    let (mut rigid, mut bends) = (build(&positions, &indices, false), build(&positions, &indices, true));
    assert_eq!((rigid.triangles(), rigid.corners.len(), rigid.left_out), (2, 4, 1));
    assert_eq!((bends.triangles(), bends.corners.len(), bends.left_out), (3, 9, 0));
    assert_eq!(bends.refits[0].vertices.len(), 9);
    assert_eq!((rigid.refits.len(), rigid.copy(0)), (0, None), "what does not bend has no copies");
    assert_eq!(bends.copy(1), None, "there is none");
    let lost = [Vec3::NAN, Vec3::X, Vec3::Y];
    assert_eq!(build(&lost, &[0, 1, 2], true).left_out, 1);
}

#[test]
fn parts_of_other_surfaces_have_corners_of_their_own_where_they_share_vertices() {
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
    let cover = |uvs| Cover {
        mode: AlphaMode::Mask { cutoff: 0.5 },
        transmission: 0.0,
        factor: 1.0,
        uvs,
        alphas: &[],
        picture: None,
    };
    let parts = [None, Some(cover(&[Vec2::X; 3])), Some(cover(&[Vec2::Y; 3]))];
    let parts = parts.map(|cover| Part { indices: &[0, 1, 2], cover }).into();
    let geometry = Geometry::build(&[Mesh { positions: &positions, parts, bends: true }], &[]);
    assert_eq!((geometry.corners.len(), geometry.triangles()), (9, 3));
    assert_eq!(geometry.refits[0].vertices, [0, 1, 2, 0, 1, 2, 0, 1, 2]);
}

#[test]
fn rays_know_of_an_instance_what_they_are_told() {
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
    let mut geometry = build(&positions, &[0, 1, 2], true);
    let copy = geometry.copy(0).expect("it bends");
    let around = [Vec3::splat(-1.0), Vec3::splat(2.0)];
    let of = |mesh, shape| {
        let world_from_mesh = Mat4::from_translation(Vec3::Z * 10.0);
        TopLevel::build(&geometry.meshes, [Placed { mesh, world_from_mesh, shape }], DVec3::Z)
    };
    let top = of(copy, Shape::Refitted(around));
    let MeshRange { first, end, corner_offset, .. } = geometry.meshes[copy];
    let record = top.records[0];
    assert_eq!((record.first, record.end, record.corner_offset), (first, end, corner_offset));
    assert_eq!((corner_offset, end - first, top.leaves_to_maps), (3, 1, false));
    assert!(top.nodes[0].low[2] < 8.0 && top.nodes[0].low[2] > 7.99 && top.nodes[0].high[2] > 11.0);
    let left = of(7, Shape::LeftToMaps(around));
    assert_eq!(left.records, [InstanceRecord::default()], "no nodes: the first is the last");
    assert!(left.leaves_to_maps && left.nodes[0].low == top.nodes[0].low);
    for nowhere in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for shape in [Shape::Refitted, Shape::LeftToMaps] {
            let top = of(0, shape([Vec3::ZERO, Vec3::new(1.0, nowhere, 1.0)]));
            assert_eq!((top.instances(), top.left_out), (0, 1), "{nowhere}");
        }
    }
    assert_eq!(of(7, Shape::Refitted(around)).left_out, 1, "there is no such mesh");
}
