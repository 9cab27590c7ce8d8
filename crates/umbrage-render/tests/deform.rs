//! What joints and morph targets bend: the device's vertices are those of an evaluation in f64, pictures are those of the same
//! pose baked into still meshes, and all of it is bent once, however many views it is drawn into.

#[path = "deform/bodies.rs"]
mod bodies;
#[path = "deform/reference.rs"]
mod reference;

use std::sync::Arc;

use bodies::{add_sheet, add_tube, bodies, node, play, turn_over_time, yard};
use glam::{DVec3, Mat4, Vec3};
use reference::{baked, bent};
use umbrage_render::umbrage::{Bias, CasterFaces, DepthFormat, Exact, Filter, Settings};
use umbrage_render::{Frame, Gpu, RayCasters, Renderer, Show};
use umbrage_scene::rig::{Channel, Track};
use umbrage_scene::{Curve, Instance, Keys, Light, Mesh, Scene, load_glb_bytes, to_glb};

fn gpu() -> Gpu {
    Gpu::new(Some("vulkan")).expect("run scripts/setup")
}

fn frame(scene: &Scene, seconds: f32, show: Show) -> Frame {
    Frame::of(&scene.cameras[0], &scene.lights, &Arc::new(scene.pose(seconds)), [240, 160], show)
        .expect("a camera and lights")
}

/// The visibility of the first light.
fn visibility(gpu: &Gpu, scene: &Scene, seconds: f32, settings: &Settings) -> Vec<u8> {
    let mut renderer = Renderer::new(gpu, scene, settings.clone()).expect("a renderer");
    let drawn = renderer.draw(&frame(scene, seconds, Show::Visibility(0))).expect("a frame");
    drawn.picture().expect("a picture").rgba.chunks_exact(4).map(|pixel| pixel[0]).collect()
}

#[test]
fn bent_vertices_are_those_of_an_evaluation_in_f64() {
    let gpu = gpu();
    for (name, scene) in bodies() {
        let pose = scene.pose(0.0);
        let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
        renderer.draw(&frame(&scene, 0.0, Show::Nothing)).expect("a frame");
        let mut found = 0;
        for (i, instance) in scene.instances.iter().enumerate() {
            let Some(device) = renderer.bent_vertices(i).expect("vertices") else { continue };
            found += 1;
            let wanted = bent(&scene, instance, &pose);
            assert_eq!(device.positions.len(), wanted.len(), "{name}");
            // Some roundings of terms that are 4 m at the most, as all bodies are about 2 m large.
            let most = 4.0 * 8.0 * f64::from(f32::EPSILON);
            for (i, (position, normal)) in wanted.iter().enumerate() {
                let off = device.positions[i].as_dvec3().distance(*position);
                assert!(off < most, "{name}, vertex {i}: {off} m off");
                let turned = device.normals[i].as_dvec3().distance(*normal);
                assert!(turned < 1e-5, "{name}, vertex {i}: {} for {normal}", device.normals[i]);
            }
        }
        assert!(found > 0, "{name}: nothing is bent");
    }
}

/// Texels as long as a pixel here, of hardly any rounding: where bodies are bent on the device, corners are rounded otherwise.
fn hard() -> Settings {
    Settings { resolution: 1024, depth: DepthFormat::F32, filter: Filter::Hard {}, ..Settings::default() }
}

#[test]
fn pictures_of_bent_bodies_are_those_of_the_same_pose_in_still_meshes() {
    let gpu = gpu();
    for (name, scene) in bodies() {
        let pose = scene.pose(0.0);
        // Sides are told apart by what is closed: a sheet is its own shadow's edge all over.
        let sides = [CasterFaces::Both, CasterFaces::Front, CasterFaces::Back];
        for casters in sides.into_iter().take(if name.contains("sheet") { 1 } else { 3 }) {
            let bias = Bias { casters, ..Bias::default() };
            let settings = Settings { bias, ..hard() };
            let moving = visibility(&gpu, &scene, 0.0, &settings);
            let still = visibility(&gpu, &baked(&scene, &pose), 0.0, &settings);
            let shadowed = still.iter().filter(|pixel| **pixel < 128).count();
            assert!(shadowed > 150, "{name}, {casters:?}: {shadowed} pixels are in shadow");
            let off = (0..still.len()).filter(|i| moving[*i] != still[*i]);
            let (edge, inside): (Vec<usize>, Vec<usize>) = off.partition(|i| is_edge(&still, *i));
            assert!(inside.is_empty(), "{name}, {casters:?}: {} pixels off any edge differ", inside.len());
            assert!(edge.len() < 200, "{name}, {casters:?}: {} pixels at edges differ", edge.len());
        }
    }
}

