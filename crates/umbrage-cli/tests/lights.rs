//! Many lights, odd lights, and what casts nothing, as the command has them: what is said, what is drawn, what is judged.

#[expect(dead_code, reason = "other tests need more of it")]
mod common;

use std::path::PathBuf;

use common::umbrage;
use glam::{Mat4, Vec2, Vec3};
use serde_json::Value;
use tempfile::TempDir;
use umbrage_scene::{Camera, Instance, Light, Material, Mesh, Primitive, Scene, to_glb};

/// A box from −1 to 1 that is seen from both sides.
fn cube(material: usize) -> Primitive {
    let corner = |i: u32| Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32) * 2.0 - 1.0;
    let sides = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let mut cube = Primitive { material, ..Primitive::default() };
    for side in sides {
        let first = cube.positions.len() as u32;
        let [a, b, c, d] = side.map(corner);
        let normal = (a + b + c + d).normalize_or_zero();
        cube.positions.extend([a, b, c, d]);
        cube.normals.extend([normal; 4]);
        cube.uvs.extend([Vec2::ZERO; 4]);
        cube.indices.extend([0, 1, 2, 0, 2, 3].map(|i| first + i));
    }
    cube
}

/// A floor of 20 m, a crate of 2 m on it, and a camera that sees both, by these lights.
fn scene(lights: Vec<Light>) -> Scene {
    let named = |name: &str, mesh, place: Vec3, size: Vec3| Instance {
        name: name.to_owned(),
        ..Instance::still(mesh, Mat4::from_translation(place) * Mat4::from_scale(size))
    };
    Scene {
        name: "yard".to_owned(),
        meshes: vec![Mesh::new("slab", &[cube(0)]), Mesh::new("crate", &[cube(1)])],
        instances: vec![
            named("floor", 0, Vec3::NEG_Y, Vec3::new(10.0, 1.0, 10.0)),
            named("box", 1, Vec3::Y, Vec3::ONE),
        ],
        materials: vec![Material::plain("stone", 0.5, 0.5, 0.5), Material::plain("wood", 0.5, 0.3, 0.1)],
        cameras: vec![Camera::looking("main", Vec3::new(4.0, 5.0, 8.0), Vec3::ZERO, 0.8, 0.1, 100.0)],
        lights,
        ..Scene::default()
    }
}

fn sun() -> Light {
    Light::sun(Vec3::new(0.6, -0.7, 0.3), 3.0)
}

/// Writes a world, and returns where.
fn file(scene: &Scene) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("yard.glb");
    std::fs::write(&path, to_glb(scene).expect("a file")).expect("written");
    (folder, path)
}

/// Runs the command on a world: its status, stdout and stderr.
fn run(scene: &Scene, command: &str, more: &[&str]) -> (Option<i32>, String, String) {
    let (_folder, path) = file(scene);
    let world = path.to_string_lossy().into_owned();
    let output = umbrage(&[&[command, &world, "--size", "160x120"], more].concat());
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

/// What is measured, and the warnings.
fn measured(scene: &Scene, more: &[&str]) -> (Value, Vec<String>) {
    let (status, out, err) = run(scene, "measure", &[&["--frames", "0", "--json", "-"], more].concat());
    assert_eq!(status, Some(0), "{more:?}: {err}");
    let warnings = err.lines().filter(|line| line.starts_with("warning:")).map(str::to_owned).collect();
    (serde_json::from_str(&out).expect("JSON"), warnings)
}

fn number(of: &Value, pointer: &str) -> f64 {
    of.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("{pointer} in {of}"))
}

