//! Meshes and instances that no importer lets pass: nothing panics, and what is left out is counted.

use std::time::Instant;

use glam::{DVec3, Mat4, Vec2, Vec3};
use proptest::prelude::*;
use umbrage_occluders::{
    AlphaMode, AlphaPicture, Cover, Geometry, InstanceRecord, Mesh, MeshRange, Node, Part, Placed, Shape,
    TopLevel,
};

/// The hierarchies of one mesh without covers.
fn of_triangles(positions: &[Vec3], indices: &[u32]) -> Geometry {
    Geometry::build(&[Mesh { positions, parts: vec![Part { indices, cover: None }], bends: false }], &[])
}

/// A mesh of one roof, for instances.
fn roof() -> Vec<MeshRange> {
    of_triangles(&[Vec3::ZERO, Vec3::X, Vec3::Z], &[0, 1, 2]).meshes
}

/// Every node leads on to a later one, and no box holds a number that is none.
fn assert_walkable(nodes: &[Node], what: &str) {
    for (i, Node { low, high, next, .. }) in nodes.iter().enumerate() {
        assert!(*next as usize > i && *next as usize <= nodes.len(), "{what}: {i} leads to {next}");
        assert!(low.iter().chain(high).all(|number| !number.is_nan()), "{what}: node {i}");
    }
}

#[test]
fn triangles_that_can_not_be_hit_are_counted_and_left_out() {
    let [nan, infinite] = [f32::NAN, f32::INFINITY].map(|number| Vec3::new(0.0, number, 0.0));
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Z, 2.0 * Vec3::X, nan, infinite, -infinite];
    let bad =
        [[0, 0, 0], [0, 1, 1], [0, 1, 3], [0, 1, 4], [0, 1, 5], [5, 6, 1], [0, 1, 99], [u32::MAX, 1, 2]];
    let geometry = of_triangles(&positions, &[&[[0, 1, 2]][..], &bad].concat().concat());
    assert_eq!((geometry.triangles(), geometry.left_out), (1, bad.len()));
    assert_walkable(&geometry.nodes, "one is left");
    // Two numbers behind the last triangle make none.
    assert_eq!(of_triangles(&positions, &[0, 1, 2, 0, 1]).triangles(), 1);
}

#[test]
fn meshes_of_nothing_have_no_nodes_and_their_instances_are_left_out() {
    let bare = Mesh { positions: &[], parts: Vec::new(), bends: false };
    let hollow =
        Mesh { positions: &[Vec3::ZERO], parts: vec![Part { indices: &[], cover: None }], bends: false };
    let geometry = Geometry::build(&[bare, hollow], &[]);
    assert_eq!((geometry.nodes.len(), geometry.triangles(), geometry.meshes.len()), (0, 0, 2));
    let placed = (0..3).map(|mesh| Placed::rigid(mesh, Mat4::IDENTITY));
    let top = TopLevel::build(&geometry.meshes, placed, DVec3::ZERO);
    assert_eq!((top.instances(), top.left_out), (0, 3), "the third mesh is not there");
    assert_walkable(&top.nodes, "a node that no ray meets");
    let nothing = TopLevel::build(&geometry.meshes, [], DVec3::ZERO);
    assert_eq!((nothing.nodes.len(), nothing.left_out), (1, 0));
}

#[test]
fn instances_without_size_or_place_are_counted_and_left_out() {
    let bad = [
        Mat4::ZERO,
        Mat4::from_scale(Vec3::new(1.0, 0.0, 1.0)),
        Mat4::from_cols_array(&[f32::NAN; 16]),
        Mat4::from_cols_array(&[f32::INFINITY; 16]),
        Mat4::from_translation(Vec3::new(f32::NAN, 0.0, 0.0)),
        Mat4::from_scale(Vec3::splat(f32::MAX)) * Mat4::from_scale(Vec3::splat(4.0)),
    ];
    let good = [Mat4::IDENTITY, Mat4::from_scale(Vec3::new(-1.0, 2.0, 3.0)), Mat4::from_scale(-Vec3::ONE)];
    let placed = good.into_iter().chain(bad).map(|matrix| Placed::rigid(0, matrix));
    let top = TopLevel::build(&roof(), placed, DVec3::ZERO);
    assert_eq!((top.instances(), top.left_out), (good.len(), bad.len()));
    assert_walkable(&top.nodes, "mirrored ones stay");
    let bent =
        |low, high| Placed { shape: Shape::LeftToMaps([low, high]), ..Placed::rigid(0, Mat4::IDENTITY) };
    let boxes = [bent(Vec3::ZERO, Vec3::ONE), bent(Vec3::NAN, Vec3::ONE), bent(Vec3::ZERO, Vec3::INFINITY)];
    let top = TopLevel::build(&roof(), boxes, DVec3::ZERO);
    assert_eq!((top.instances(), top.left_out, top.leaves_to_maps), (1, 2, true));
    for origin in [DVec3::NAN, DVec3::INFINITY, DVec3::splat(1e300)] {
        let top = TopLevel::build(&roof(), [Placed::rigid(0, Mat4::IDENTITY)], origin);
        assert_eq!((top.instances(), top.left_out), (0, 1), "{origin}");
    }
}