/// Whether each pixel is where two levels meet, within two pixels: a texel is smaller here.
fn is_edge(picture: &[u8], i: usize) -> bool {
    let (x, y) = (i % 240, i / 240);
    let columns = || x.saturating_sub(2)..(x + 3).min(240);
    let mut around =
        (y.saturating_sub(2)..(y + 3).min(160)).flat_map(|row| columns().map(move |x| row * 240 + x));
    around.any(|other| picture[other] != picture[i])
}

#[test]
fn pictures_of_bent_bodies_are_those_of_the_pose_baked_into_a_file() {
    let settings = hard();
    let gpu = gpu();
    for (name, scene) in bodies() {
        let bytes = to_glb(&scene.baked(&scene.pose(0.0))).expect("a file");
        let file = load_glb_bytes(&bytes, name).expect("the file reads back").scene;
        assert!(file.rig.nodes.is_empty() && !file.instances.iter().any(Instance::is_dynamic), "{name}");
        let still = visibility(&gpu, &file, 0.0, &settings);
        let moving = visibility(&gpu, &scene, 0.0, &settings);
        let off: Vec<usize> = (0..still.len()).filter(|i| moving[*i] != still[*i]).collect();
        let inside = off.iter().filter(|i| !is_edge(&still, **i)).count();
        assert!(inside == 0 && off.len() < 200, "{name}: {} differ, {inside} of them off edges", off.len());
    }
}

#[test]
fn a_pose_is_bent_once_however_many_views_and_renderers_see_it() {
    let (gpu, mut scene) = (gpu(), yard());
    let tube = add_tube(&mut scene, 2, 2, 0.0, node(None, DVec3::ZERO));
    let joint = scene.rig.skins[0].joints[1].0;
    turn_over_time(&mut scene, joint, 1.5);
    scene.lights.push(Light::point("lamp", Vec3::new(0.0, 3.0, 1.0), 20.0, 5.0));
    let mut one = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let mut other = one.beside(Settings { resolution: 256, ..Settings::default() }).expect("another");
    assert_eq!(one.deformations(), 0);
    for (step, seconds) in [0.0, 0.5, 1.0].into_iter().enumerate() {
        let drawn = one.draw(&frame(&scene, seconds, Show::World)).expect("a frame");
        assert!(drawn.plan().views().len() > 4, "{} views", drawn.plan().views().len());
        other.draw(&frame(&scene, seconds, Show::World)).expect("a frame");
        one.show(&drawn, &Show::Visibility(0)).expect("again");
        assert_eq!(one.deformations(), step as u64 + 1, "at {seconds} s");
    }
    let before = one.bent_vertices(tube).expect("vertices");
    other.draw(&frame(&scene, 0.0, Show::World)).expect("a frame");
    assert_ne!(other.bent_vertices(tube).expect("vertices"), before, "they share one");
    let still = Scene { rig: umbrage_scene::Rig { playing: None, ..scene.rig.clone() }, ..scene };
    let mut renderer = Renderer::new(&gpu, &still, Settings::default()).expect("a renderer");
    for seconds in [0.0, 0.5, 1.0] {
        renderer.draw(&frame(&still, seconds, Show::World)).expect("a frame");
    }
    assert_eq!(renderer.deformations(), 1, "time alone bends nothing");
}

#[test]
fn the_time_of_bending_is_a_stage_of_its_own() {
    let (gpu, mut scene) = (gpu(), yard());
    add_tube(&mut scene, 2, 2, 1.0, node(None, DVec3::ZERO));
    assert!(gpu.adapter.timestamps, "the test's adapter has timestamps");
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let first = renderer.render(&frame(&scene, 0.0, Show::World)).expect("a frame").times;
    let second = renderer.render(&frame(&scene, 0.0, Show::World)).expect("a frame").times;
    assert!(first.deform > 0.0 && second.deform == 0.0, "{first:?}, {second:?}");
    assert!(first.casters > 0.0 && first.shade > 0.0, "{first:?}");
}