#[test]
fn the_17th_light_is_named_and_the_brightest_are_drawn_by_every_command() {
    // The first is the dimmest, and the last the nearest.
    let lamp = |i: u16| {
        Light::point(
            &format!("lamp {i}"),
            Vec3::new(0.5 * f32::from(i) - 4.0, 4.0, 0.25 * f32::from(i)),
            40.0,
            8.0,
        )
    };
    let lamps = scene((0..17).map(lamp).collect());
    for command in ["measure", "bench", "plan"] {
        let more = if command == "plan" { vec!["--json", "-"] } else { vec!["--frames", "1", "--json", "-"] };
        let few = ["--set", "resolution=64"];
        let (status, out, err) = run(&lamps, command, &[&more[..], &few[..]].concat());
        assert_eq!(status, Some(0), "{command}: {err}");
        let warnings: Vec<&str> = err.lines().filter(|line| line.contains("16 of 17 lights")).collect();
        assert_eq!(warnings.len(), 1, "{command}: {err}");
        assert!(warnings[0].ends_with("left out: \"lamp 0\""), "{command}: {err}");
        let json: Value = serde_json::from_str(&out).expect("JSON");
        if let Some(lights) = json["lights"].as_array() {
            assert_eq!(lights.len(), 16, "{command}");
        }
    }
    let (status, _, err) = run(&lamps, "plan", &["--light", "3", "--light", "lamp 0"]);
    assert_eq!((status, err.contains("warning")), (Some(0), false), "{err}");
}

#[test]
fn ten_thousand_lights_are_planned_in_a_moment() {
    let lamp = |i: u16| {
        Light::point(&format!("lamp {i}"), Vec3::new(f32::from(i % 100), 3.0, f32::from(i / 100)), 9.0, 8.0)
    };
    let start = std::time::Instant::now();
    let (status, out, err) = run(&scene((0..10_000).map(lamp).collect()), "plan", &["--json", "-"]);
    assert!(start.elapsed().as_secs() < 30, "{:?}", start.elapsed());
    assert_eq!(status, Some(0), "{err}");
    assert!(err.contains("16 of 10000 lights") && err.trim_end().ends_with("and 9976 more"), "{err}");
    assert!(err.lines().all(|line| line.len() < 1000), "lines are short: {err}");
    let plan: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(plan["lights"].as_array().map(Vec::len), Some(16));
    let (status, _, err) = run(&scene((0..10_000).map(lamp).collect()), "plan", &["--light", "lantern"]);
    assert!(
        status == Some(2) && err.contains("lantern") && err.trim_end().ends_with("and 9968 more"),
        "{err}"
    );
}

#[test]
fn odd_lights_are_named_and_the_others_shine() {
    let odd = |name: &str, intensity, range| Light::point(name, Vec3::new(0.0, 5.0, 4.0), range, intensity);
    let lights = vec![odd("minus", -1.0, 9.0), odd("huge", 1e30, 9.0), odd("short", 5.0, 0.0), sun()];
    let (measured, warnings) = measured(&scene(lights), &[]);
    for name in ["minus", "huge", "short"] {
        assert!(warnings.iter().any(|line| line.contains(name)), "{name}: {warnings:?}");
    }
    let names: Vec<_> =
        measured["lights"].as_array().expect("lights").iter().map(|of| of["name"].as_str()).collect();
    assert!(names.contains(&Some("sun")), "{names:?}");
    assert!(number(&measured, "/truth/shadowed") > 50.0, "{measured}");
    // Nothing shines, and the world is drawn all the same.
    for dark in
        [vec![odd("minus", -1.0, 9.0)], vec![odd("short", 5.0, 0.0)], vec![Light { intensity: 0.0, ..sun() }]]
    {
        let folder = tempfile::tempdir().expect("a folder");
        let picture = folder.path().join("a.png").to_string_lossy().into_owned();
        let (status, _, err) = run(&scene(dark), "render", &["-o", &picture, "--visibility", &picture]);
        assert!(status == Some(0) && err.contains("warning: "), "{err}");
    }
}

#[test]
fn what_is_named_casts_nothing_for_the_maps_and_for_the_judge() {
    let scene = scene(vec![sun()]);
    let (all, _) = measured(&scene, &[]);
    let shadowed = number(&all, "/truth/shadowed");
    assert!(shadowed > 100.0, "{all}");
    for name in ["box", "crate", "WOOD"] {
        let (none, _) = measured(&scene, &["--no-cast", name]);
        assert_eq!(number(&none, "/truth/shadowed"), 0.0, "{name}");
        assert!(number(&none, "/error/mae") < 1e-3, "{name}: {none}");
        let (again, _) = measured(&scene, &["--no-cast", name, "--cast", "floor"]);
        assert_eq!(number(&again, "/truth/shadowed"), 0.0, "{name}");
    }
    for command in ["render", "measure", "bench", "plan", "view"] {
        let out = if command == "render" { vec!["-o", "never.png"] } else { vec![] };
        let (status, _, err) = run(&scene, command, &[&["--no-cast", "boxes"], &out[..]].concat());
        assert_eq!(status, Some(2), "{command}: {err}");
        assert!(err.contains("`boxes`") && err.contains("box, "), "{command} lists what is like it: {err}");
    }
}

