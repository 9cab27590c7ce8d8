//! Tests of caster meshes: what they keep, how far they go, and what they make of meshes that are none.

use proptest::prelude::*;

use super::*;
use crate::shape::{Ground, cuboid, sphere};
use crate::{Primitive, worlds};

/// A bumpy sphere.
fn ball(segments: u32) -> Mesh {
    let bumpy = |p: Vec3| p * (1.0 + 0.05 * (9.0 * p.x).sin() * (7.0 * p.y).cos());
    Mesh::new("ball", &[sphere(1.0, segments, segments / 2).bent(bumpy).painted(0)])
}

/// The corners of all triangles of a level, sorted: whatever order and numbers they have.
fn triangles(mesh: &CasterMesh, level: usize) -> Vec<[[u32; 3]; 3]> {
    let mut all = Vec::new();
    for part in &mesh.levels[level].parts {
        let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
        for triangle in indices.as_chunks::<3>().0 {
            let corner = |i: u16| {
                mesh.positions[part.first_vertex as usize + usize::from(i)].map(|x| (x + 0.0).to_bits())
            };
            let mut corners = triangle.map(corner);
            // The winding stays: the smallest comes first.
            let first = (0..3).min_by_key(|i| corners[*i]).unwrap_or(0);
            corners.rotate_left(first);
            all.push(corners);
        }
    }
    all.sort_unstable();
    all
}

/// The same of a mesh as it is, without what has no inside.
fn triangles_of(mesh: &Mesh) -> Vec<[[u32; 3]; 3]> {
    let mut all = Vec::new();
    for triangle in mesh.indices.as_chunks::<3>().0 {
        let mut corners =
            triangle.map(|i| (mesh.positions[i as usize] + Vec3::ZERO).to_array().map(f32::to_bits));
        let [a, b, c] = corners;
        if a != b && b != c && c != a {
            let first = (0..3).min_by_key(|i| corners[*i]).unwrap_or(0);
            corners.rotate_left(first);
            all.push(corners);
        }
    }
    all.sort_unstable();
    all
}

#[test]
fn the_first_level_has_every_triangle_with_its_winding_and_seams_are_welded() {
    for mesh in &worlds::build("robot-war", 0).expect("a world").meshes {
        let full = CasterMesh::full(mesh, |_| true);
        assert_eq!(triangles(&full, 0), triangles_of(mesh), "{}", mesh.name);
    }
    let block = Mesh::new("block", &[cuboid(1.0, 2.0, 3.0).painted(0)]);
    assert_eq!(CasterMesh::full(&block, |_| true).positions.len(), 8, "of 24 vertices");
}