#[test]
fn a_frame_of_bent_bodies_after_the_first_makes_nothing_on_the_device() {
    let (gpu, mut scene) = (gpu(), yard());
    add_tube(&mut scene, 2, 2, 0.0, node(None, DVec3::ZERO));
    let joint = scene.rig.skins[0].joints[1].0;
    turn_over_time(&mut scene, joint, 0.3);
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let mut made = |seconds| {
        renderer.draw(&frame(&scene, seconds, Show::World)).expect("a frame");
        gpu.wait().expect("a device");
        gpu.made()
    };
    let first = made(0.0);
    for seconds in [0.1, 0.2, 0.3] {
        assert_eq!(made(seconds), first, "at {seconds} s");
    }
}

#[test]
fn what_hangs_on_a_hidden_node_neither_casts_nor_shows() {
    let (gpu, mut scene) = (gpu(), yard());
    let without = visibility(&gpu, &scene, 0.0, &Settings::default());
    let tube = add_tube(&mut scene, 2, 2, 0.5, node(None, DVec3::ZERO));
    let hiding = |keys: [bool; 2]| {
        Track::Visible(Curve::new(vec![0.0, 1.0], Keys::Step(keys.into())).expect("two keys"))
    };
    let root = scene.instances[tube].node.expect("a node");
    play(&mut scene, Channel { node: root, track: hiding([true, false]) });
    let shown = visibility(&gpu, &scene, 0.5, &Settings::default());
    assert!(shown.iter().zip(&without).filter(|(a, b)| a != b).count() > 500, "it casts while it is seen");
    assert!(visibility(&gpu, &scene, 1.5, &Settings::default()) == without, "hidden");
    // The same without culling, and hidden from the start.
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    renderer.cull_parts = false;
    let drawn = renderer.draw(&frame(&scene, 1.5, Show::Visibility(0))).expect("a frame");
    let picture = drawn.picture().expect("a picture").rgba;
    assert!(picture.chunks_exact(4).map(|pixel| pixel[0]).eq(without.iter().copied()), "without culling");
    scene.rig.playing = None;
    scene.rig.nodes[root].visible = false;
    assert!(visibility(&gpu, &scene, 0.0, &Settings::default()) == without, "hidden at rest");
}

#[test]
fn a_node_that_an_animation_mirrors_casts_with_the_faces_that_were_asked_for() {
    let (gpu, mut scene) = (gpu(), yard());
    add_tube(&mut scene, 2, 2, 0.9, node(None, DVec3::X));
    let scales = Keys::Step(vec![Vec3::ONE, Vec3::new(-1.0, 1.0, 1.0)]);
    let track = Track::Scale(Curve::new(vec![0.0, 1.0], scales).expect("two keys"));
    let root = scene.instances[1].node.expect("a node");
    play(&mut scene, Channel { node: root, track });
    for casters in [CasterFaces::Front, CasterFaces::Back] {
        let bias = Bias { casters, ..Bias::default() };
        let settings = Settings { bias, filter: Filter::Hard {}, ..Settings::default() };
        for seconds in [0.5, 1.5] {
            let still = baked(&scene, &scene.pose(seconds));
            let (moving, still) =
                (visibility(&gpu, &scene, seconds, &settings), visibility(&gpu, &still, 0.0, &settings));
            let off = moving.iter().zip(&still).filter(|(a, b)| a != b).count();
            assert!(off < 200, "{casters:?} at {seconds} s: {off} pixels differ");
        }
    }
}

#[test]
fn poses_without_numbers_are_drawn_as_nothing_and_refuse_nothing() {
    let (gpu, mut scene) = (gpu(), yard());
    let without = visibility(&gpu, &scene, 0.0, &Settings::default());
    add_tube(&mut scene, 2, 2, 0.5, node(None, DVec3::ZERO));
    add_sheet(&mut scene, [f32::NAN, f32::INFINITY, 1e38], node(None, DVec3::ZERO));
    for broken in [f64::NAN, f64::INFINITY, 1e300] {
        scene.rig.nodes[0].rest = node(None, DVec3::splat(broken)).rest;
        assert!(visibility(&gpu, &scene, 0.0, &Settings::default()) == without, "{broken}");
    }
    scene.meshes.push(Mesh::new("empty", &[]));
    let empty = Instance { mesh: scene.meshes.len() - 1, ..scene.instances[1].clone() };
    scene.instances.push(empty);
    assert!(visibility(&gpu, &scene, 0.0, &Settings::default()) == without);
}