#[test]
fn copies_in_one_place_and_triangles_beyond_all_measure_make_hierarchies() {
    let corners = [Vec3::ZERO, Vec3::X, Vec3::Z];
    let same = [0, 1, 2].repeat(5000);
    let geometry = of_triangles(&corners, &same);
    assert_eq!((geometry.triangles(), geometry.left_out, geometry.corners.len()), (5000, 0, 3));
    assert_walkable(&geometry.nodes, "one triangle many times");
    let placed = std::iter::repeat_n(Placed::rigid(0, Mat4::IDENTITY), 5000);
    let top = TopLevel::build(&geometry.meshes, placed, DVec3::ZERO);
    assert_eq!(top.instances(), 5000);
    assert_walkable(&top.nodes, "one instance many times");
    for metres in [1e18, 1e30, f32::MAX] {
        let positions: Vec<Vec3> =
            (0..300).map(|i| Vec3::new((i % 7) as f32 - 3.0, (i % 5) as f32, (i % 3) as f32) / 3.0).collect();
        let huge: Vec<Vec3> = positions.iter().map(|place| metres * *place).collect();
        let geometry = of_triangles(&huge, &(0..300).collect::<Vec<_>>());
        assert_eq!(geometry.triangles() + geometry.left_out, 100, "{metres}");
        assert_walkable(&geometry.nodes, &format!("{metres} m"));
    }
}

#[test]
fn covers_without_a_picture_texture_coordinates_or_numbers_are_written() {
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Z];
    let cover = |mode, picture| Cover {
        mode,
        transmission: f32::NAN,
        factor: f32::INFINITY,
        uvs: &[],
        alphas: &[f32::NAN],
        picture,
    };
    let modes = [AlphaMode::Mask { cutoff: f32::NAN }, AlphaMode::Blend, AlphaMode::Opaque];
    let covers = modes.into_iter().flat_map(|mode| [None, Some(0), Some(99)].map(|of| cover(mode, of)));
    let parts = covers.map(|cover| Part { indices: &[0, 1, 2], cover: Some(cover) }).collect();
    let picture = AlphaPicture { width: 3, height: 2, alpha: vec![0, 255] };
    let geometry = Geometry::build(&[Mesh { positions: &positions, parts, bends: false }], &[picture]);
    assert_eq!((geometry.triangles(), geometry.left_out), (9, 0));
    assert!(geometry.has_covers());
    // Texture coordinates that are not there are at the picture's corner.
    let uvs = [Vec2::NAN; 3];
    let cover = Cover { uvs: &uvs, ..cover(AlphaMode::Blend, None) };
    let parts = vec![Part { indices: &[0, 1, 2], cover: Some(cover) }];
    let geometry = Geometry::build(&[Mesh { positions: &positions, parts, bends: false }], &[]);
    let corner = |i: usize| geometry.coverage[8 + 3 * i..8 + 3 * i + 2].to_vec();
    assert_eq!((0..3).flat_map(corner).collect::<Vec<_>>(), [0; 6]);
}

#[test]
fn a_million_instances_take_seconds_and_a_hundred_mebibytes() {
    const INSTANCES: usize = 1_000_000;
    let at = |i: usize| {
        let [x, y, z] = [i % 100, i / 100 % 100, i / 10_000].map(|step| 3.0 * step as f32);
        Placed::rigid(0, Mat4::from_rotation_y(i as f32) * Mat4::from_translation(Vec3::new(x, y, z)))
    };
    let start = Instant::now();
    let top = TopLevel::build(&roof(), (0..INSTANCES).map(at), DVec3::ZERO);
    let seconds = start.elapsed().as_secs_f64();
    let bytes = size_of_val(&top.nodes[..]) + size_of::<InstanceRecord>() * top.instances();
    println!("{INSTANCES} instances: {seconds:.2} s, {:.0} MiB", bytes as f64 / f64::from(1 << 20));
    assert_eq!((top.instances(), top.left_out), (INSTANCES, 0));
    assert!(top.nodes.len() < 2 * INSTANCES, "there is room for them on the device");
    assert_walkable(&top.nodes, "a million");
    assert!(bytes <= 128 * INSTANCES, "{bytes} bytes");
    // It takes two seconds on an idle core of 2020.
    assert!(seconds < 60.0, "{seconds} s");
}

/// Numbers of all kinds, good and bad.
fn number() -> impl Strategy<Value = f32> {
    prop_oneof![
        6 => -10.0f32..10.0,
        1 => any::<f32>(),
        1 => prop_oneof![Just(f32::NAN), Just(f32::INFINITY), Just(0.0), Just(1e30), Just(f32::MIN_POSITIVE)],
    ]
}

fn vector() -> impl Strategy<Value = Vec3> {
    [number(), number(), number()].prop_map(Vec3::from_array)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn whatever_is_handed_over_is_taken_or_counted(
        positions in prop::collection::vec(vector(), 0..60),
        indices in prop::collection::vec(0u32..70, 0..240),
        matrices in prop::collection::vec([number(), number(), number(), number(), number(), number()], 0..40),
    ) {
        let geometry = of_triangles(&positions, &indices);
        prop_assert_eq!(geometry.triangles() + geometry.left_out, indices.len() / 3);
        assert_walkable(&geometry.nodes, "a mesh");
        let place = |[a, b, c, x, y, z]: [f32; 6]| {
            let scale = Mat4::from_scale(Vec3::new(a, b, c));
            Placed::rigid(0, Mat4::from_translation(Vec3::new(x, y, z)) * Mat4::from_rotation_y(1.0) * scale)
        };
        let top = TopLevel::build(&geometry.meshes, matrices.iter().copied().map(place), DVec3::ZERO);
        prop_assert_eq!(top.instances() + top.left_out, matrices.len());
        assert_walkable(&top.nodes, "instances");
    }
}
