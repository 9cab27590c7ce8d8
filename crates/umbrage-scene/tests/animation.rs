//! What animations of a file move, hide and leave alone.

mod common;
#[path = "common/keys.rs"]
mod keys;
#[path = "common/numbers.rs"]
mod numbers;

use std::f32::consts::FRAC_1_SQRT_2;

use common::{Doc, floats};
use glam::{Mat4, Quat, Vec3};
use keys::{quads, scalars, vectors};
use numbers::shorts;
use umbrage_scene::rig::{Place, Rig};
use umbrage_scene::{Imported, Scene, Shining};

/// A channel of an animation: what it moves, the accessors of its sampler, and more members of that.
struct Channel<'a>(&'a str, usize, usize, &'a str);

/// Adds an animation.
fn animate(doc: &mut Doc, channels: &[Channel<'_>]) {
    let samplers: Vec<String> = channels
        .iter()
        .map(|Channel(_, input, output, more)| format!(r#"{{"input": {input}, "output": {output}{more}}}"#))
        .collect();
    let channels: Vec<String> = channels
        .iter()
        .enumerate()
        .map(|(i, Channel(target, ..))| format!(r#"{{"sampler": {i}, "target": {{{target}}}}}"#))
        .collect();
    let (samplers, channels) = (samplers.join(", "), channels.join(", "));
    doc.rest += &format!(
        r#", "animations": [{{"name": "walk", "samplers": [{samplers}], "channels": [{channels}]}}]"#
    );
}

fn pointer(to: &str) -> String {
    format!(r#""path": "pointer", "extensions": {{"KHR_animation_pointer": {{"pointer": "{to}"}}}}"#)
}

/// Where in the file the origin of the i-th instance is at a time.
fn place(scene: &Scene, i: usize, seconds: f32) -> Vec3 {
    local(scene, i, seconds) + scene.origin.as_vec3()
}

/// The same, measured from the scene's own origin.
fn local(scene: &Scene, i: usize, seconds: f32) -> Vec3 {
    scene.instances[i].world_from_mesh_in(&scene.pose(seconds)).w_axis.truncate()
}

fn assert_near(got: Vec3, want: Vec3, what: &str) {
    assert!(got.abs_diff_eq(want, 1e-5), "{what}: {got}, not {want}");
}

#[test]
fn meshes_and_lights_below_an_animated_node_move_and_cameras_stay() {
    let mut doc = Doc::triangle();
    let times = scalars(&mut doc, &[0.0, 2.0]);
    let moves = vectors(&mut doc, &[1.0, 0.0, 0.0, 3.0, 0.0, 0.0]);
    doc.nodes = r#"{"name": "cart", "children": [1, 2, 3]}, {"mesh": 0, "translation": [0, 1, 0]},
        {"name": "eye", "camera": 0}, {"scale": [2, 2, 2], "translation": [0, 5, 0],
            "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"mesh": 0, "translation": [7, 0, 0]}"#
        .to_owned();
    doc.rest = r#", "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}, "name": "lamp"}]}}"#
        .to_owned();
    animate(&mut doc, &[Channel(r#""node": 0, "path": "translation""#, times, moves, "")]);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, ["cameras stay where they are at the start of the first animation: eye"]);
    assert_eq!((scene.rig.nodes.len(), scene.rig.playing), (1, Some(0)), "only what moves is in the rig");
    assert_eq!((scene.rig.animations[0].seconds, scene.rig.animations[0].name.as_str()), (2.0, "walk"));
    assert_near(place(&scene, 0, 0.0), Vec3::new(1.0, 1.0, 0.0), "at the start");
    assert_near(
        scene.instances[0].world_from_mesh.w_axis.truncate() + scene.origin.as_vec3(),
        Vec3::new(1.0, 1.0, 0.0),
        "and written",
    );
    assert_near(place(&scene, 0, 1.5), Vec3::new(2.5, 1.0, 0.0), "later");
    assert_near(place(&scene, 0, 2.5), Vec3::new(1.5, 1.0, 0.0), "it begins again");
    assert!(!scene.instances[1].is_dynamic() && place(&scene, 1, 1.0) == Vec3::X * 7.0, "the other stays");
    assert_near(scene.cameras[0].eye() + scene.origin.as_vec3(), Vec3::X, "the camera");
    let lamp = scene.lights[0].world_from_light_in(&scene.pose(1.0));
    let want = Mat4::from_translation(Vec3::new(2.0, 5.0, 0.0) - scene.origin.as_vec3());
    assert!(lamp.abs_diff_eq(want, 1e-6), "rigid: {lamp}");
}

#[test]
fn steps_lines_and_splines_of_floats_and_integers_are_read() {
    let mut doc = Doc::triangle();
    let times = scalars(&mut doc, &[0.0, 1.0]);
    let moves = vectors(&mut doc, &[0.0, 0.0, 0.0, 4.0, 0.0, 0.0]);
    let half = FRAC_1_SQRT_2;
    let turns = doc.accessor(
        &shorts(&[0, 0, 0, 32767, 0, 0, 23170, 23170]),
        "",
        r#""count": 2, "componentType": 5122, "normalized": true, "type": "VEC4""#,
    );
    // Still at both ends.
    let spline = vectors(&mut doc, &[[0.0; 3], [1.0; 3], [0.0; 3], [0.0; 3], [3.0; 3], [0.0; 3]].concat());
    doc.nodes = r#"{"mesh": 0}, {"mesh": 0}, {"mesh": 0}"#.to_owned();
    animate(
        &mut doc,
        &[
            Channel(r#""node": 0, "path": "translation""#, times, moves, r#", "interpolation": "STEP""#),
            Channel(r#""node": 1, "path": "rotation""#, times, turns, r#", "interpolation": "LINEAR""#),
            Channel(r#""node": 2, "path": "scale""#, times, spline, r#", "interpolation": "CUBICSPLINE""#),
        ],
    );
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    let at = |i: usize, seconds: f32| scene.instances[i].world_from_mesh_in(&scene.pose(seconds));
    assert_eq!(place(&scene, 0, 0.99), Vec3::ZERO);
    let eighth = Quat::from_xyzw(0.0, 0.0, half, half).slerp(Quat::IDENTITY, 0.5);
    assert!(at(1, 0.5).abs_diff_eq(Mat4::from_quat(eighth), 1e-4), "{}", at(1, 0.5));
    assert!((at(2, 0.5).x_axis.x - 2.0).abs() < 1e-5 && (at(2, 0.25).x_axis.x - 1.3125).abs() < 1e-5);
}

#[test]
fn pointers_move_nodes_and_what_they_change_otherwise_is_one_warning() {
    let mut doc = Doc::triangle();
    let times = scalars(&mut doc, &[0.0, 1.0, 2.0]);
    let moves = vectors(&mut doc, &[0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 3.0, 0.0]);
    let seen = doc.accessor(&[0, 1, 0], "", r#""count": 3, "componentType": 5121, "type": "SCALAR""#);
    doc.nodes = r#"{"mesh": 0}, {"children": [2], "extensions": {"KHR_node_visibility": {"visible": false}}},
        {"mesh": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"extensions": {"KHR_node_visibility": {"visible": false}}, "children": [4]}, {"mesh": 0}"#
        .to_owned();
    doc.rest =
        r#", "extensionsUsed": ["KHR_lights_punctual", "KHR_animation_pointer", "KHR_node_visibility"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}, {"type": "directional"}]}}"#
            .to_owned();
    let (colour, factor) =
        (pointer("/extensions/KHR_lights_punctual/lights/0/color"), pointer("/materials/0/emissiveFactor"));
    let (up, visible) =
        (pointer("/nodes/0/translation"), pointer("/nodes/1/extensions/KHR_node_visibility/visible"));
    animate(
        &mut doc,
        &[
            Channel(&colour, times, moves, ""),
            Channel(&up, times, moves, ""),
            Channel(&factor, times, moves, ""),
            Channel(&visible, times, seen, r#", "interpolation": "STEP""#),
        ],
    );
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(
        warnings,
        [
            "animated pointers that are not about what casts are ignored: /extensions/KHR_lights_punctual/lights/0/color, /materials/0/emissiveFactor"
        ]
    );
    assert_near(place(&scene, 0, 0.5), Vec3::Y * 1.5, "moved by a pointer");
    assert_eq!(scene.instances.len(), 2, "what is never shown is not placed");
    for (seconds, shown) in [(0.5, false), (1.0, true), (1.9, true), (2.1, false)] {
        let pose = scene.pose(seconds);
        assert_eq!(scene.instances[1].is_visible_in(&pose), shown, "{seconds} s");
        let shining = Shining::choose(&scene.lights, &scene.cameras[0], &pose, 16);
        assert_eq!(shining.lights[0].intensity > 0.0, shown, "{seconds} s");
        assert_eq!(shining.warnings, [""; 0]);
    }
    assert!(!scene.instances[1].is_visible_in(&scene.rig.pose_of(None, 1.0)), "hidden at rest");
}

#[test]
fn an_animation_of_nothing_that_casts_leaves_no_animation() {
    let mut doc = Doc::triangle();
    let times = scalars(&mut doc, &[0.0]);
    animate(&mut doc, &[Channel(&pointer("/materials/0/alphaCutoff"), times, times, "")]);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!((scene.rig, warnings.len()), (Rig::default(), 1));
}

#[test]
fn channels_that_cannot_be_read_are_left_out_one_by_one() {
    type Spoil = fn(&mut Doc) -> (String, usize, usize, &'static str);
    let spoils: [(&str, Spoil); 12] = [
        ("times go back at key 1, from 1 s to 0.5 s", |d| {
            (target(0), scalars(d, &[1.0, 0.5]), vectors(d, &[0.0; 6]), "")
        }),
        ("the time of key 1 is NaN s", |d| {
            (target(0), scalars(d, &[1.0, f32::NAN]), vectors(d, &[0.0; 6]), "")
        }),
        ("2 times and 3 values, need 2", |d| (target(0), scalars(d, &[0.0, 1.0]), vectors(d, &[0.0; 9]), "")),
        ("2 times and 2 values, need 6", |d| {
            (target(0), scalars(d, &[0.0, 1.0]), vectors(d, &[0.0; 6]), r#", "interpolation": "CUBICSPLINE""#)
        }),
        ("0 times and 0 values", |d| (target(0), scalars(d, &[]), vectors(d, &[]), "")),
        ("its values reach", |d| (target(0), scalars(d, &[0.0]), vectors(d, &[f32::NAN; 3]), "")),
        ("need at most 1e12", |d| (target(0), scalars(d, &[0.0]), vectors(d, &[1e30; 3]), "")),
        ("node 9 of 2 is not there", |d| (target(9), scalars(d, &[0.0]), vectors(d, &[0.0; 3]), "")),
        ("need unit quaternions", |d| {
            let rotation = r#""node": 0, "path": "rotation""#.to_owned();
            (rotation, scalars(d, &[0.0]), quads(d, &[0.0; 4]), "")
        }),
        ("accessor 77 of", |d| (target(0), 77, vectors(d, &[0.0; 3]), "")),
        ("its interpolation is \"WOBBLE\"", |d| {
            (target(0), scalars(d, &[0.0]), vectors(d, &[0.0; 3]), r#", "interpolation": "WOBBLE""#)
        }),
        ("its node has no morph targets", |d| {
            (r#""node": 0, "path": "weights""#.to_owned(), scalars(d, &[0.0]), scalars(d, &[1.0]), "")
        }),
    ];
    for (says, spoil) in spoils {
        let mut doc = Doc::triangle();
        doc.nodes = r#"{"mesh": 0}, {"mesh": 0}"#.to_owned();
        let (times, moves) =
            (scalars(&mut doc, &[0.0, 1.0]), vectors(&mut doc, &[0.0, 0.0, 0.0, 8.0, 0.0, 0.0]));
        let (what, input, output, more) = spoil(&mut doc);
        animate(&mut doc, &[Channel(&what, input, output, more), Channel(&target(1), times, moves, "")]);
        let Imported { scene, warnings } = doc.load().unwrap();
        assert!(warnings.len() == 1 && warnings[0].contains(says), "{says}: {warnings:?}");
        assert!(warnings[0].contains("channel 0 of animation \"walk\""), "{warnings:?}");
        assert_near(place(&scene, 0, 0.5), Vec3::ZERO, says);
        assert_near(place(&scene, 1, 0.5), Vec3::X * 4.0, says);
    }
}

fn target(node: usize) -> String {
    format!(r#""node": {node}, "path": "translation""#)
}

#[test]
fn counts_that_lie_and_keys_that_are_shared_a_million_times_stay_within_bounds() {
    let mut doc = Doc::triangle();
    let view = doc.view(&floats(&[0.0]), "");
    doc.accessors.push(format!(
        r#"{{"bufferView": {view}, "count": 18446744073709551615, "componentType": 5126, "type": "SCALAR"}}"#
    ));
    // Rows of no bytes cost the file nothing.
    doc.accessors.push(r#"{"count": 16777216, "componentType": 5126, "type": "VEC3"}"#.to_owned());
    doc.accessors.push(r#"{"count": 16777216, "componentType": 5126, "type": "SCALAR"}"#.to_owned());
    let (lie, moves, times) = (1, 2, 3);
    let target = target(0);
    let mut channels = vec![Channel(&target, lie, moves, "")];
    channels.extend((0..1000).map(|_| Channel(&target, times, moves, "")));
    animate(&mut doc, &channels);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert!(
        warnings.len() == 1 && warnings[0].contains("more than 67108864 numbers in keys"),
        "{warnings:?}"
    );
    let channels: usize = scene.rig.animations.iter().map(|animation| animation.channels.len()).sum();
    assert!(channels <= 1, "{channels} channels");
}

#[test]
fn poses_of_no_length_keys_at_one_time_and_times_before_the_start_are_poses() {
    for (times, moves, seconds, at_2) in [
        (&[0.0][..], &[5.0][..], 0.0, 5.0),
        (&[0.0, 0.0], &[5.0, 6.0], f32::from_bits(1), 5.0),
        (&[1.0], &[5.0], 1.0, 5.0),
        (&[-3.0, -1.0], &[4.0, 5.0], 0.0, 5.0),
        (&[0.0, 2.0, 2.0, 4.0], &[0.0, 1.0, 3.0, 3.0], 4.0, 1.0),
    ] {
        let mut doc = Doc::triangle();
        let moves: Vec<f32> = moves.iter().flat_map(|x| [*x, 0.0, 0.0]).collect();
        let (input, output) = (scalars(&mut doc, times), vectors(&mut doc, &moves));
        animate(&mut doc, &[Channel(&target(0), input, output, "")]);
        let Imported { scene, warnings } = doc.load().unwrap();
        assert_eq!(warnings, [""; 0], "{times:?}");
        assert_eq!(scene.rig.animations[0].seconds, seconds, "{times:?}");
        assert_near(place(&scene, 0, 2.0), Vec3::X * at_2, "after 2 s");
    }
}

#[test]
fn what_moves_far_from_the_origin_moves_smoothly() {
    let far = 100_000.0;
    for nodes in [
        // The animated node is outermost.
        format!(r#"{{"mesh": 0}}, {{"mesh": 0, "translation": [{far}, 0, 0]}}"#),
        // It hangs on one that only moves it,
        format!(
            r#"{{"mesh": 0}}, {{"mesh": 0, "translation": [{far}, 0, 0]}}, {{"children": [0], "translation": [0, 2, 0]}}"#
        ),
        // or on one that turns it.
        format!(
            r#"{{"mesh": 0}}, {{"mesh": 0, "translation": [{far}, 0, 0]}}, {{"children": [0], "rotation": [1, 0, 0, 0]}}"#
        ),
    ] {
        let mut doc = Doc::triangle();
        let (times, moves) =
            (scalars(&mut doc, &[0.0, 1.0]), vectors(&mut doc, &[far, 0.0, 0.0, far + 1.0, 0.0, 0.0]));
        doc.nodes = nodes.clone();
        animate(&mut doc, &[Channel(&target(0), times, moves, "")]);
        let Imported { scene, warnings } = doc.load().unwrap();
        assert_eq!(warnings, [""; 0], "{nodes}");
        let own = (scene.origin.x - f64::from(far)) as f32;
        let moving = usize::from(!scene.instances[0].is_dynamic());
        assert!((own - 0.5).abs() <= 0.5, "{nodes}: {own}");
        for millimetre in [0u8, 1, 2, 100] {
            let share = f32::from(millimetre) * 0.001;
            let x = local(&scene, moving, share).x + own;
            assert!((x - share).abs() < 1e-6, "{nodes}: {x}");
        }
    }
}

#[test]
fn a_thing_far_below_a_moving_node_keeps_its_digits() {
    let mut doc = Doc::triangle();
    let (times, moves) = (scalars(&mut doc, &[0.0]), vectors(&mut doc, &[0.0, 1.0, 0.0]));
    doc.nodes = r#"{"children": [1]}, {"mesh": 0, "translation": [100000.001, 0, 0]},
        {"mesh": 0, "translation": [100000, 0, 0]}"#
        .to_owned();
    animate(&mut doc, &[Channel(&target(0), times, moves, "")]);
    let scene = doc.load().unwrap().scene;
    let apart = local(&scene, 0, 0.0) - local(&scene, 1, 0.0);
    assert!(apart.abs_diff_eq(Vec3::new(0.001, 1.0, 0.0), 1e-6), "{apart}");
}

#[test]
fn a_matrix_that_is_animated_is_taken_apart() {
    for (matrix, lost) in [
        ("[0,2,0,0, -2,0,0,0, 0,0,2,0, 5,6,7,1]", false),
        ("[1,0,0,0, 1,1,0,0, 0,0,1,0, 5,6,7,1]", true),
        ("[-1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1]", false),
        ("[0,0,0,0, 0,0,0,0, 0,0,0,0, 5,6,7,1]", true),
    ] {
        let mut doc = Doc::triangle();
        let (times, moves) = (scalars(&mut doc, &[0.0]), vectors(&mut doc, &[1.0, 1.0, 1.0]));
        doc.nodes = format!(r#"{{"mesh": 0, "matrix": {matrix}}}, {{"mesh": 0}}"#);
        animate(&mut doc, &[Channel(&target(0), times, moves, "")]);
        let Imported { scene, warnings } = doc.load().unwrap();
        assert_eq!(warnings.len(), usize::from(lost), "{matrix}: {warnings:?}");
        assert_near(place(&scene, 0, 0.0), Vec3::ONE, matrix);
        assert!(matches!(scene.rig.nodes[0].rest, Place::Parts { .. }), "{matrix}");
        let rest = scene.rig.pose_of(None, 0.0).world_from_node(0).determinant();
        assert!(lost || (rest - 8.0).abs() < 1e-3 || (rest + 1.0).abs() < 1e-3, "{matrix}: {rest}");
    }
}

#[test]
fn what_shrinks_to_nothing_comes_back() {
    let mut doc = Doc::triangle();
    let (times, sizes) = (scalars(&mut doc, &[0.0, 1.0]), vectors(&mut doc, &[0.0, 0.0, 0.0, 2.0, 2.0, 2.0]));
    doc.nodes = r#"{"mesh": 0}, {"mesh": 0}"#.to_owned();
    animate(&mut doc, &[Channel(r#""node": 0, "path": "scale""#, times, sizes, "")]);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!((scene.instances.len(), warnings.len()), (2, 0));
    let at = |seconds: f32| scene.instances[0].world_from_mesh_in(&scene.pose(seconds));
    assert!(at(0.0).inverse().is_finite() && at(0.0).x_axis.x < 1e-6, "{}", at(0.0));
    assert_eq!(at(0.5).x_axis.x, 1.0);
}

#[test]
fn a_scene_that_is_hidden_at_the_start_is_seen_by_its_camera() {
    let mut doc = Doc::triangle();
    let times = scalars(&mut doc, &[0.0, 1.0, 2.0]);
    let seen = doc.accessor(&[0, 1, 1], "", r#""count": 3, "componentType": 5121, "type": "SCALAR""#);
    let visible = pointer("/nodes/0/extensions/KHR_node_visibility/visible");
    animate(&mut doc, &[Channel(&visible, times, seen, "")]);
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    assert!(scene.bounds_in(&scene.pose(0.0)).is_empty(), "hidden");
    let camera = &scene.cameras[0];
    let seen =
        camera.world_from_camera.inverse().transform_point3(scene.bounds_in(&scene.pose(1.0)).centre());
    assert!(-seen.z > camera.near && -seen.z < camera.far && seen.truncate().length() < 1.0, "{seen}");
}

#[test]
fn what_an_animation_throws_beyond_all_bounds_is_not_what_the_camera_looks_at() {
    // At rest it is as large as a small town.
    for (nodes, what) in [
        (r#"{"mesh": 0}, {"children": [2]}, {"mesh": 0, "scale": [1e3, 1e3, 1e3]}"#, "1e15 m"),
        (r#"{"mesh": 0}, {"children": [2]}, {"mesh": 0, "scale": [1e10, 1e10, 1e10]}"#, "1e22 m"),
        (r#"{"mesh": 0}, {"children": [2]}, {"mesh": 0, "scale": [1e-9, 1e4, 1]}"#, "a needle"),
    ] {
        let mut doc = Doc::triangle();
        let times = scalars(&mut doc, &[0.0]);
        let scales = vectors(&mut doc, &[1e12, 1e12, 1e12]);
        doc.nodes = nodes.to_owned();
        animate(&mut doc, &[Channel(r#""node": 1, "path": "scale""#, times, scales, "")]);
        let Imported { scene, warnings } = doc.load().unwrap();
        let camera = &scene.cameras[0];
        assert!(camera.far.is_finite() && camera.near < 1.0, "{what}: {camera:?}, {warnings:?}");
        let eye = camera.world_from_camera.w_axis.truncate();
        assert!(eye.length() < 10.0, "{what}: {camera:?}");
        umbrage_scene::to_glb(&scene).unwrap();
    }
}

#[test]
fn what_hangs_on_nodes_that_stand_beyond_all_bounds_is_hidden() {
    for (above, told) in [
        (r#""scale": [1e30, 1e30, 1e30]"#, 1),
        (r#""translation": [1e35, 0, 0]"#, 1),
        (r#""matrix": [1e30,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]"#, 1),
        (r#""scale": [1e11, 1e11, 1e11]"#, 0),
    ] {
        let mut doc = Doc::triangle();
        let times = scalars(&mut doc, &[0.0, 1.0]);
        let scales = vectors(&mut doc, &[1.0, 1.0, 1.0, 2.0, 2.0, 2.0]);
        doc.nodes = format!(
            r#"{{"mesh": 0}}, {{"children": [2], {above}}}, {{"children": [3], {above}}},
            {{"children": [4]}}, {{"mesh": 0, "scale": [1e-20, 1e-20, 1e-20]}}"#
        );
        animate(&mut doc, &[Channel(r#""node": 3, "path": "scale""#, times, scales, "")]);
        let Imported { scene, warnings } = doc.load().unwrap();
        umbrage_scene::to_glb(&scene).unwrap_or_else(|why| panic!("{above}: {why}"));
        let hidden = warnings.iter().filter(|line| line.contains("is hidden") || line.contains("too far"));
        assert!(hidden.count() >= told, "{above}: {warnings:?}");
    }
}
