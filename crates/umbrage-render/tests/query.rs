//! What a query of the maps says is what they say in a picture, and what the lookup in Rust makes of them.

mod common;

use common::{PIXELS, from_above, gpu, plate};
use glam::Vec3;
use umbrage_render::umbrage::{Filter, Lookup, Settings};
use umbrage_render::{Frame, Point, RenderError, Renderer, Show};
use umbrage_scene::{Light, Scene, worlds};

/// The middle of every triangle of a scene, with its normal.
fn middles(scene: &Scene) -> Vec<Point> {
    let of_instance = |instance: &umbrage_scene::Instance| {
        let (mesh, world_from_mesh) = (&scene.meshes[instance.mesh], instance.world_from_mesh);
        let corner = move |index: &u32| world_from_mesh.transform_point3(mesh.positions[*index as usize]);
        let triangles =
            mesh.indices.as_chunks::<3>().0.iter().map(move |corners| corners.each_ref().map(corner));
        triangles.collect::<Vec<_>>()
    };
    let triangles = scene.instances.iter().flat_map(of_instance);
    let point = |[a, b, c]: [Vec3; 3]| {
        let normal = (b - a).cross(c - a).try_normalize()?;
        Some(Point { position: (a + b + c) / 3.0, normal })
    };
    triangles.filter_map(point).collect()
}

#[test]
fn the_maps_say_what_the_lookup_in_rust_says() {
    let gpu = gpu();
    for world in ["primitives", "closed-room"] {
        let scene = worlds::build(world, 0).expect("a world");
        let settings = Settings { filter: Filter::Bilinear {}, ..Settings::default() };
        let mut renderer = Renderer::new(&gpu, &scene, settings.clone()).expect("a renderer");
        let frame =
            Frame::of(&scene.cameras[0], &scene.lights, &Default::default(), [160, 100], Show::Nothing);
        let drawn = renderer.render(&frame.expect("a good camera")).expect("a frame").drawn;
        assert_eq!(drawn.picture().expect("a picture").rgba.len(), 4, "no picture is drawn");
        let maps = renderer.maps(&drawn).expect("maps");
        let lookup = Lookup { plan: drawn.plan(), settings: &settings, maps: &maps };
        let points = middles(&scene);
        let answers = renderer.query(&drawn, 0, &points).expect("answers");
        assert_eq!(answers.len(), points.len());
        let differ = |(point, answer): &(&Point, &f32)| {
            (lookup.visibility(0, point.position, point.normal) - **answer).abs() > 1.0 / 256.0
        };
        let differing = points.iter().zip(&answers).filter(differ).count();
        let shadowed = answers.iter().filter(|answer| **answer < 0.5).count();
        println!("{world}: {differing} of {} differ, {shadowed} are shadowed", points.len());
        assert!(shadowed * 20 > points.len() && shadowed * 20 < 19 * points.len(), "{shadowed} are shadowed");
        // Rounding decides a comparison here and there, as in the tests of `umbrage`.
        assert!(differing * 400 <= points.len(), "{world}: {differing} of {} differ", points.len());
    }
}

#[test]
fn the_maps_say_what_the_picture_shows() {
    let gpu = gpu();
    let scene = plate();
    let settings = Settings { filter: Filter::Pcf { size: 5 }, resolution: 128, ..Settings::default() };
    let mut renderer = Renderer::new(&gpu, &scene, settings).expect("a renderer");
    let sun = Light::sun(Vec3::new(0.2, -1.0, 0.1), 1.0);
    let frame = from_above(&sun, Show::Visibility(0));
    let drawn = renderer.render(&frame).expect("a frame").drawn;
    let picture = drawn.picture().expect("a picture");
    let world_from_clip = frame.camera.clip_from_world().inverse();
    let ground = |pixel: u32| {
        let centre = |at: u32| (at as f32 + 0.5) / PIXELS as f32 * 2.0 - 1.0;
        let (x, y) = (centre(pixel % PIXELS), -centre(pixel / PIXELS));
        let seen = world_from_clip.project_point3(Vec3::new(x, y, 0.5));
        Point { position: Vec3::new(seen.x, 0.0, seen.z), normal: Vec3::Y }
    };
    let points: Vec<Point> = (0..PIXELS * PIXELS).map(ground).collect();
    let answers = renderer.query(&drawn, 0, &points).expect("answers");
    let grey = picture.rgba.iter().step_by(4).map(|grey| f32::from(*grey) / 255.0);
    // Half a level of grey, and what rounding of the position makes of a slope over a few texels.
    let differing = grey.zip(&answers).filter(|(grey, answer)| (grey - **answer).abs() > 2.0 / 255.0).count();
    let between = answers.iter().filter(|answer| (0.1..0.9).contains(*answer)).count();
    assert!(between > 50, "the plate's soft edge is in the picture: {between} pixels");
    assert!(differing <= 4, "{differing} of {} pixels differ", points.len());
}

#[test]
fn there_is_no_answer_from_maps_of_another_frame_or_of_a_light_that_is_not_there() {
    let gpu = gpu();
    let scene = plate();
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let point = Point { position: Vec3::ZERO, normal: Vec3::Y };
    let refused = |asked: Result<Vec<f32>, RenderError>| asked.expect_err("nothing to ask").to_string();
    let sun = Light::sun(Vec3::NEG_Y, 1.0);
    let drawn = renderer.render(&from_above(&sun, Show::World)).expect("a frame").drawn;
    assert_eq!(renderer.query(&drawn, 0, &[point]).expect("an answer"), [0.0], "under the plate");
    assert!(renderer.query(&drawn, 0, &[]).expect("no answers").is_empty());
    assert!(refused(renderer.query(&drawn, 1, &[point])).contains("no light 1"), "one sun");
    let mut beside = renderer.beside(Settings::default()).expect("another renderer");
    assert!(refused(beside.query(&drawn, 0, &[point])).contains("maps of this frame are gone"), "another's");
    let unshadowed = renderer.render(&from_above(&sun, Show::Unshadowed)).expect("a frame").drawn;
    assert!(refused(renderer.query(&unshadowed, 0, &[point])).contains("no light 0"), "no shadows");
    assert!(refused(renderer.query(&drawn, 0, &[point])).contains("maps of this frame are gone"), "too old");
    assert!(renderer.maps(&drawn).is_err() && renderer.show(&drawn, &Show::World).is_err(), "too old");
    let drawn = renderer.render(&from_above(&sun, Show::World)).expect("a frame").drawn;
    renderer.set_settings(Settings { splits: 2, ..Settings::default() }).expect("settings");
    assert!(
        refused(renderer.query(&drawn, 0, &[point])).contains("maps of this frame are gone"),
        "other maps"
    );
}
