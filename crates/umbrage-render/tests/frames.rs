//! What frames share and own: a frame after the first makes nothing on the device, pictures stay while they are held, and
//! settings remake no more than depends on them.

mod common;

use std::sync::Arc;

use common::{from_above, gpu, plate};
use glam::Vec3;
use umbrage_render::umbrage::{Contact, Filter, Settings};
use umbrage_render::{Frame, InFlight, Made, Mark, Renderer, Show};
use umbrage_scene::{Light, worlds};

/// A picture of a built-in world's first camera at a time.
fn frame(scene: &umbrage_scene::Scene, seconds: f32, show: Show) -> Frame {
    Frame::of(&scene.cameras[0], &scene.lights, &Arc::new(scene.pose(seconds)), [160, 90], show)
        .expect("a camera and lights")
}

#[test]
fn a_frame_after_the_first_makes_nothing_on_the_device() {
    let (gpu, scene) = (gpu(), worlds::build("brick-ground", 0).expect("a world"));
    for contact in [None, Some(Contact::default())] {
        let settings = Settings { contact, ..Settings::default() };
        let mut renderer = Renderer::new(&gpu, &scene, settings).expect("a renderer");
        let given = vec![0.5; 160 * 90 * scene.lights.len()];
        let marks = [Mark::Splits, Mark::Texels, Mark::Extents].map(Show::Marked);
        let mut shows = vec![Show::World, Show::Unshadowed, Show::Given(given), Show::Visibility(0)];
        shows.extend(marks);
        let path = |renderer: &mut Renderer, at: f32| {
            for show in &shows {
                let still = frame(&scene, 0.0, show.clone());
                let drawn =
                    renderer.draw(&Frame { pose: Arc::new(scene.pose(at)), ..still }).expect("a frame");
                drop(drawn);
            }
            gpu.wait().expect("a device");
            gpu.made()
        };
        let first = path(&mut renderer, 0.0);
        let Made { buffers, textures, bind_groups, pipelines } = first;
        assert!(
            buffers.min(textures).min(bind_groups).min(pipelines) > 0,
            "what is made is counted: {first:?}"
        );
        for step in 1..4 {
            // Lists may grow with what moves into view; twice the room is made at once.
            assert_eq!(path(&mut renderer, 0.1 * step as f32), first, "step {step}, contact {contact:?}");
        }
    }
}

#[test]
fn a_picture_that_is_held_stays_and_one_that_is_released_is_used_again() {
    let (gpu, scene) = (gpu(), plate());
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let [left, right] = [Vec3::new(0.3, -1.0, 0.0), Vec3::new(-0.3, -1.0, 0.0)].map(|to| Light::sun(to, 1.0));
    let held = renderer.draw(&from_above(&left, Show::World)).expect("a frame");
    let before = held.picture().expect("a picture");
    let other = renderer.draw(&from_above(&right, Show::World)).expect("a frame");
    assert!(held.picture().expect("a picture") == before, "a later frame is drawn elsewhere");
    assert!(other.picture().expect("a picture") != before, "the later frame is another picture");
    drop(held);
    let made = gpu.made();
    let again = renderer.draw(&from_above(&left, Show::World)).expect("a frame");
    assert!(again.picture().expect("a picture") == before, "the same frame is the same picture");
    assert_eq!(gpu.made().textures, made.textures, "what was released is used again");
    drop(other);
}

#[test]
fn other_pictures_of_a_frame_come_from_its_maps_and_are_the_same_as_drawn_anew() {
    let (gpu, scene) = (gpu(), worlds::build("night-chessboard", 0).expect("a world"));
    let settings = Settings { resolution: 256, ..Settings::default() };
    let mut renderer = Renderer::new(&gpu, &scene, settings).expect("a renderer");
    let shows = [Show::Visibility(0), Show::Visibility(1), Show::Marked(Mark::Splits), Show::Unshadowed];
    let anew: Vec<_> = shows
        .iter()
        .map(|show| {
            renderer.draw(&frame(&scene, 0.0, show.clone())).expect("a frame").picture().expect("a picture")
        })
        .collect();
    let drawn = renderer.draw(&frame(&scene, 0.0, Show::World)).expect("a frame");
    for (show, anew) in shows.iter().zip(&anew) {
        let beside = renderer.show(&drawn, show).expect("another picture");
        assert!(renderer.has_maps_of(&drawn) && renderer.has_maps_of(&beside), "{show:?} draws no maps");
        assert!(beside.picture().expect("a picture") == *anew, "{show:?}");
    }
}

#[test]
fn renderers_beside_each_other_may_draw_different_times() {
    let (gpu, scene) = (gpu(), worlds::build("brick-ground", 0).expect("a world"));
    let mut one = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let mut other = one.beside(Settings::default()).expect("another renderer");
    (one.hold_plans, other.hold_plans) = (false, false);
    let at = |renderer: &mut Renderer, seconds| {
        let drawn = renderer.draw(&frame(&scene, seconds, Show::World)).expect("a frame");
        (drawn.picture().expect("a picture"), drawn)
    };
    let (start, drawn) = at(&mut one, 0.0);
    let (later, _) = at(&mut other, 1.3);
    assert!(start != later, "something moves");
    assert!(
        one.show(&drawn, &Show::World).expect("again").picture().expect("a picture") == start,
        "its own time"
    );
    assert!(at(&mut other, 0.0).0 == start, "the same time is the same picture");
}

#[test]
fn settings_that_change_no_shader_remake_none_of_those_that_shade() {
    let (gpu, scene) = (gpu(), plate());
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let sun = Light::sun(Vec3::NEG_Y, 1.0);
    let mut pipelines = |settings: Settings| {
        let before = gpu.made().pipelines;
        renderer.set_settings(settings).expect("settings");
        renderer.draw(&from_above(&sun, Show::World)).expect("a frame");
        gpu.made().pipelines - before
    };
    let first = pipelines(Settings::default());
    let lambda = pipelines(Settings { lambda: 0.3, ..Settings::default() });
    let filter = pipelines(Settings { filter: Filter::Hard {}, ..Settings::default() });
    assert!(
        lambda < first && lambda < filter,
        "{first} at first, {lambda} for lambda, {filter} for a filter"
    );
}

#[test]
fn no_more_frames_are_in_flight_than_a_window_has() {
    let (gpu, scene) = (gpu(), plate());
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let frame = from_above(&Light::sun(Vec3::new(0.3, -1.0, 0.0), 1.0), Show::World);
    let mut in_flight = InFlight::new(&gpu, 2);
    for _ in 0..4 {
        drop(renderer.draw(&frame).expect("a frame"));
        in_flight.handed_over().expect("a device");
        assert_eq!(in_flight.count(), 1, "there is room for the next");
    }
    in_flight.finish().expect("a device");
    assert_eq!(in_flight.count(), 0);
}

#[test]
fn passes_are_timed_unless_that_is_turned_off() {
    let (gpu, scene) = (gpu(), plate());
    assert!(gpu.adapter.timestamps, "lavapipe has them");
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let frame = from_above(&Light::sun(Vec3::new(0.3, -1.0, 0.0), 1.0), Show::World);
    let mut times = |on: bool| {
        renderer.set_pass_times(on);
        drop(renderer.draw(&frame).expect("a frame"));
        gpu.wait().expect("a device");
        renderer.pass_times()
    };
    assert!(times(true).is_some_and(|[_, casters, _, shade]| casters > 0.0 && shade > 0.0));
    assert_eq!(times(false), None);
    assert!(times(true).is_some(), "again");
    assert_eq!(times(false), None, "nothing is left over");
}
