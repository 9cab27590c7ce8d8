//! What the renderer promises: culling changes nothing but the cost, files draw as built-in worlds do, and every shader
//! is valid.

#[path = "../../umbrage-scene/examples/large_gltf.rs"]
#[expect(dead_code, reason = "the example's main is for the command line")]
mod large_gltf;

use std::time::Duration;

use glam::{Mat4, Vec3};
use umbrage_render::umbrage::{Bias, CasterFaces, DepthFormat, Filter, MapTexels, Select, Settings};
use umbrage_render::{Frame, Gpu, Mark, Picture, Rendered, Renderer, Show};
use umbrage_scene::{Scene, load_glb_bytes, to_glb, worlds};

fn frame(scene: &Scene, show: Show) -> Frame {
    Frame::of(&scene.cameras[0], &scene.lights, &Default::default(), [320, 180], show)
        .expect("a good camera and lights")
}

fn draw(gpu: &Gpu, scene: &Scene, settings: Settings, cull_parts: bool) -> (Rendered, Picture, MapTexels) {
    let mut renderer = Renderer::new(gpu, scene, settings).expect("a renderer");
    renderer.cull_parts = cull_parts;
    let rendered = renderer.render(&frame(scene, Show::Visibility(0))).expect("a frame");
    let picture = rendered.drawn.picture().expect("a picture");
    let maps = renderer.maps(&rendered.drawn).expect("maps");
    (rendered, picture, maps)
}

#[test]
fn culling_parts_halves_what_a_large_file_draws_and_changes_no_texel_that_is_read() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let bytes = to_glb(&large_gltf::town()).expect("a file");
    let scene = load_glb_bytes(&bytes, "town").expect("the file reads back").scene;
    assert!(scene.triangles() > 1_500_000 && scene.instances.len() == 300, "{} triangles", scene.triangles());
    let largest = scene.meshes.iter().map(umbrage_scene::Mesh::triangles).max();
    assert!(largest > Some(280_000), "one mesh is large: {largest:?}");
    let triangles =
        |rendered: &Rendered| rendered.drawn.loads().iter().map(|view| view.triangles).sum::<u64>();
    for select in [Select::Map, Select::Depth] {
        let settings = Settings { filter: Filter::Hard {}, select, caster_error: 0.0, ..Settings::default() };
        let (culled, picture, maps) = draw(&gpu, &scene, settings.clone(), true);
        let (all, picture_of_all, maps_of_all) = draw(&gpu, &scene, settings, false);
        let differing: Vec<_> = maps.depths.iter().zip(&maps_of_all.depths).filter(|(a, b)| a != b).collect();
        let (few, many) = (triangles(&culled), triangles(&all));
        println!("{select:?}: {few} of {many} caster triangles are drawn, {} texels differ", differing.len());
        assert!(2 * few < many, "{select:?}: {few} of {many}");
        assert!(picture == picture_of_all, "{select:?}: visibility is the same");
        // Casters that no receiver of the view can meet are left out: their texels are farther, and never read.
        assert!(differing.iter().all(|(culled, all)| culled < all), "culling only removes casters");
    }
}

#[test]
fn an_exported_world_draws_as_the_built_in_one() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let built_in = worlds::build("knights", 0).expect("a world");
    let bytes = to_glb(&built_in).expect("a file");
    let from_file = load_glb_bytes(&bytes, "knights").expect("the file reads back").scene;
    for show in [Show::World, Show::Visibility(0)] {
        let picture = |scene: &Scene| {
            let mut renderer = Renderer::new(&gpu, scene, Settings::default()).expect("a renderer");
            let drawn = renderer.render(&frame(scene, show.clone())).expect("a frame").drawn;
            drawn.picture().expect("a picture")
        };
        assert!(picture(&built_in) == picture(&from_file), "{show:?}: the pictures differ");
    }
}

#[test]
fn wide_filters_lose_no_caster_to_culling() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let scene = worlds::build("robot-war", 0).expect("a world");
    let filter = Filter::Pcf { size: 9 };
    let settings = Settings { filter, resolution: 256, caster_error: 0.0, ..Settings::default() };
    let (culled, picture, _) = draw(&gpu, &scene, settings.clone(), true);
    let (all, picture_of_all, _) = draw(&gpu, &scene, settings, false);
    let triangles =
        |rendered: &Rendered| rendered.drawn.loads().iter().map(|view| view.triangles).sum::<u64>();
    assert!(triangles(&culled) < triangles(&all), "something is culled");
    assert!(picture == picture_of_all, "visibility is the same");
}

