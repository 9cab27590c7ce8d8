//! Meshes that joints bend, and meshes that are morphed.

mod common;
#[path = "common/keys.rs"]
mod keys;
#[path = "common/numbers.rs"]
mod numbers;

use common::{Doc, floats};
use glam::{Mat4, Vec3};
use keys::{quads, rows, scalars, vectors};
use numbers::shorts;
use umbrage_scene::{Imported, Mesh, Scene};

const IDENTITY: [f32; 16] = Mat4::IDENTITY.to_cols_array();

/// The triangle with joints and weights of so many sets, bent by a skin of these nodes. Node 0 has the mesh.
fn skinned(joints: &[u16], weights: &[f32], skin: &str, nodes: &str) -> Doc {
    let mut doc = Doc::triangle();
    let mut attributes = r#""POSITION": 0"#.to_owned();
    for set in 0..weights.len() / 12 {
        let bytes = shorts(&joints[set * 12..(set + 1) * 12]);
        let of = doc.accessor(&bytes, "", r#""count": 3, "componentType": 5123, "type": "VEC4""#);
        let by = quads(&mut doc, &weights[set * 12..(set + 1) * 12]);
        attributes += &format!(r#", "JOINTS_{set}": {of}, "WEIGHTS_{set}": {by}"#);
    }
    doc.primitives = format!(r#"{{"attributes": {{{attributes}}}}}"#);
    doc.nodes = format!(r#"{{"mesh": 0, "skin": 0, "name": "hero", "translation": [100, 0, 0]}}, {nodes}"#);
    doc.rest = format!(r#", "skins": [{skin}]"#);
    doc
}

/// The corners of the first instance in the file, as a pose bends them.
fn corners(scene: &Scene, seconds: f32) -> Vec<Vec3> {
    let baked = scene.baked(&scene.pose(seconds));
    let instance = &baked.instances[0];
    let place = |p: &Vec3| instance.world_from_mesh.transform_point3(*p) + scene.origin.as_vec3();
    baked.meshes[instance.mesh].positions.iter().map(place).collect()
}

fn assert_corners(scene: &Scene, seconds: f32, want: [Vec3; 3]) {
    for (got, want) in corners(scene, seconds).into_iter().zip(want) {
        assert!(got.abs_diff_eq(want, 1e-5), "{got}, not {want}, at {seconds} s");
    }
}

/// One joint a vertex.
fn one_each(joints: [u16; 3]) -> (Vec<u16>, Vec<f32>) {
    let rows = joints.map(|joint| [joint, 0, 0, 0]);
    (rows.concat(), [[1.0, 0.0, 0.0, 0.0]; 3].concat())
}

const TWO: &str = r#"{"children": [2], "translation": [0, 0, 5]}, {"translation": [0, 0, 1]}"#;

#[test]
fn joints_bend_a_mesh_whatever_its_own_node_does() {
    let (joints, weights) = one_each([0, 1, 1]);
    let mut doc = skinned(&joints, &weights, "", TWO);
    let bind = [IDENTITY, Mat4::from_translation(Vec3::NEG_Z).to_cols_array()].concat();
    let bind = rows(&mut doc, "MAT4", &bind, 16);
    let (times, up) = (scalars(&mut doc, &[0.0, 1.0]), vectors(&mut doc, &[0.0, 0.0, 1.0, 0.0, 2.0, 1.0]));
    doc.rest = format!(
        r#", "skins": [{{"joints": [1, 2], "inverseBindMatrices": {bind}, "skeleton": 99}}],
        "animations": [{{"samplers": [{{"input": {times}, "output": {up}}}],
            "channels": [{{"sampler": 0, "target": {{"node": 2, "path": "translation"}}}}]}}]"#
    );
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    let five = Vec3::Z * 5.0;
    assert_corners(&scene, 0.0, [five, five + Vec3::X, five + Vec3::Y]);
    assert_corners(&scene, 0.5, [five, five + Vec3::X + Vec3::Y, five + Vec3::Y * 2.0]);
    let names: Vec<usize> = scene.rig.skins[0].joints.iter().map(|(node, _)| *node).collect();
    assert_eq!((scene.rig.nodes.len(), names), (2, vec![0, 1]));
}

#[test]
fn all_sets_of_joints_count_and_weights_sum_to_one() {
    let (mut joints, mut weights) = one_each([0, 0, 0]);
    weights = weights.iter().map(|weight| weight * 0.5).collect();
    let (second, half) = one_each([1, 1, 0]);
    joints.extend(second);
    weights.extend(half.iter().map(|weight| weight * 0.5));
    let mut doc = skinned(&joints, &weights, r#"{"joints": [1, 2]}"#, TWO);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!((warnings, scene.meshes[0].influences.per_vertex), (Vec::new(), 8));
    let z = |z: f32| Vec3::Z * z;
    assert_corners(&scene, 0.0, [z(5.5), z(5.5) + Vec3::X, z(5.0) + Vec3::Y]);

    // The same four times as strong.
    let strong: Vec<f32> = weights.iter().map(|weight| weight * 4.0).collect();
    doc = skinned(&joints, &strong, r#"{"joints": [1, 2]}"#, TWO);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(
        warnings,
        [
            "weights of joints that do not sum to 1 are scaled until they do: 3 in mesh \"mesh 0\" of 3 vertices"
        ]
    );
    assert_corners(&scene, 0.0, [z(5.5), z(5.5) + Vec3::X, z(5.0) + Vec3::Y]);
}

#[test]
fn weights_of_eight_bits_are_normalised() {
    let (joints, weights) = one_each([0, 1, 1]);
    let mut doc = skinned(&joints, &weights, r#"{"joints": [1, 2]}"#, TWO);
    let bytes: Vec<u8> = [[127, 128, 0, 0]; 3].concat();
    let members = r#""count": 3, "componentType": 5121, "normalized": true, "type": "VEC4""#;
    let by = doc.accessor(&bytes, "", members);
    let bytes: Vec<u8> = [[0, 1, 0, 0]; 3].concat();
    let of = doc.accessor(&bytes, "", r#""count": 3, "componentType": 5121, "type": "VEC4""#);
    doc.primitives = format!(r#"{{"attributes": {{"POSITION": 0, "JOINTS_0": {of}, "WEIGHTS_0": {by}}}}}"#);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    let z = Vec3::Z * (5.0 + 128.0 / 255.0);
    assert_corners(&scene, 0.0, [z, z + Vec3::X, z + Vec3::Y]);
}

#[test]
fn bad_joints_and_weights_are_mended_with_one_warning_each() {
    let (joints, weights) = one_each([0, 1, 1]);
    let nothing = [0.0; 12];
    let mut negative = weights.clone();
    (negative[1], negative[2]) = (-1.0, f32::NAN);
    let far = joints.iter().map(|joint| joint * 700).collect::<Vec<_>>();
    let five = [5.0, 5.0, 5.0];
    for (joints, weights, says, z) in [
        (&joints, &nothing[..], "joints all have weight 0 follow the first", five),
        (&joints, &negative, "negative or not finite count for nothing: 2 in", [5.0, 6.0, 6.0]),
        (
            &far,
            &weights,
            "joints that their skin lacks count for nothing: 2 in mesh \"mesh 0\" of 3 vertices, its skin has 2",
            five,
        ),
    ] {
        let doc = skinned(joints, weights, r#"{"joints": [1, 2]}"#, TWO);
        let Imported { scene, warnings } = doc.load().unwrap();
        assert!(warnings.iter().any(|warning| warning.contains(says)), "{says}: {warnings:?}");
        let z = z.map(|z| Vec3::Z * z);
        assert_corners(&scene, 0.0, [z[0], z[1] + Vec3::X, z[2] + Vec3::Y]);
    }
}

#[test]
fn what_a_skin_lacks_is_one_warning_and_the_mesh_stays() {
    let (joints, weights) = one_each([0, 1, 1]);
    let first = [5.0, 5.0, 5.0];
    for (skin, says, z) in [
        (r#"{"joints": [1, 77]}"#, "joint 1 of skin 0 is node 77 of 3", Some(first)),
        (r#"{"joints": [1, 2], "inverseBindMatrices": 0}"#, "accessor 0 has 3 numbers a row, need 16", None),
        (r#"{"joints": [1, 2], "inverseBindMatrices": 9}"#, "accessor 9 of", None),
        (
            r#"{"joints": [1, 2], "inverseBindMatrices": 3}"#,
            "joint 1 of skin 0 has no inverse bind matrix of finite",
            Some(first),
        ),
        (r#"{"joints": [1, 2], "inverseBindMatrices": 4}"#, "16777216 inverse bind matrices for 2", None),
        (r#"{"joints": []}"#, "it has no joints", None),
        (r#"{"skeleton": 1}"#, "joints", None),
        ("3", "skin 0", None),
        (r#"{"joints": [0]}, {"joints": [77]}"#, "", None),
    ] {
        let mut doc = skinned(&joints, &weights, skin, TWO);
        rows(&mut doc, "MAT4", &IDENTITY, 16);
        doc.accessors.push(r#"{"count": 16777216, "componentType": 5126, "type": "MAT4"}"#.to_owned());
        let Imported { scene, warnings } = doc.load().unwrap();
        if says.is_empty() {
            // The mesh hangs on its own joint.
            assert!(scene.instances[0].skin.is_some(), "{warnings:?}");
            continue;
        }
        assert!(warnings.iter().any(|warning| warning.contains(says)), "{says}: {warnings:?}");
        let want = z.map_or([Vec3::X * 100.0; 3], |z| z.map(|z| Vec3::Z * z));
        assert_corners(&scene, 0.0, [want[0], want[1] + Vec3::X, want[2] + Vec3::Y]);
    }
    let mut doc = skinned(&joints, &weights, r#"{"joints": [1, 2]}"#, TWO);
    doc.nodes = doc.nodes.replace(r#""skin": 0"#, r#""skin": 7"#);
    let warnings = doc.load().unwrap().warnings;
    assert!(warnings.len() == 1 && warnings[0].contains("hero, skin 7 of 1 is not there"), "{warnings:?}");
}

#[test]
fn joints_in_a_circle_are_a_tree_again_and_thousands_are_no_trouble() {
    let (joints, weights) = one_each([0, 1, 1]);
    let circle =
        r#"{"children": [2], "translation": [0, 0, 5]}, {"children": [1], "translation": [0, 0, 1]}"#;
    let doc = skinned(&joints, &weights, r#"{"joints": [1, 2]}"#, circle);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert!(warnings.len() == 1 && warnings[0].contains("their own ancestors"), "{warnings:?}");
    assert_corners(&scene, 0.0, [Vec3::Z * 5.0, Vec3::new(1.0, 0.0, 6.0), Vec3::new(0.0, 1.0, 6.0)]);

    let chain = |i: usize| format!(r#"{{"children": [{}], "translation": [0, 0, 0.125]}}"#, i + 1);
    let nodes: Vec<String> = (1..5000).map(chain).chain(["{}".to_owned()]).collect();
    let all: Vec<String> = (1..=5000).map(|i| i.to_string()).collect();
    let skin = format!(r#"{{"joints": [{}]}}"#, all.join(", "));
    let (joints, weights) = one_each([0, 4000, 4000]);
    let doc = skinned(&joints, &weights, &skin, &nodes.join(", "));
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!((warnings.len(), scene.rig.nodes.len()), (0, 5000));
    let end = Vec3::Z * 4001.0 * 0.125;
    assert_corners(&scene, 0.0, [Vec3::Z * 0.125, end + Vec3::X, end + Vec3::Y]);
}

#[test]
fn a_skinned_mesh_far_from_the_origin_keeps_its_shape() {
    let (joints, weights) = one_each([0, 1, 1]);
    let nodes = r#"{"children": [2], "translation": [100000, 0, 5]}, {"translation": [0, 0, 1]}"#;
    let doc = skinned(&joints, &weights, r#"{"joints": [1, 2]}"#, nodes);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    assert_eq!(scene.origin.x, 100_000.5);
    let local: Vec<Vec3> = corners(&Scene { origin: glam::DVec3::ZERO, ..scene.clone() }, 0.0);
    for (got, want) in local.iter().zip([[-0.5, 0.0, 5.0], [0.5, 0.0, 6.0], [-0.5, 1.0, 6.0]]) {
        assert!(got.abs_diff_eq(Vec3::from(want) - scene.origin.as_vec3().with_x(0.0), 1e-6), "{got}");
    }
}

/// A triangle with one morph target, flat or with normals, and more members of its mesh.
fn morphed(target: &[f32], attributes: &str, more: &str) -> Doc {
    let mut doc = Doc::triangle();
    let target = vectors(&mut doc, target);
    let normals = vectors(&mut doc, &[[0.0, 0.0, 1.0]; 3].concat());
    let attributes = attributes.replace("NORMALS", &normals.to_string());
    doc.primitives =
        format!(r#"{{"attributes": {{"POSITION": 0{attributes}}}, "targets": [{{"POSITION": {target}}}]}}"#);
    doc.nodes = format!(r#"{{"mesh": 0{more}}}"#);
    doc
}

fn with_mesh_weights(doc: &Doc, weights: &str) -> Imported {
    let json = doc.json().replace(r#""primitives""#, &format!(r#""weights": {weights}, "primitives""#));
    umbrage_scene::load_glb_bytes(&common::glb(&json, &doc.binary), "doc.glb").unwrap()
}

#[test]
fn meshes_are_morphed_by_their_own_weights_or_their_nodes() {
    let up = [[0.0; 3], [0.0; 3], [0.0, 4.0, 0.0]].concat();
    let doc = morphed(&up, "", "");
    for (node, mesh, y) in
        [("", "[1]", 5.0), (r#", "weights": [0.5]"#, "[1]", 3.0), (r#", "weights": [2]"#, "[]", 9.0)]
    {
        let doc = Doc { nodes: format!(r#"{{"mesh": 0{node}}}"#), ..doc.clone() };
        let Imported { scene, warnings } = with_mesh_weights(&doc, mesh);
        assert_eq!(warnings, [""; 0]);
        assert_corners(&scene, 0.0, [Vec3::ZERO, Vec3::X, Vec3::Y * y]);
    }
    // At weight 0 and unmoved it is a mesh as any other.
    let scene = with_mesh_weights(&doc, "[0]").scene;
    assert!(scene.meshes[0].targets.is_empty() && !scene.instances[0].is_dynamic(), "still");
}

#[test]
fn weights_are_animated() {
    let mut doc = morphed(&[[0.0; 3], [0.0; 3], [0.0, 4.0, 0.0]].concat(), "", "");
    let (times, weights) = (scalars(&mut doc, &[0.0, 1.0]), scalars(&mut doc, &[0.0, 1.0]));
    doc.rest = format!(
        r#", "animations": [{{"samplers": [{{"input": {times}, "output": {weights}}}],
            "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "weights"}}}}]}}]"#
    );
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    assert_corners(&scene, 0.0, [Vec3::ZERO, Vec3::X, Vec3::Y]);
    assert_corners(&scene, 0.5, [Vec3::ZERO, Vec3::X, Vec3::Y * 3.0]);
}

#[test]
fn flat_normals_follow_the_shape_that_is_morphed_and_smooth_ones_follow_the_file() {
    // The triangle's plane turns from across Z to across Y.
    let lie_down = [[0.0; 3], [0.0; 3], [0.0, -1.0, -1.0]].concat();
    for (attributes, normal) in [("", Vec3::Y), (r#", "NORMAL": NORMALS"#, Vec3::Z)] {
        let scene = with_mesh_weights(&morphed(&lie_down, attributes, ""), "[1]").scene;
        let baked = scene.baked(&scene.pose(0.0));
        for got in &baked.meshes[0].normals {
            assert!(got.abs_diff_eq(normal, 1e-6), "{got} {attributes}");
        }
    }
}

#[test]
fn sparse_targets_move_the_vertices_that_they_name() {
    let mut doc = morphed(&[0.0; 9], "", "");
    let (indices, values) = (doc.view(&[2], ""), doc.view(&floats(&[0.0, 4.0, 0.0]), ""));
    doc.accessors.push(format!(
        r#"{{"count": 3, "componentType": 5126, "type": "VEC3", "sparse": {{"count": 1,
            "indices": {{"bufferView": {indices}, "componentType": 5121}}, "values": {{"bufferView": {values}}}}}}}"#
    ));
    let sparse = doc.accessors.len() - 1;
    doc.primitives = format!(r#"{{"attributes": {{"POSITION": 0}}, "targets": [{{"POSITION": {sparse}}}]}}"#);
    assert_corners(&with_mesh_weights(&doc, "[1]").scene, 0.0, [Vec3::ZERO, Vec3::X, Vec3::Y * 5.0]);
}

#[test]
fn targets_that_cannot_be_read_change_nothing() {
    for (target, says) in [
        (vec![0.0; 6], "3 positions, and 2 rows in accessor 1"),
        (vec![0.0, f32::NAN, 0.0, 0.0, 0.0, 0.0, 0.0, 1e30, 0.0], "not finite or reach too far"),
    ] {
        let Imported { scene, warnings } = with_mesh_weights(&morphed(&target, "", ""), "[1]");
        assert!(warnings.len() == 1 && warnings[0].contains(says), "{warnings:?}");
        assert_corners(&scene, 0.0, [Vec3::ZERO, Vec3::X, Vec3::Y]);
    }
}

#[test]
fn targets_and_joints_beyond_the_budget_leave_the_mesh_as_it_was_modelled() {
    let positions = r#"{"count": 16000000, "componentType": 5126, "type": "VEC3"}"#;
    let quads = r#"{"count": 16000000, "componentType": 5126, "type": "VEC4"}"#;
    let mut doc = Doc::triangle();
    doc.accessors.extend([positions.to_owned(), quads.to_owned()]);
    let triangle = r#"{"attributes": {"POSITION": 0}, "targets": [{"POSITION": 0}]}"#;
    let targets = vec![r#"{"POSITION": 1}"#; 100].join(", ");
    doc.primitives = format!(
        r#"{triangle}, {{"attributes": {{"POSITION": 1, "NORMAL": 1}}, "targets": [{targets}], "indices": 0}}"#
    );
    doc.nodes = r#"{"mesh": 0, "weights": [1]}"#.to_owned();
    let Imported { scene, warnings } = doc.load().unwrap();
    let says = "morph targets find no room keep their shape: more than 33554432 displacements";
    assert!(warnings.iter().any(|warning| warning.contains(says)), "{warnings:?}");
    let Mesh { targets, positions, .. } = &scene.meshes[0];
    assert!(targets.is_empty() && positions.len() >= 3, "{} targets", targets.len());
}

#[test]
fn a_shape_that_reaches_too_far_is_left_out() {
    for (weights, count) in [("[1e9]", 2), ("[1e12]", 1), ("[-1e12]", 1), ("[1e30]", 2)] {
        let mut doc = morphed(&[[0.0; 3], [0.0; 3], [0.0, 4.0, 0.0]].concat(), "", r#", "name": "tower""#);
        doc.nodes += r#", {"mesh": 0, "weights": [0]}"#;
        let Imported { scene, warnings } = with_mesh_weights(&doc, weights);
        assert_eq!(scene.instances.len(), count, "{weights}: {warnings:?}");
        assert!(scene.cameras[0].world_from_camera.is_finite(), "{weights}");
        assert_eq!(warnings.iter().filter(|line| line.contains("reach too far")).count(), 2 - count);
    }
}