/// Everything is traced.
fn traced() -> Settings {
    Settings { exact: Exact::Always, ..Settings::default() }
}

#[test]
fn rays_take_poses_without_numbers_for_nothing_and_end() {
    let (gpu, mut scene) = (gpu(), yard());
    let without = visibility(&gpu, &scene, 0.0, &traced());
    let tube = add_tube(&mut scene, 2, 2, 0.5, node(None, DVec3::ZERO));
    add_sheet(&mut scene, [f32::NAN, f32::INFINITY, 1e38], node(None, DVec3::ZERO));
    let rest = scene.rig.nodes[0].rest;
    for broken in [f64::NAN, f64::INFINITY, 1e300] {
        scene.rig.nodes[0].rest = node(None, DVec3::splat(broken)).rest;
        assert!(visibility(&gpu, &scene, 0.0, &traced()) == without, "{broken}");
    }
    // One vertex alone.
    scene.rig.nodes[0].rest = rest;
    let mesh = scene.instances[tube].mesh;
    let whole = visibility(&gpu, &scene, 0.0, &traced());
    assert!(whole != without, "a tube casts");
    for broken in [f32::NAN, f32::INFINITY, f32::MAX] {
        scene.meshes[mesh].positions[30] = Vec3::new(0.2, broken, 0.0);
        let visibility = visibility(&gpu, &scene, 0.0, &traced());
        assert_eq!(visibility.len(), whole.len(), "it ends");
    }
}

#[test]
fn rays_follow_what_another_renderer_of_the_scene_has_bent() {
    let (gpu, mut scene) = (gpu(), yard());
    add_tube(&mut scene, 2, 2, 0.0, node(None, DVec3::ZERO));
    let joint = scene.rig.skins[0].joints[1].0;
    turn_over_time(&mut scene, joint, 1.5);
    let picture = |renderer: &mut Renderer, seconds| {
        let drawn = renderer.draw(&frame(&scene, seconds, Show::Visibility(0))).expect("a frame");
        drawn.picture().expect("a picture").rgba
    };
    let mut fresh = Renderer::new(&gpu, &scene, traced()).expect("a renderer");
    let wanted = [0.0, 1.0, 1.5].map(|seconds| picture(&mut fresh, seconds));
    assert!(wanted[0] != wanted[1] && wanted[1] != wanted[2], "it turns");
    let mut maps = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    let mut rays = maps.beside(traced()).expect("another");
    // What rays go through comes when the pose is in the buffers already.
    picture(&mut maps, 1.0);
    rays.set_ray_casters(&RayCasters::of(&scene)).expect("room");
    assert!(picture(&mut rays, 1.0) == wanted[1], "the first pose");
    for (seconds, wanted) in [(1.5, &wanted[2]), (0.0, &wanted[0]), (1.0, &wanted[1])] {
        picture(&mut maps, seconds);
        assert!(picture(&mut rays, seconds) == *wanted, "at {seconds} s");
    }
}

#[test]
fn instances_that_are_bent_alike_share_their_vertices() {
    let (gpu, mut scene) = (gpu(), yard());
    let sheet = add_sheet(&mut scene, [1.0, 0.0, 0.0], node(None, DVec3::ZERO));
    let first = scene.instances[sheet].clone();
    for i in 0..100_000u32 {
        let at = Vec3::new((i % 300) as f32, 0.0, (i / 300) as f32) * 3.0;
        let motion = umbrage_scene::Motion::Node { node: 0, node_from_thing: Mat4::from_translation(at) };
        scene.instances.push(Instance { motion, ..first.clone() });
    }
    // Vertices of their own would take two thousand million bytes.
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    renderer.draw(&frame(&scene, 0.0, Show::Visibility(0))).expect("a frame");
    let last = renderer.bent_vertices(scene.instances.len() - 1).expect("vertices");
    assert_eq!(last, renderer.bent_vertices(sheet).expect("vertices"));
}