#[test]
fn a_sky_casts_nothing_and_is_no_part_of_the_maps() {
    let mut with_sky = scene(vec![sun()]);
    let views = |of: &Scene, more: &[&str]| {
        let (status, out, err) = run(of, "plan", &[&["--json", "-"], more].concat());
        assert_eq!(status, Some(0), "{err}");
        serde_json::from_str::<Value>(&out).expect("JSON")["views"].clone()
    };
    let without = views(&with_sky, &[]);
    with_sky.materials.push(Material { unlit: true, ..Material::plain("sky", 0.3, 0.5, 0.9) });
    with_sky.meshes.push(Mesh::new("dome", &[cube(2)]));
    // What is written says that it casts; a file by others says nothing.
    with_sky
        .instances
        .push(Instance { casts: false, ..Instance::still(2, Mat4::from_scale(Vec3::splat(60.0))) });
    assert_eq!(views(&with_sky, &[]), without, "the sky is not planned for");
    assert_ne!(views(&with_sky, &["--cast", "dome"]), without, "what casts is");
    let (open, _) = measured(&with_sky, &[]);
    assert!(number(&open, "/error/mis_shadowed") < 0.01, "{open}");
    let (closed, _) = measured(&with_sky, &["--cast", "dome"]);
    assert_eq!(number(&closed, "/truth/shadowed"), number(&closed, "/truth/pixels"), "all is dark");
}

#[test]
fn a_lamp_shines_out_of_its_bulb_where_the_file_or_the_command_says_how_near() {
    let lamp = |near| Light { near, ..Light::point("lamp", Vec3::new(2.0, 3.5, 0.0), 30.0, 8.0) };
    let with_bulb = |near| {
        let mut scene = scene(vec![lamp(near)]);
        let bulb = Mat4::from_translation(Vec3::new(2.0, 3.5, 0.0)) * Mat4::from_scale(Vec3::splat(0.05));
        scene.instances.push(Instance::still(1, bulb));
        scene
    };
    let (dark, _) = measured(&with_bulb(0.0), &[]);
    assert_eq!(number(&dark, "/truth/shadowed"), number(&dark, "/truth/pixels"), "{dark}");
    let (open, _) = measured(&scene(vec![lamp(0.0)]), &[]);
    // The bulb's corners are 0.087 m away.
    for (near, more) in [(0.1, &[][..]), (0.0, &["--near-light", "0.1"])] {
        let (lit, _) = measured(&with_bulb(near), more);
        let differ = number(&lit, "/truth/shadowed") - number(&open, "/truth/shadowed");
        assert!(differ.abs() < 0.01 * number(&open, "/truth/pixels"), "as without the bulb: {lit}");
        assert!(number(&lit, "/error/mis_shadowed") < 0.01, "the maps see it too: {lit}");
    }
}

#[test]
fn near_distances_are_metres() {
    let lamp = scene(vec![Light::point("lamp", Vec3::new(0.0, 3.5, 0.0), 30.0, 8.0)]);
    let (all, _) = measured(&lamp, &[]);
    assert!(number(&all, "/truth/shadowed") > 50.0, "{all}");
    // The crate's top is 1.5 m below the lamp, and its lowest corners 3.8 m away.
    let (none, _) = measured(&lamp, &["--near-light", "3.9"]);
    assert_eq!(number(&none, "/truth/shadowed"), 0.0, "{none}");
    for wrong in ["-1", "nan", "near", "1e99"] {
        let (status, _, err) = run(&lamp, "measure", &["--near-light", wrong]);
        assert!(status == Some(2) && err.contains("metres"), "{err}");
    }
}
