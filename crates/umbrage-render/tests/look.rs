//! What a window asks of a renderer: frames without waiting, maps as pictures, marks on surfaces, plans of another camera.

use glam::Vec3;
use umbrage_render::umbrage::{Settings, Shade, Warp};
use umbrage_render::{ComingPicture, Frame, Gpu, MapLook, Mark, Picture, Renderer, Show};
use umbrage_scene::{Camera, Scene};

fn gpu() -> Gpu {
    Gpu::new(Some("vulkan")).expect("run scripts/setup")
}

fn world() -> Scene {
    umbrage_scene::worlds::build("primitives", 0).expect("a built-in world")
}

fn frame(scene: &Scene, show: Show) -> Frame {
    Frame::of(&scene.cameras[0], &scene.lights[..1], &Default::default(), [160, 96], show)
        .expect("a camera and a light")
}

fn read(gpu: &Gpu, texture: &wgpu::TextureView) -> Picture {
    let coming = ComingPicture::of_texture(gpu, texture.texture()).expect("a copy");
    gpu.wait().expect("a device");
    coming.take().expect("it has come").expect("a picture")
}

#[test]
fn a_frame_that_nobody_waits_for_is_the_same_picture() {
    let (gpu, scene) = (gpu(), world());
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let rendered = renderer.render(&frame(&scene, Show::World)).expect("a frame");
    let waited_for = rendered.drawn.picture().expect("a picture");
    let mut beside = renderer.beside(Settings::default()).expect("another renderer");
    let drawn = beside.draw(&frame(&scene, Show::World)).expect("a frame");
    assert_eq!(drawn.loads().len(), 4);
    let coming = drawn.coming_picture().expect("a copy");
    gpu.wait().expect("a device");
    assert_eq!(coming.take().expect("it has come").expect("a picture"), waited_for);
    assert_eq!(read(&gpu, &drawn.shown().expect("a texture")), waited_for);
}

#[test]
fn a_map_picture_is_what_the_map_holds() {
    let (gpu, scene) = (gpu(), world());
    for warp in [Warp::None, Warp::Lispsm] {
        let settings = Settings { resolution: 256, warp, ..Settings::default() };
        let mut renderer = Renderer::new(&gpu, &scene, settings).expect("a renderer");
        let drawn = renderer.render(&frame(&scene, Show::World)).expect("a frame").drawn;
        let tile = drawn.plan().views()[1].tile;
        let maps = renderer.maps(&drawn).expect("maps");
        let stored = |x: u32, y: u32| 1.0 - maps.depth(tile, i64::from(x), i64::from(y));
        let mut look = |look| read(&gpu, &renderer.map_picture(&drawn, 1, look, 256).expect("a picture"));
        let plain = look(MapLook::default());
        let inverted = look(MapLook { invert: true, ..MapLook::default() });
        let stretched = look(MapLook { stretch: true, even: true, ..MapLook::default() });
        let grey = |picture: &Picture, x: u32, y: u32| i32::from(picture.rgba[4 * (y * 256 + x) as usize]);
        for (x, y) in (0..256).step_by(17).flat_map(|x| (0..256).step_by(13).map(move |y| (x, y))) {
            let wanted = (stored(x, y) * 255.0).round() as i32;
            assert!((grey(&plain, x, y) - wanted).abs() <= 1, "{x}, {y}");
            assert!((grey(&inverted, x, y) + wanted - 255).abs() <= 1, "{x}, {y}");
        }
        let greys: Vec<u8> = stretched.rgba.iter().step_by(4).copied().collect();
        assert_eq!((greys.iter().min(), greys.iter().max()), (Some(&0), Some(&255)), "all greys are used");
    }
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let unshadowed = renderer.render(&frame(&scene, Show::Unshadowed)).expect("a frame").drawn;
    let nothing =
        renderer.map_picture(&unshadowed, 0, MapLook::default(), 16).map(drop).expect_err("no maps");
    assert!(nothing.to_string().contains("view 0"), "{nothing}");
    let sky = Camera::looking("c", Vec3::new(0.0, 90.0, 0.0), Vec3::new(1.0, 200.0, 0.0), 1.0, 0.5, 50.0);
    let sky = umbrage_render::camera(&sky, 160.0 / 96.0).expect("a camera");
    let drawn = renderer.render(&Frame { camera: sky, ..frame(&scene, Show::World) }).expect("a frame").drawn;
    let look = MapLook { stretch: true, ..MapLook::default() };
    let empty = read(&gpu, &renderer.map_picture(&drawn, 0, look, 16).expect("a picture"));
    assert!(empty.rgba.iter().all(|grey| *grey == 255), "an empty map is far all over");
}

