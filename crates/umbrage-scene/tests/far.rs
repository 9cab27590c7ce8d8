//! The same scene, moved by kilometres and scaled by thousands, is the same scene around an origin of its own.

mod common;

use common::{CORNERS, Doc, floats};
use glam::{DVec3, Mat4, Vec3};
use proptest::prelude::*;
use umbrage_scene::{Imported, Motion, Scene, load_glb_bytes, load_obj_bytes, to_glb};

/// A small court around its origin: triangles that stand and lie, a camera, a lamp that moves, and a path. Everything
/// hangs on a node that is moved and scaled; what is in extras is in the file's coordinates.
fn court(moved: DVec3, scale: f64) -> Doc {
    let mut doc = Doc::triangle();
    let point = |x: f64, y: f64, z: f64| {
        let p = moved + DVec3::new(x, y, z) * scale;
        format!("[{:?}, {:?}, {:?}]", p.x, p.y, p.z)
    };
    let turn = format!(
        r#"{{"umbrage": {{"turn": {{"centre": {}, "axis": [0, 1, 0], "radians_per_second": 0.5}}}}}}"#,
        point(1.0, 0.25, -2.0)
    );
    doc.nodes = format!(
        r#"{{"children": [1, 2, 3, 4], "translation": {}, "scale": [{scale:?}, {scale:?}, {scale:?}]}},
        {{"mesh": 0, "translation": [-0.3, 0.7, 0.1], "rotation": [0.6, 0, 0, 0.8], "extras": {turn}}},
        {{"mesh": 0, "translation": [-3.5, -1.25, -2], "scale": [9, 1, 9]}},
        {{"camera": 0, "translation": [0.1, 2.3, 6.7]}},
        {{"extensions": {{"KHR_lights_punctual": {{"light": 0}}}}, "translation": [0.4, 3.3, 0.2], "extras": {turn}}}"#,
        point(0.0, 0.0, 0.0)
    );
    doc.rest = format!(
        r#", "scenes": [{{"nodes": [0], "extras": {{"umbrage": {{"path": [[{}, {}]]}}}}}}],
        "cameras": [{{"type": "perspective", "perspective": {{"yfov": 1, "znear": 0.1, "zfar": 50}}}}],
        "extensions": {{"KHR_lights_punctual": {{"lights": [{{"type": "point"}}]}}}}"#,
        point(0.0, 2.0, 8.0),
        point(0.0, 1.0, 0.0)
    );
    doc
}

/// Every place of a scene in its file, as the scene's own number and in f64.
fn places(scene: &Scene) -> Vec<(f32, f64)> {
    let mut points: Vec<Vec3> = Vec::new();
    for instance in &scene.instances {
        let positions = &scene.meshes[instance.mesh].positions;
        assert!(positions.iter().all(|p| p.length() < 10.0), "meshes are not moved");
        points.push(instance.world_from_mesh.w_axis.truncate());
        if let Motion::Rotation { centre, .. } = instance.motion {
            points.push(centre);
        }
    }
    points.extend(scene.cameras.iter().map(|camera| camera.eye()));
    points.extend(scene.lights.iter().map(|light| light.position()));
    for light in &scene.lights {
        if let Motion::Rotation { centre, .. } = light.motion {
            points.push(centre);
        }
    }
    points.extend(scene.path.keys.iter().flat_map(|key| [key.eye, key.target]));
    let axis = |p: Vec3, axis: usize| (p[axis], scene.origin[axis] + f64::from(p[axis]));
    points.into_iter().flat_map(|p| [0, 1, 2].map(|i| axis(p, i))).collect()
}

fn read(doc: &Doc) -> Scene {
    let Imported { scene, warnings } = doc.load().unwrap();
    assert_eq!(warnings, [""; 0]);
    scene
}

/// The turns and scales of everything, which no move may change.
fn axes(scene: &Scene) -> Vec<Mat4> {
    let no_place = |mut m: Mat4| {
        m.w_axis = glam::Vec4::W;
        m
    };
    let instances = scene.instances.iter().map(|instance| no_place(instance.world_from_mesh));
    instances.chain(scene.cameras.iter().map(|camera| no_place(camera.world_from_camera))).collect()
}