#[test]
fn what_is_closed_casts_without_its_backs_as_with_them() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    for world in ["bunny", "knights", "robot-war", "primitives", "night-chessboard"] {
        let scene = worlds::build(world, 0).expect("a world");
        let settings = Settings { resolution: 512, caster_error: 0.0, ..Settings::default() };
        let maps = |patience| {
            let mut renderer = Renderer::new(&gpu, &scene, settings.clone()).expect("a renderer");
            renderer.patience = patience;
            let rendered = renderer.render(&frame(&scene, Show::Visibility(0))).expect("a frame");
            let picture = rendered.drawn.picture().expect("a picture");
            (renderer.maps(&rendered.drawn).expect("maps").depths, picture.rgba)
        };
        // Without levels of detail, meshes cast as they are, both sides of them.
        let ((both, seen), (fronts, seen_by_fronts)) = (maps(Duration::ZERO), maps(Duration::MAX));
        // A step is a 65535th; corners are interpolated from in another order.
        let differing = both.iter().zip(&fronts).filter(|(a, b)| (*a - *b).abs() > 2e-5).count();
        println!("{world}: {differing} of {} texels differ", both.len());
        assert!(differing * 100_000 <= both.len(), "{world}: {differing} of {} texels differ", both.len());
        let pixels = seen.iter().zip(&seen_by_fronts).filter(|(a, b)| a.abs_diff(**b) > 24).count();
        assert!(pixels <= 4, "{world}: {pixels} bytes of the picture differ");
    }
}

#[test]
fn mirrored_instances_cast_with_the_faces_that_were_asked_for() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let scene = worlds::build("bunny", 0).expect("a world");
    // The same world seen in a mirror twice: meshes mirrored along x, and every instance mirrored back.
    let mut mirrored = scene.clone();
    let flip = Mat4::from_scale(Vec3::new(-1.0, 1.0, 1.0));
    for mesh in &mut mirrored.meshes {
        mesh.positions.iter_mut().chain(&mut mesh.normals).for_each(|v| v.x = -v.x);
        mesh.indices.as_chunks_mut::<3>().0.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        mesh.bounds = mesh.bounds.transformed(&flip);
        mesh.parts.iter_mut().for_each(|part| part.bounds = part.bounds.transformed(&flip));
    }
    mirrored.instances.iter_mut().for_each(|instance| instance.world_from_mesh *= flip);
    let maps = |scene: &Scene, casters| {
        let bias = Bias { casters, ..Bias::default() };
        let settings = Settings { bias, resolution: 256, depth: DepthFormat::F32, ..Settings::default() };
        draw(&gpu, scene, settings, true).2
    };
    let (front, back) = (maps(&scene, CasterFaces::Front), maps(&scene, CasterFaces::Back));
    // Depths are interpolated from corners in another order, and rounded so.
    let differing = |a: &MapTexels, b: &MapTexels| {
        a.depths.iter().zip(&b.depths).filter(|(a, b)| (*a - *b).abs() > 1e-5).count()
    };
    assert!(differing(&front, &back) > 1000, "front and back faces differ");
    for (casters, expected) in [(CasterFaces::Front, &front), (CasterFaces::Back, &back)] {
        let wrong = differing(&maps(&mirrored, casters), expected);
        assert!(wrong < 50, "{casters:?}: {wrong} texels differ");
    }
}

#[test]
fn moving_things_move_with_time_and_come_back() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let scene = worlds::build("brick-ground", 0).expect("a world");
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    renderer.hold_plans = false;
    let mut at = |seconds| {
        let drawn = renderer
            .render(&Frame { pose: scene.pose(seconds).into(), ..frame(&scene, Show::World) })
            .expect("a frame")
            .drawn;
        drawn.picture().expect("a picture")
    };
    let (start, later, again) = (at(0.0), at(1.3), at(0.0));
    let moved = start.rgba.chunks(4).zip(later.rgba.chunks(4)).filter(|(a, b)| a != b).count();
    assert!(moved > 200, "{moved} pixels changed");
    assert!(start == again, "the first picture comes back");
}

#[test]
fn pictures_show_shadow_sky_and_splits_where_they_should() {
    let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
    let scene = worlds::build("primitives", 0).expect("a world");
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let mut shown = |show| {
        let drawn = renderer.render(&frame(&scene, show)).expect("a frame").drawn;
        drawn.picture().expect("a picture").rgba
    };
    let (world, plain, splits, visibility) = (
        shown(Show::World),
        shown(Show::Unshadowed),
        shown(Show::Marked(Mark::Splits)),
        shown(Show::Visibility(0)),
    );
    let (mut shadowed, mut lit, mut tinted) = (0, 0, 0);
    for i in (0..world.len()).step_by(4) {
        let (world, plain, splits) = (&world[i..i + 3], &plain[i..i + 3], &splits[i..i + 3]);
        match visibility[i] {
            255 => {
                // 255 is all visibility above 0.998, and a filter's weights add up to 1 within rounding: a level at most.
                let levels = world.iter().zip(plain).map(|(a, b)| a.abs_diff(*b)).max();
                assert!(levels <= Some(1), "pixel {}: lit pixels are as without shadows", i / 4);
                lit += 1;
            }
            0 if world != plain => {
                assert!(world.iter().zip(plain).all(|(a, b)| a <= b), "pixel {}: shadows only darken", i / 4);
                shadowed += 1;
            }
            _ => {}
        }
        tinted += usize::from(world != splits);
    }
    assert!(shadowed > 500 && lit > 20_000, "{shadowed} shadowed, {lit} lit");
    assert!(tinted > 20_000, "{tinted} pixels are tinted");
}
