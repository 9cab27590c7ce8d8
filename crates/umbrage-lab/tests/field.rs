//! A scene has the same shadows wherever it stands and however large it is.
//!
//! Every length here is a small whole number of eighths and every move and scale a power of two, or a sum of a few, so that
//! no position is rounded on the way: what differs, differs in how shadows are made.

#[path = "common/boxes.rs"]
mod boxes;

use std::sync::Arc;

use boxes::scene_of;
use glam::{Mat4, Vec3};
use umbrage::Settings;
use umbrage_lab::{Laboratory, Shot, TruthKind};
use umbrage_render::{Gpu, Renderer, Show};
use umbrage_scene::{Camera, Instance, Light, Scene};

/// The size of the pictures.
const SIZE: (u32, u32) = (160, 90);

/// Moves, metres: along each axis, and to where an f32 counts in sixteenths of a metre.
const MOVES: [Vec3; 4] = [
    Vec3::new(512.0, 0.0, 512.0),
    Vec3::new(-4096.0, 1024.0, 2048.0),
    Vec3::new(65_536.0, 0.0, -32_768.0),
    Vec3::new(524_288.0, 0.0, 524_288.0),
];

/// Metres a unit: from half a millimetre to two kilometres.
const SCALES: [f32; 4] = [1.0 / 2048.0, 1.0 / 64.0, 32.0, 2048.0];

/// A court with a wall, a box and a pole under one light, `scale` metres a unit and `moved` from the origin.
fn court(light: &Light, scale: f32, moved: Vec3) -> Scene {
    let boxes = [
        ([-10.0, -1.0, -10.0], [10.0, 0.0, 10.0]),
        ([-3.0, 0.0, -2.0], [1.0, 3.0, -1.5]),
        ([2.0, 0.0, -1.0], [3.5, 1.5, 0.5]),
        ([-1.0, 0.0, 2.0], [-0.75, 4.0, 2.25]),
    ];
    let at = |p: [f32; 3]| p.map(|x| x * scale);
    let boxes = boxes.map(|(low, high)| (at(low), at(high)));
    let carry = |pose: Mat4| {
        let (_, rotation, place) = pose.to_scale_rotation_translation();
        Mat4::from_rotation_translation(rotation, place * scale + moved)
    };
    let camera =
        Camera::looking("main", Vec3::new(5.0, 6.0, 8.0), Vec3::new(0.0, 0.5, 0.0), 0.9, 0.125, 64.0);
    let mut light = light.clone();
    light.world_from_light = carry(light.world_from_light);
    light.kind = scaled(light.kind, scale);
    let camera = Camera {
        world_from_camera: carry(camera.world_from_camera),
        near: camera.near * scale,
        far: camera.far * scale,
        ..camera
    };
    let court = scene_of(&boxes, light, camera);
    Scene { instances: vec![Instance::still(0, Mat4::from_translation(moved))], ..court }
}

fn scaled(kind: umbrage_scene::LightKind, scale: f32) -> umbrage_scene::LightKind {
    use umbrage_scene::LightKind::{Directional, Point, Spot};
    match kind {
        Directional => Directional,
        Spot { inner, outer, range } => Spot { inner, outer, range: range * scale },
        Point { range } => Point { range: range * scale },
    }
}

fn lights() -> [Light; 3] {
    [
        Light::sun(Vec3::new(-0.5, -0.75, -0.25), 3.0),
        Light::spot("spot", Vec3::new(2.0, 7.0, 5.0), Vec3::ZERO, 0.5, 0.65, 32.0, 90.0),
        Light::point("point", Vec3::new(3.0, 4.0, 3.0), 24.0, 40.0),
    ]
}

/// What the default settings make of a court: each pixel's visibility, and the share that exact shadows call wrong.
fn seen(gpu: &Gpu, scene: &Scene) -> (Vec<f32>, f64) {
    let [camera] = &scene.cameras[..] else { panic!("one camera") };
    let shot = Shot {
        camera: camera.clone(),
        lights: scene.lights.clone(),
        pose: Arc::default(),
        width: SIZE.0,
        height: SIZE.1,
    };
    let settings = Settings::default();
    let mut renderer = Renderer::new(gpu, scene, settings.clone()).expect("a renderer");
    let frame = shot.frame(Show::Visibility(0)).expect("a good camera and light");
    let picture = renderer.render(&frame).expect("a frame").drawn.picture().expect("a picture");
    let mut laboratory = Laboratory::new(gpu, scene).expect("a laboratory");
    let judged = laboratory.judge(&shot, &settings, None, TruthKind::Hard, 0).expect("a measurement");
    (picture.visibility(), judged.measurement.error.map_or(1.0, |error| error.mis_shadowed))
}

/// The share of pixels that are lit in one picture and shadowed in the other.
fn flipped(a: &[f32], b: &[f32]) -> f64 {
    let flips = a.iter().zip(b).filter(|(a, b)| (**a < 0.5) != (**b < 0.5)).count();
    flips as f64 / a.len() as f64
}

/// Every light's court, made elsewhere by `court_of`, looks as it does at the origin at scale 1, and is as right.
fn assert_same(what: impl Fn(usize) -> String, courts: impl Fn(&Light) -> Vec<Scene>) {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let mut wrong = Vec::new();
    for light in lights() {
        let (here, right) = seen(&gpu, &court(&light, 1.0, Vec3::ZERO));
        assert!(right < 1e-3, "{}: {right} mis-shadowed at the origin", light.name);
        for (i, elsewhere) in courts(&light).iter().enumerate() {
            let (there, mis_shadowed) = seen(&gpu, elsewhere);
            let flips = flipped(&here, &there);
            // 14 of 14,400 pixels: where an edge goes through a pixel's middle.
            if flips > 1e-3 || mis_shadowed > 2e-3 {
                wrong.push(format!(
                    "{}, {}: {flips} flipped, {mis_shadowed} mis-shadowed",
                    light.name,
                    what(i)
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_scene_that_is_moved_has_the_same_shadows() {
    let what = |i: usize| format!("{} m away", MOVES[i]);
    assert_same(what, |light| MOVES.iter().map(|moved| court(light, 1.0, *moved)).collect());
}

#[test]
fn a_scene_that_is_scaled_has_the_same_shadows() {
    let what = |i: usize| format!("{} m a unit", SCALES[i]);
    assert_same(what, |light| SCALES.iter().map(|scale| court(light, *scale, Vec3::ZERO)).collect());
}

#[test]
fn a_scene_that_is_moved_and_scaled_has_the_same_shadows() {
    let both = [(32.0, MOVES[2]), (1.0 / 64.0, MOVES[0] / 64.0)];
    let what = |i: usize| format!("{} m a unit and {} m away", both[i].0, both[i].1);
    assert_same(what, |light| both.iter().map(|(scale, moved)| court(light, *scale, *moved)).collect());
}
