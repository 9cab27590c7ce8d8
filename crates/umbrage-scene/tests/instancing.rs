//! Nodes that place their mesh many times, and nodes that are hidden.

mod common;
#[path = "common/keys.rs"]
mod keys;
#[path = "common/numbers.rs"]
mod numbers;

use common::Doc;
use glam::{Mat4, Quat, Vec3};
use keys::{quads, scalars, vectors};
use numbers::shorts;
use umbrage_scene::{Imported, Motion, Scene};

/// A node that places the triangle where these attributes say, with more members, and further nodes.
fn copied(doc: &mut Doc, attributes: &str, more: &str) {
    doc.nodes = format!(
        r#"{{"mesh": 0, "name": "many", "extensions": {{"EXT_mesh_gpu_instancing": {{"attributes": {{{attributes}}}}}}}{more}}}"#
    );
}

fn world_from_mesh(scene: &Scene, i: usize) -> Mat4 {
    Mat4::from_translation(scene.origin.as_vec3()) * scene.instances[i].world_from_mesh
}

#[test]
fn sixteen_places_are_sixteen_instances() {
    let mut doc = Doc::triangle();
    let places: Vec<f32> = (0..16u8).flat_map(|i| [f32::from(i % 4), 0.0, f32::from(i / 4)]).collect();
    let at = vectors(&mut doc, &places);
    copied(&mut doc, &format!(r#""TRANSLATION": {at}, "_ID": 99"#), "");
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    assert_eq!(scene.instances.len(), 16);
    for (i, place) in places.chunks(3).enumerate() {
        assert_eq!(world_from_mesh(&scene, i), Mat4::from_translation(Vec3::from_slice(place)), "{i}");
        assert_eq!(scene.instances[i].name, "many");
    }
}

#[test]
fn instances_are_scaled_turned_and_moved_before_their_node_is() {
    let mut doc = Doc::triangle();
    let at = vectors(&mut doc, &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let size = vectors(&mut doc, &[2.0, 2.0, 2.0, 3.0, 1.0, 1.0]);
    let turns = doc.accessor(
        &shorts(&[0, 0, 23170, 23170, 0, 0, 0, 32767]),
        "",
        r#""count": 2, "componentType": 5122, "normalized": true, "type": "VEC4""#,
    );
    let attributes = format!(r#""TRANSLATION": {at}, "ROTATION": {turns}, "SCALE": {size}"#);
    copied(&mut doc, &attributes, r#", "scale": [10, 10, 10], "translation": [0, 0, 7]"#);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    let node = Mat4::from_scale_rotation_translation(Vec3::splat(10.0), Quat::IDENTITY, Vec3::Z * 7.0);
    let turn = Quat::from_rotation_z(std::f32::consts::FRAC_PI_2);
    let first = node * Mat4::from_scale_rotation_translation(Vec3::splat(2.0), turn, Vec3::X);
    assert!(world_from_mesh(&scene, 0).abs_diff_eq(first, 1e-3), "{}", world_from_mesh(&scene, 0));
    let second = node * Mat4::from_scale(Vec3::new(3.0, 1.0, 1.0));
    assert!(world_from_mesh(&scene, 1).abs_diff_eq(second, 1e-4), "{}", world_from_mesh(&scene, 1));
}

#[test]
fn instances_below_a_moving_node_move_with_it() {
    let mut doc = Doc::triangle();
    let at = vectors(&mut doc, &[1.0, 0.0, 0.0, 2.0, 0.0, 0.0]);
    let (times, up) = (scalars(&mut doc, &[0.0, 1.0]), vectors(&mut doc, &[0.0, 0.0, 0.0, 0.0, 8.0, 0.0]));
    copied(&mut doc, &format!(r#""TRANSLATION": {at}"#), "");
    doc.nodes += r#", {"children": [0, 2]}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}"#;
    doc.rest = format!(
        r#", "animations": [{{"samplers": [{{"input": {times}, "output": {up}}}],
            "channels": [{{"sampler": 0, "target": {{"node": 1, "path": "translation"}}}}]}}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {{"KHR_lights_punctual": {{"lights": [{{"type": "point"}}]}}}}"#
    );
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!((warnings.len(), scene.instances.len(), scene.lights.len()), (0, 2, 1));
    for (instance, x) in scene.instances.iter().zip([1.0, 2.0]) {
        assert!(matches!(instance.motion, Motion::Node { node: 0, .. }), "{:?}", instance.motion);
        let place = instance.world_from_mesh_in(&scene.pose(0.5)).w_axis.truncate() + scene.origin.as_vec3();
        assert!(place.abs_diff_eq(Vec3::new(x, 4.0, 0.0), 1e-5), "{place}");
    }
}

#[test]
fn instances_that_stand_nowhere_and_counts_that_differ_are_told() {
    let nan = f32::NAN;
    let cases: [(&[f32], &[f32], usize, &str); 3] = [
        (&[0.0, 0.0, 0.0, nan, 0.0, 0.0], &[1.0; 6], 1, "stand nowhere are left out: 1 of 2 of many"),
        (&[0.0; 9], &[1.0; 6], 2, "not equally many are as many as the fewest: 2 and 3 of many"),
        (&[0.0; 3], &[0.0; 3], 0, "scaled to a line or a point"),
    ];
    for (places, sizes, count, says) in cases {
        let mut doc = Doc::triangle();
        let (at, size) = (vectors(&mut doc, places), vectors(&mut doc, sizes));
        copied(&mut doc, &format!(r#""TRANSLATION": {at}, "SCALE": {size}"#), "");
        doc.nodes += r#", {"mesh": 0, "name": "other"}"#;
        let Imported { scene, warnings } = doc.load().unwrap();
        assert_eq!(scene.instances.len(), count + 1, "{says}");
        assert!(warnings.len() == 1 && warnings[0].contains(says), "{warnings:?}");
    }
    let mut doc = Doc::triangle();
    let turns = quads(&mut doc, &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0]);
    copied(&mut doc, &format!(r#""ROTATION": {turns}"#), "");
    let scene = doc.load().unwrap().scene;
    assert_eq!((scene.instances.len(), world_from_mesh(&scene, 0)), (1, Mat4::IDENTITY));
}

#[test]
fn a_million_instances_are_read_and_more_are_refused() {
    for (count, is_read) in [(1_000_000, true), (1_048_577, false)] {
        let mut doc = Doc::triangle();
        doc.accessors.push(format!(r#"{{"count": {count}, "componentType": 5126, "type": "VEC3"}}"#));
        copied(&mut doc, r#""TRANSLATION": 1"#, "");
        match doc.load() {
            Ok(Imported { scene, warnings }) => {
                assert!(is_read && warnings.is_empty(), "{count}: {warnings:?}");
                assert_eq!(scene.instances.len(), count);
            }
            Err(why) => {
                assert!(!is_read, "{why}");
                assert_eq!(why.to_string(), "more than 1048576 instances of nodes in all, many: doc.glb");
            }
        }
    }
}

#[test]
fn hidden_nodes_hide_what_hangs_on_them_and_nothing_else() {
    let mut doc = Doc::triangle();
    let hidden = r#""extensions": {"KHR_node_visibility": {"visible": false}}"#;
    let at = vectors(&mut doc, &[0.0; 6]);
    doc.nodes = format!(
        r#"{{"mesh": 0, "name": "seen"}}, {{"name": "group", "children": [2, 3, 4, 5], {hidden}}},
        {{"mesh": 0, "extensions": {{"KHR_node_visibility": {{"visible": true}}}}}},
        {{"camera": 0, "name": "eye"}}, {{"extensions": {{"KHR_lights_punctual": {{"light": 0}}}}}},
        {{"mesh": 0, "extensions": {{"EXT_mesh_gpu_instancing": {{"attributes": {{"TRANSLATION": {at}}}}}}}}},
        {{"mesh": 0, "name": "shown", "extensions": {{"KHR_node_visibility": {{"visible": "no"}}}}}}"#
    );
    doc.rest = r#", "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}],
        "extensionsUsed": ["KHR_lights_punctual", "KHR_node_visibility"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "name": "lamp"}]}}"#
        .to_owned();
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    let names: Vec<&str> = scene.instances.iter().map(|instance| instance.name.as_str()).collect();
    assert_eq!((names, scene.cameras[0].name.as_str()), (vec!["seen", "shown"], "eye"));
    // The light is one that was added.
    assert_eq!(scene.lights[0].name, "sun");
    doc.nodes = format!(r#"{{"mesh": 0, {hidden}}}"#);
    let why = doc.load().unwrap_err().to_string();
    assert!(why.contains("no triangles in the scene; hidden nodes hide what the scene has"), "{why}");
}