#[test]
fn each_level_is_coarser_and_lies_as_near_as_it_says() {
    let mesh = ball(160);
    let made = CasterMesh::with_levels(&mesh, |_| true);
    assert!(made.levels.len() > 5, "{} levels", made.levels.len());
    assert_eq!((made.levels[0].error, made.levels[0].triangles()), (0.0, mesh.triangles()));
    assert!(made.levels.is_sorted_by(|a, b| a.error < b.error && a.triangles() > b.triangles()), "coarser");
    // Half a degree of a sphere's surface: its sagitta is of the order of the error, with a quarter of the triangles.
    assert!(made.levels.iter().any(|level| level.error < 0.02 && level.triangles() * 4 < mesh.triangles()));
    let points: Vec<_> = mesh.positions.iter().map(|p| p.to_array()).collect();
    for (number, level) in made.levels.iter().enumerate().skip(1) {
        let mut corners = Vec::new();
        for part in &level.parts {
            let indices = &made.indices[part.indices.start as usize..part.indices.end as usize];
            corners
                .extend(indices.iter().map(|i| made.positions[part.first_vertex as usize + usize::from(*i)]));
            let inside =
                |p: &[f32; 3]| Vec3::from_array(*p).clamp(part.bounds.min, part.bounds.max).to_array() == *p;
            assert!(corners[corners.len() - indices.len()..].iter().all(inside), "level {number}: its box");
        }
        let numbers: Vec<[u32; 3]> =
            (0..corners.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let farthest = deviation::deviation(&points, &corners, &numbers, 0.0).expect("a distance");
        assert!(farthest <= level.error, "level {number}: {farthest} m, not {} m", level.error);
    }
}

#[test]
fn a_level_of_a_closed_mesh_is_closed_and_no_gap_opens_beside_what_is_left_out() {
    let mesh = ball(160);
    let closed = |made: &CasterMesh, level: usize| {
        let mut indices = Vec::new();
        for part in &made.levels[level].parts {
            let of_part = &made.indices[part.indices.start as usize..part.indices.end as usize];
            indices.extend(of_part.iter().map(|i| part.first_vertex + u32::from(*i)));
        }
        let positions: Vec<Vec3> = made.positions.iter().map(|p| Vec3::from_array(*p)).collect();
        let (normals, uvs) = (vec![Vec3::Y; positions.len()], vec![glam::Vec2::ZERO; positions.len()]);
        Mesh::new("", &[Primitive { positions, normals, uvs, indices, ..Primitive::default() }]).is_closed()
    };
    let made = CasterMesh::with_levels(&mesh, |_| true);
    assert!((0..made.levels.len()).all(|level| closed(&made, level)), "closed");
    assert!(mesh.parts.len() > 4, "{} parts", mesh.parts.len());
    let half = CasterMesh::with_levels(&mesh, |part| part % 2 == 0);
    let border = border(&mesh);
    for (number, level) in half.levels.iter().enumerate() {
        let kept: std::collections::HashSet<[u32; 3]> =
            triangles(&half, number).into_iter().flatten().collect();
        assert!(border.iter().all(|place| kept.contains(place)), "level {number}, {} m", level.error);
    }
}

/// The places that parts of even and of odd numbers share.
fn border(mesh: &Mesh) -> Vec<[u32; 3]> {
    let places = |odd: usize| -> std::collections::HashSet<[u32; 3]> {
        let parts = mesh.parts.iter().skip(odd).step_by(2);
        let indices =
            parts.flat_map(|part| &mesh.indices[part.indices.start as usize..part.indices.end as usize]);
        indices.map(|i| (mesh.positions[*i as usize] + Vec3::ZERO).to_array().map(f32::to_bits)).collect()
    };
    places(0).intersection(&places(1)).copied().collect()
}

#[test]
fn what_encloses_something_and_faces_outward_is_closed_in_all_levels() {
    let closed = |mesh: &Mesh| {
        let levels = CasterMesh::with_levels(mesh, |_| true).levels;
        levels.iter().map(|level| level.closed).collect::<Vec<_>>()
    };
    let whole = closed(&ball(64));
    assert!(whole.len() > 2 && whole.iter().all(|closed| *closed), "{whole:?}");
    let mut open = ball(64);
    open.indices.drain(300..303);
    open.parts.iter_mut().for_each(|part| part.indices.end = part.indices.end.min(open.indices.len() as u32));
    assert!(!closed(&open)[0], "a triangle is missing");
    let mut inside_out = ball(64);
    inside_out.indices.as_chunks_mut::<3>().0.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    assert!(closed(&inside_out).iter().all(|closed| !closed), "it faces inward");
    let far = sphere(1.0, 16, 8).bent(|p: Vec3| p + Vec3::X * 5.0).painted(0);
    let near = sphere(1.0, 16, 8).painted(0);
    assert!(closed(&Mesh::new("two", &[near.clone(), far.clone()]))[0], "two are as one");
    let mut turned = far;
    turned.indices.as_chunks_mut::<3>().0.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    assert!(!closed(&Mesh::new("two", &[near, turned]))[0], "one of them faces inward");
}

#[test]
fn a_mesh_of_more_vertices_than_16_bits_tell_apart_has_pages() {
    let mesh = Mesh::new("land", &Ground::new(300.0, 180_000, |at| at.x.sin()).primitives(0, 1.0));
    let full = CasterMesh::full(&mesh, |_| true);
    assert!(full.positions.len() > 1 << 16, "{} vertices", full.positions.len());
    assert!(full.levels[0].parts.iter().any(|part| part.first_vertex > 0), "a second page");
    assert_eq!(triangles(&full, 0), triangles_of(&mesh));
}

#[test]
fn what_is_tiny_or_no_mesh_casts_as_it_is() {
    let one = Primitive {
        positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
        indices: vec![0, 1, 2],
        ..Primitive::default()
    };
    let none = CasterMesh::with_levels(&Mesh::new("none", &[]), |_| true);
    assert_eq!(none, CasterMesh::default());
    let made = CasterMesh::with_levels(&Mesh::new("one", std::slice::from_ref(&one)), |_| true);
    assert_eq!((made.levels.len(), made.levels[0].triangles()), (1, 1));
    let flat = Primitive { indices: vec![0, 0, 1, 1, 2, 1], ..one.clone() };
    assert_eq!(CasterMesh::with_levels(&Mesh::new("flat", &[flat]), |_| true), CasterMesh::default());
    assert_eq!(CasterMesh::with_levels(&Mesh::new("one", &[one]), |_| false), CasterMesh::default());
    let mut numbers = ball(40);
    numbers.positions[7] = Vec3::new(f32::NAN, f32::INFINITY, 0.0);
    assert!(!CasterMesh::with_levels(&numbers, |_| true).levels.is_empty(), "no panic");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn soup_of_any_triangles_keeps_its_first_level_and_its_errors_grow(
        corners in proptest::collection::vec((0u8..12, 0u8..12, 0u8..12), 24..1800),
        scale in prop_oneof![Just(1e-20f32), Just(0.0), Just(1.0), Just(1e18)],
    ) {
        let positions: Vec<Vec3> =
            corners.iter().map(|(x, y, z)| Vec3::new(f32::from(*x), f32::from(*y), f32::from(*z)) * scale).collect();
        let indices: Vec<u32> = (0..positions.len() as u32 / 3 * 3).collect();
        let none = vec![Vec3::Y; positions.len()];
        let primitive = Primitive { normals: none, positions, indices, ..Primitive::default() };
        let mesh = Mesh::new("soup", &[primitive]);
        let made = CasterMesh::with_levels(&mesh, |_| true);
        if let Some(first) = made.levels.first() {
            prop_assert_eq!(first.error, 0.0);
            prop_assert_eq!(triangles(&made, 0), triangles_of(&mesh));
        }
        prop_assert!(made.levels.is_sorted_by(|a, b| a.error < b.error));
        prop_assert!(made.levels.iter().all(|level| level.triangles() > 0 && level.error.is_finite()));
    }
}
