//! `--time` and `--animation`, wherever a world is named.

mod common;
#[path = "common/refusals.rs"]
mod refusals;

use std::path::{Path, PathBuf};

use common::{stdout, text};
use glam::{Mat4, Quat, Vec3};
use refusals::{folder, refused};
use umbrage_scene::rig::{Animation, Channel, Node, Place, Rig, Track};
use umbrage_scene::{Curve, Instance, Keys, Motion, load, to_glb, worlds};

/// A built-in world whose first instance an animation lifts by 4 m in two seconds, and another turns.
fn lifted(folder: &Path) -> PathBuf {
    let mut scene = worlds::build("primitives", 0).expect("a built-in world");
    let still = scene.instances[0].clone();
    let node_from_thing = still.world_from_mesh;
    let name = still.name.clone();
    scene.instances[0] =
        Instance { motion: Motion::Node { node: 0, node_from_thing }, node: Some(0), name, ..still };
    let up = Curve::new(vec![0.0, 2.0], Keys::Linear(vec![Vec3::ZERO, Vec3::Y * 4.0])).expect("a curve");
    let half = Keys::Step(vec![Quat::from_rotation_y(std::f32::consts::PI)]);
    let turned = Curve::new(vec![0.0], half).expect("a curve");
    let animation = |name: &str, seconds: f32, track: Track| Animation {
        name: name.to_owned(),
        seconds,
        channels: vec![Channel { node: 0, track }],
    };
    scene.rig = Rig {
        nodes: vec![Node {
            name: "lift".to_owned(),
            parent: None,
            rest: Place::HERE,
            visible: true,
            weights: Vec::new(),
        }],
        skins: Vec::new(),
        animations: vec![
            animation("Up", 2.0, Track::Translation(up)),
            animation("", 0.0, Track::Rotation(turned)),
        ],
        playing: Some(0),
    };
    let file = folder.join("lifted.glb");
    std::fs::write(&file, to_glb(&scene).expect("a file")).expect("written");
    file
}

#[test]
fn an_animation_is_chosen_by_name_or_number_and_others_are_refused_with_those_there_are() {
    let folder = folder();
    let file = lifted(folder.path());
    let file = text(&file);
    for wanted in ["up", "1", "none"] {
        stdout(&["plan", file, "--animation", wanted, "--time", "1.5"]);
    }
    let says = "no animation `down`; there are 0 (Up), 1 (), or none";
    refused(&["plan", file, "--animation", "down"], 2, says, None);
    refused(&["plan", "bunny", "--animation", "0"], 2, "no animation `0`; there is none here", None);
    refused(
        &["worlds", "export", file, "x.glb", "--bake", "--time", "inf"],
        2,
        "--time must be finite, got inf s",
        Some(Path::new("x.glb")),
    );
}

#[test]
fn a_baked_world_stands_as_its_animation_does_at_that_time() {
    let folder = folder();
    let file = lifted(folder.path());
    let still = load(&file).expect("a world").scene;
    let rest = still.instances[0].world_from_mesh_in(&still.rig.pose_of(None, 0.0));
    let baked = folder.path().join("baked.glb");
    for (animation, time, want) in [
        ("0", "1.5", Mat4::from_translation(Vec3::Y * 3.0)),
        ("1", "7", Mat4::from_rotation_y(std::f32::consts::PI)),
        ("none", "1.5", Mat4::IDENTITY),
    ] {
        let args = ["worlds", "export", text(&file), text(&baked), "--bake"];
        stdout(&[&args[..], &["--animation", animation, "--time", time]].concat());
        let scene = load(&baked).expect("a world").scene;
        assert!(scene.rig.nodes.is_empty() && !scene.instances[0].is_dynamic(), "still");
        let got = scene.instances.iter().map(|instance| instance.world_from_mesh);
        let is_there = |at: Mat4| at.abs_diff_eq(want * rest, 1e-4);
        assert!(
            got.into_iter().any(is_there),
            "{animation} at {time} s: {}",
            scene.instances[0].world_from_mesh
        );
    }
}

#[test]
fn an_exported_world_plays_the_animation_that_was_chosen() {
    let folder = folder();
    let file = lifted(folder.path());
    let again = folder.path().join("again.glb");
    for (animation, playing) in [("1", Some(1)), ("none", None), ("Up", Some(0))] {
        stdout(&["worlds", "export", text(&file), text(&again), "--animation", animation]);
        let rig = load(&again).expect("a world").scene.rig;
        assert_eq!((rig.playing, rig.animations.len()), (playing, 2), "{animation}");
    }
}

#[test]
fn suns_go_around_where_a_day_is_asked_for_and_stand_elsewhere() {
    let folder = folder();
    let baked = folder.path().join("baked.glb");
    let sun_of = |world: &str, when: &[&str]| {
        let args = ["worlds", "export", world, text(&baked), "--bake"];
        stdout(&[&args[..], when].concat());
        load(&baked).expect("a world").scene.lights[0].direction()
    };
    for world in ["primitives", "huge-chessboard"] {
        let start = sun_of(world, &[]);
        assert!(sun_of(world, &["--time", "60"]).abs_diff_eq(start, 1e-6), "{world}: it stands");
        assert!(sun_of(world, &["--day", "600"]).abs_diff_eq(start, 1e-6), "{world}: at time 0");
        let later = sun_of(world, &["--day", "600", "--time", "60"]);
        assert!(later.angle_between(start) > 0.2, "{world}: a tenth of a day later, {start} and {later}");
        assert!(sun_of(world, &["--day", "600", "--time", "600"]).abs_diff_eq(start, 1e-4), "{world}: a day");
    }
    let measure = ["measure", "primitives", "--size", "64x36", "--json", "-", "--day", "600"];
    let [start, later] = ["0", "60"].map(|time| stdout(&[&measure[..], &["--time", time]].concat()));
    assert!(start != later, "shadows are measured where the sun is then");
    refused(&["plan", "primitives", "--day", "0"], 2, "wanted seconds, from 1 to 1e9", None);
}

#[test]
fn pictures_at_two_times_differ_and_two_lengths_apart_do_not() {
    let folder = folder();
    let file = lifted(folder.path());
    let picture = |time: &str| {
        let output = folder.path().join(format!("{time}.png"));
        stdout(&["render", text(&file), "--size", "160x90", "--time", time, "-o", text(&output)]);
        image::open(&output).expect("a picture").into_rgba8()
    };
    let [start, later, again] = ["0", "1.5", "4"].map(picture);
    assert!(start != later, "it moves");
    assert!(start == again, "it begins again");
}