#[test]
fn a_court_moved_by_powers_of_two_is_the_same_to_the_bit() {
    let here = read(&court(DVec3::ZERO, 1.0));
    assert_eq!(here.origin, DVec3::ZERO, "it stands around its origin");
    for power in 4..21 {
        for direction in [DVec3::X, DVec3::new(1.0, 0.0, -1.0), DVec3::NEG_ONE] {
            let moved = direction * f64::from(power).exp2();
            let there = read(&court(moved, 1.0));
            assert_eq!(axes(&there), axes(&here), "by {moved}");
            // The new origin is amid the court, which is not at its zero.
            let rest = there.origin - moved;
            assert!(rest.length() < 8.0 && rest == rest.round(), "the origin is {}", there.origin);
            for ((own, far), (_, near)) in places(&there).into_iter().zip(places(&here)) {
                let error = (far - moved_axis(moved, far, near) - near).abs();
                let ulp = f64::from(own.abs().max(1.0).next_up() - own.abs().max(1.0));
                assert!(error <= ulp, "{far} is {near} moved by {moved}, off by {error}");
            }
        }
    }
}

/// The axis of the move that took `near` to `far`.
fn moved_axis(moved: DVec3, far: f64, near: f64) -> f64 {
    let off = |axis: &f64| (far - near - axis).abs();
    moved.to_array().into_iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or_default()
}