#[test]
fn a_plan_for_another_camera_shadows_what_that_camera_sees() {
    let (gpu, scene) = (gpu(), world());
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let looking = frame(&scene, Show::World);
    let own = renderer.render(&looking).expect("a frame").drawn;
    let elsewhere = Camera::looking("c", Vec3::new(0.0, 40.0, 0.1), Vec3::ZERO, 1.0, 0.5, 200.0);
    let elsewhere = umbrage_render::camera(&elsewhere, 160.0 / 96.0).expect("a camera");
    let from_there = Frame { camera: elsewhere, planned_for: Some(looking.camera), ..looking };
    let frozen = renderer.render(&from_there).expect("a frame").drawn;
    // What tiles show is named by where positions are relative to as well, and that is near the eye.
    let planned = |drawn: &umbrage_render::Drawn| {
        let mut plan = drawn.plan().clone();
        (0..plan.views().len()).for_each(|view| plan.set_key(view, None));
        plan.views().to_vec()
    };
    assert_eq!(planned(&frozen), planned(&own));
    let followed = renderer.render(&Frame { planned_for: None, ..from_there }).expect("a frame").drawn;
    assert_ne!(followed.plan().views(), own.plan().views());
}

#[test]
fn marks_change_surfaces_and_not_the_sky() {
    let (gpu, scene) = (gpu(), world());
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let mut shown = |show| {
        let drawn = renderer.render(&frame(&scene, show)).expect("a frame").drawn;
        drawn.picture().expect("a picture")
    };
    let (plain, sky) = (shown(Show::World), shown(Show::Visibility(0)));
    assert_eq!(sky.rgba[0], 255, "the upper left corner is sky, which is lit");
    let pixel = |picture: &Picture, i: usize| picture.rgba[4 * i..4 * i + 3].to_vec();
    for mark in [Mark::Splits, Mark::Texels, Mark::Extents] {
        let marked = shown(Show::Marked(mark));
        let last = 160 * 96 - 80;
        assert_ne!(pixel(&marked, last), pixel(&plain, last), "{mark:?}: the ground changes");
        assert_eq!(pixel(&marked, 0), pixel(&plain, 0), "{mark:?}: the sky does not");
    }
}

#[test]
fn the_colour_of_shadows_does_not_depend_on_the_order_of_lights() {
    let gpu = gpu();
    let mut scene = umbrage_scene::worlds::build("night-chessboard", 0).expect("a built-in world");
    scene.lights.truncate(4);
    let shade = Shade::Colour { shadow_colour: [0.0, 0.0, 0.3, 0.7], darkness: 0.9 };
    let settings = Settings { resolution: 256, shade, ..Settings::default() };
    let picture = |lights: &[umbrage_scene::Light]| {
        let mut renderer = Renderer::new(&gpu, &scene, settings.clone()).expect("a renderer");
        let frame = Frame::of(&scene.cameras[0], lights, &Default::default(), [160, 96], Show::World);
        renderer
            .render(&frame.expect("a camera and lights"))
            .expect("a frame")
            .drawn
            .picture()
            .expect("a picture")
    };
    let forth = picture(&scene.lights);
    let back = picture(&scene.lights.iter().rev().cloned().collect::<Vec<_>>());
    let coloured = picture(&scene.lights[..1]);
    assert_ne!(forth.rgba, coloured.rgba, "the lights matter");
    // Sums of floats in another order may round another way.
    let most = forth.rgba.iter().zip(&back.rgba).map(|(a, b)| a.abs_diff(*b)).max();
    assert!(most <= Some(1), "{most:?} steps");
}
