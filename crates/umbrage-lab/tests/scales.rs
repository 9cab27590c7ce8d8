//! What is huge, thin, low or far reaching has the shadows that it has in the world: no length in metres, and no near plane
//! that follows from the size of the world, stands between.

#[path = "common/boxes.rs"]
mod boxes;

use std::sync::Arc;

use boxes::scene_of;
use glam::Vec3;
use umbrage::{Bias, Settings};
use umbrage_judge::Error;
use umbrage_lab::{Laboratory, Shot, TruthKind};
use umbrage_render::Gpu;
use umbrage_scene::{Camera, Light, Scene};

/// How wrong the default settings are in a scene of one light.
fn error(scene: &Scene) -> Error {
    error_of(&Settings::default(), scene)
}

fn error_of(settings: &Settings, scene: &Scene) -> Error {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let [camera] = &scene.cameras[..] else { panic!("one camera") };
    let shot = Shot {
        camera: camera.clone(),
        lights: scene.lights.clone(),
        pose: Arc::default(),
        width: 240,
        height: 135,
    };
    let mut laboratory = Laboratory::new(&gpu, scene).expect("a laboratory");
    let judged = laboratory.judge(&shot, settings, None, TruthKind::Hard, 0).expect("a measurement");
    judged.measurement.error.expect("pixels to judge")
}

/// Looks down at the origin from eye height.
fn eye() -> Camera {
    Camera::looking("main", Vec3::new(1.0, 3.0, 9.0), Vec3::new(0.0, 0.25, 0.0), 0.9, 0.1, 200.0)
}

#[test]
fn a_ground_of_two_triangles_of_kilometres_is_lit_by_the_lamp_above_it() {
    let boxes =
        [([-4000.0, -1.0, -4000.0], [4000.0, 0.0, 4000.0]), ([1.375, 0.0, 1.375], [1.625, 2.0, 1.625])];
    for height in [0.5, 2.0, 6.0] {
        let lamp = Light::point("lamp", Vec3::new(0.0, height, 0.0), 20.0, 40.0);
        let error = error(&scene_of(&boxes, lamp, eye()));
        assert!(error.mis_shadowed < 1e-3, "{height} m: {error:?}");
    }
}

#[test]
fn a_lamp_without_a_range_keeps_the_shadows_near_it_however_wide_the_world_is() {
    for far in [10.0, 1000.0, 30_000.0f32] {
        let boxes = [
            ([-8.0, -1.0, -8.0], [8.0, 0.0, 8.0]),
            ([1.0, 0.0, 1.0], [2.0, 1.0, 2.0]),
            ([far, 0.0, far], [far + 1.0, 1.0, far + 1.0]),
        ];
        let lamp = Light::point("lamp", Vec3::new(0.0, 3.0, 0.0), f32::INFINITY, 40.0);
        let error = error(&scene_of(&boxes, lamp, eye()));
        assert!(error.mis_shadowed < 2e-3, "{far} m: {error:?}");
    }
}

#[test]
fn wires_of_a_third_of_a_millimetre_cast_on_what_they_nearly_touch() {
    let wire = |x: f32| ([x, 1e-3, -0.1], [x + 3e-4, 1.3e-3, 0.1]);
    let boxes = [([-0.1, -0.01, -0.1], [0.1, 0.0, 0.1]), wire(-0.003), wire(0.0), wire(0.003)];
    let camera =
        Camera::looking("main", Vec3::new(0.0, 0.004, 0.006), Vec3::new(0.0, 0.0, 0.001), 0.9, 1e-3, 1.0);
    let scene = scene_of(&boxes, Light::sun(Vec3::new(1.0, -1.0, 0.25), 3.0), camera);
    let right = error(&scene);
    // What is left lies along the edges of shadows a few pixels wide.
    assert!(right.mis_shadowed < 0.01, "{right:?}");
    // There is a shadow to lose.
    let bias = Bias { constant: 0.002, ..Bias::default() };
    let lost = error_of(&Settings { bias, ..Settings::default() }, &scene);
    assert!(lost.false_light > 0.04, "{lost:?}");
}

#[test]
fn open_ground_is_lit_by_a_sun_just_above_the_horizon() {
    let boxes = [([-20.0, -1.0, -20.0], [20.0, 0.0, 20.0]), ([1.0, 0.0, -1.0], [2.0, 1.0, 0.0])];
    for degrees in [0.7f32, 1.4, 3.0] {
        let low = Vec3::new(-degrees.to_radians().cos(), -degrees.to_radians().sin(), 0.0);
        let error = error(&scene_of(&boxes, Light::sun(low, 3.0), eye()));
        assert!(error.mae < 0.02, "{degrees}°: {error:?}");
    }
}