#[test]
fn a_court_that_was_moved_is_not_moved_where_its_middle_is_its_origin() {
    // Nothing but a node with a power of two: all bits are those of the court at the file's origin.
    let symmetric = |at: f64| {
        let mut doc = Doc::triangle();
        doc.nodes = format!(
            r#"{{"children": [1, 2], "translation": [{at:?}, 0, 0]}}, {{"mesh": 0, "translation": [0.1, -0.3, 0.7]}},
            {{"mesh": 0, "rotation": [0, 0, 1, 0], "translation": [-0.1, 0.3, -0.7]}}"#
        );
        read(&doc)
    };
    let here = symmetric(0.0);
    for power in 2..21 {
        let there = symmetric(f64::from(power).exp2());
        assert_eq!(there.origin.x, f64::from(power).exp2());
        assert_eq!(there.instances, here.instances, "by 2^{power}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn moved_and_scaled_scenes_are_the_same_to_an_ulp(
        distance in 0.0f64..6.0,
        direction in [-1.0f64..1.0, -1.0f64..1.0, -1.0f64..1.0],
        scale in -3.0f64..3.0,
    ) {
        let moved = DVec3::from(direction) * 10f64.powf(distance);
        let scale = 10f64.powf(scale);
        let there = read(&court(moved, scale));
        let here = read(&court(DVec3::ZERO, scale));
        let size = there.bounds_in(&there.pose(0.0)).size().max_element();
        // Everything is within a few sizes of the origin, so f32 of it is as exact as f32 of a court at the file's.
        let ulp = f64::from(size) * 8.0 * f64::from(f32::EPSILON) + moved.length() * f64::EPSILON * 4.0;
        for ((own, far), (_, near)) in places(&there).into_iter().zip(places(&here)) {
            prop_assert!(f64::from(own.abs()) <= 8.0 * f64::from(size), "{} of {}", own, size);
            let error = (far - moved_axis(moved, far, near) - near).abs();
            prop_assert!(error <= ulp, "{} is {} moved by {}, off by {} of {}", far, near, moved, error, ulp);
        }
    }

    #[test]
    fn far_scenes_survive_their_files(
        distance in 0.0f64..6.0,
        direction in [-1.0f64..1.0, -1.0f64..1.0, -1.0f64..1.0],
        scale in -3.0f64..3.0,
    ) {
        let scene = read(&court(DVec3::from(direction) * 10f64.powf(distance), 10f64.powf(scale)));
        let bytes = to_glb(&scene).unwrap();
        let Imported { scene: again, warnings } = load_glb_bytes(&bytes, "doc.glb").unwrap();
        prop_assert_eq!(warnings, [""; 0]);
        prop_assert_eq!(again.origin, scene.origin);
        prop_assert_eq!(&again.instances, &scene.instances);
        prop_assert_eq!(&again.cameras, &scene.cameras);
        prop_assert_eq!(&again.lights, &scene.lights);
        prop_assert_eq!(&again.path, &scene.path);
        prop_assert_eq!(to_glb(&again).unwrap(), bytes);
    }
}

#[test]
fn far_vertices_are_rebased_exactly_and_told_where_they_are_coarse() {
    for (at, coarse) in [(10.0f32, None), (1000.0, None), (20_000.0, Some("0.00195")), (1e6, Some("0.0625"))]
    {
        let mut doc = Doc::triangle();
        let corners: Vec<f32> =
            CORNERS.iter().enumerate().map(|(i, x)| if i % 3 == 2 { x + at } else { *x }).collect();
        doc.accessors.clear();
        doc.accessor(&floats(&corners), "", r#""count": 3, "componentType": 5126, "type": "VEC3""#);
        let Imported { scene, warnings } = doc.load().unwrap();
        let instance = &scene.instances[0];
        let z = scene.origin.z
            + f64::from(instance.world_from_mesh.w_axis.z)
            + f64::from(scene.meshes[0].positions[0].z);
        assert_eq!(z, f64::from(at), "the place in the file");
        match coarse {
            None => assert_eq!(warnings, [""; 0], "at {at}"),
            Some(says) => assert!(
                warnings.len() == 1 && warnings[0].contains(&format!("to {says} m in mesh \"mesh 0\"")),
                "at {at}: {warnings:?}"
            ),
        }
    }
}

#[test]
fn a_mesh_and_its_node_that_undo_each_other_are_drawn_at_the_origin() {
    let mut doc = Doc::triangle();
    let corners: Vec<f32> = CORNERS.iter().map(|x| x + 65536.0).collect();
    doc.accessors.clear();
    doc.accessor(&floats(&corners), "", r#""count": 3, "componentType": 5126, "type": "VEC3""#);
    doc.nodes = r#"{"mesh": 0, "translation": [-65536, -65536, -65536]}"#.to_owned();
    let scene = doc.load().unwrap().scene;
    let at = scene.instances[0].world_from_mesh.transform_point3(scene.meshes[0].positions[0]);
    assert_eq!((scene.origin, at), (DVec3::ZERO, Vec3::ZERO));
    assert!(scene.meshes[0].bounds.max.max_element() < 2.0, "{:?}", scene.meshes[0].bounds);
}

#[test]
fn far_objects_keep_the_digits_of_their_text() {
    let text = "v 500000.001 10.002 0\nv 500001.003 10 0\nv 500000 11.004 0.005\nf 1 2 3\n";
    let Imported { scene, warnings } = load_obj_bytes(text.as_bytes(), "far.obj").unwrap();
    assert_eq!(warnings, [""; 0]);
    let world = |i: usize| {
        scene.origin
            + scene.instances[0].world_from_mesh.transform_point3(scene.meshes[0].positions[i]).as_dvec3()
    };
    assert!(world(0).abs_diff_eq(DVec3::new(500_000.001, 10.002, 0.0), 1e-6), "{}", world(0));
    assert!(world(1).abs_diff_eq(DVec3::new(500_001.003, 10.0, 0.0), 1e-6), "{}", world(1));
    assert!(world(2).abs_diff_eq(DVec3::new(500_000.0, 11.004, 0.005), 1e-6), "{}", world(2));
}

#[test]
fn a_file_may_say_where_its_origin_is() {
    let mut doc = court(DVec3::X * 1000.0, 1.0);
    doc.rest = doc.rest.replace(r#"{"path""#, r#"{"origin": [1001, 0, 0.5], "path""#);
    assert_eq!(read(&doc).origin, DVec3::new(1001.0, 0.0, 0.5));
    doc.rest = doc.rest.replace("1001, 0, 0.5", "0, 0, 0");
    let scene = read(&doc);
    assert_eq!((scene.origin, scene.path.keys[0].eye.x), (DVec3::ZERO, 1000.0));
}

#[test]
fn the_added_camera_and_the_origin_look_past_strays() {
    let town = |stray: &str| {
        let mut doc = Doc::triangle();
        let houses: Vec<String> = (0..9)
            .map(|i| {
                format!(r#"{{"mesh": 0, "translation": [{}, 0, {}]}}"#, 100_000 + 3 * (i / 3), 3 * (i % 3))
            })
            .collect();
        doc.nodes = houses.join(",") + stray;
        doc.load().unwrap()
    };
    let Imported { scene: alone, warnings } = town("");
    assert_eq!(warnings, [""; 0]);
    for stray in ["[109000, 0, 0]", "[100000, -9000, 0]", "[0, 0, 0]"] {
        let Imported { scene, warnings } = town(&format!(r#", {{"mesh": 0, "translation": {stray}}}"#));
        assert_eq!(scene.origin, alone.origin, "{stray}");
        let (camera, want) = (&scene.cameras[0], &alone.cameras[0]);
        assert_eq!((camera.world_from_camera, camera.near), (want.world_from_camera, want.near), "{stray}");
        let far = scene.bounds_in(&scene.pose(0.0));
        let corner = |i: usize| camera.eye().distance(if i == 0 { far.min } else { far.max });
        assert!(camera.far > corner(0).max(corner(1)), "{} behind {far:?}", camera.far);
        assert_eq!(scene.path.keys.last().map(|key| key.eye), alone.path.keys.last().map(|key| key.eye));
        assert_eq!(warnings.len(), 1, "{warnings:?}");
    }
}
