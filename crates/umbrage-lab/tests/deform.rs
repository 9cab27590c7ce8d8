//! The judge sees what joints and morph targets bend as it sees the same pose in still meshes, and finds the renderer's shadows
//! of it as right. Rays through what is bent agree with the judge's own, but for pixels at edges.

#[path = "../../umbrage-render/tests/deform/bodies.rs"]
mod bodies;
#[path = "../../umbrage-render/tests/deform/reference.rs"]
mod reference;

use std::sync::Arc;

use bodies::{add_sheet, add_tube, bodies, node, turn_over_time, yard};
use glam::{DVec3, Mat4, Quat, Vec3};
use reference::baked;
use umbrage::{Exact, Settings};
use umbrage_judge::{Eye, Pixel, Truth, World};
use umbrage_lab::{Laboratory, Shot, TruthKind};
use umbrage_render::Gpu;
use umbrage_scene::{Light, Motion, Pose, Scene};

fn shot(scene: &Scene, pose: Pose) -> Shot {
    Shot {
        camera: scene.cameras[0].clone(),
        lights: scene.lights.clone(),
        pose: Arc::new(pose),
        width: 240,
        height: 160,
    }
}

fn lights() -> [Light; 2] {
    [Light::sun(Vec3::new(0.6, -1.0, -0.3), 3.0), Light::point("lamp", Vec3::new(-2.0, 4.0, 1.5), 20.0, 40.0)]
}

#[test]
fn the_judge_sees_a_pose_as_it_sees_the_same_in_still_meshes() {
    for (name, scene) in bodies() {
        let pose = scene.pose(0.0);
        let still = baked(&scene, &pose);
        let (moving, still) = (World::new(&scene, &pose), World::new(&still, &Pose::default()));
        assert_eq!(moving.triangles().len(), still.triangles().len(), "{name}");
        let eye = Eye::new(&scene.cameras[0], 240, 160);
        let light = umbrage_judge::Light::of(&scene.lights[0]);
        let [a, b] = [&moving, &still].map(|world| Truth::new(world, &eye, &light, 1e3));
        assert!(a.count(Pixel::Shadowed) > 150, "{name}: {} pixels in shadow", a.count(Pixel::Shadowed));
        let differs = |(a, b): &(&Pixel, &Pixel)| a != b && a.is_judged() && b.is_judged();
        let differing = a.pixels.iter().zip(&b.pixels).filter(differs).count();
        // Still meshes are rounded to f32: an edge through a pixel's middle may lie on its other side.
        assert!(differing <= 2, "{name}: {differing} pixels differ");
        let unknown = a.count(Pixel::Ambiguous);
        assert!(unknown <= b.count(Pixel::Ambiguous) + 100, "{name}: {unknown} pixels depend on rounding");
        let still_ones = (0..moving.triangles().len()).filter(|i| moving.is_still(*i)).count();
        assert!(still_ones < moving.triangles().len(), "{name}: what bends is not still");
    }
}

#[test]
fn shadows_of_what_is_bent_are_as_right_as_those_of_still_meshes() {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let mut wrong = Vec::new();
    for (name, mut scene) in bodies() {
        scene.lights = lights().into();
        let origin = scene.instances[0].world_from_mesh.w_axis.truncate();
        scene.lights[1].world_from_light.w_axis += origin.extend(0.0);
        let settings = Settings::default();
        let measured = |scene: &Scene| {
            let shot = shot(scene, scene.pose(0.0));
            let mut laboratory = Laboratory::new(&gpu, scene).expect("a laboratory");
            let judged = laboratory.judge(&shot, &settings, None, TruthKind::Hard, 0).expect("a measurement");
            judged.measurement.error.expect("judged pixels")
        };
        let (moving, still) = (measured(&scene), measured(&baked(&scene, &scene.pose(0.0))));
        println!(
            "{name}: {} and {} mis-shadowed, {} and {}",
            moving.mis_shadowed, still.mis_shadowed, moving.mae, still.mae
        );
        if moving.mis_shadowed > still.mis_shadowed + 5e-4 || moving.mis_shadowed > 0.01 || moving.mae > 0.01
        {
            wrong.push(format!("{name}: {moving:?}\nstill: {still:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Bodies that are far from how they are at rest, or share what bends them.
fn far_bodies() -> Vec<(&'static str, Scene)> {
    let mut coiled = yard();
    add_tube(&mut coiled, 8, 3, 9.0, node(None, DVec3::new(0.5, 0.4, 0.0)));
    let mut torn = yard();
    add_sheet(&mut torn, [-4.0, 9.0, 6.0], node(None, DVec3::Y * 2.0));
    let mut shared = yard();
    let sheet = add_sheet(&mut shared, [1.0, -0.7, 0.5], node(None, DVec3::new(-1.0, 0.3, 0.0)));
    let mut second = shared.instances[sheet].clone();
    let node_from_thing = Mat4::from_scale_rotation_translation(
        Vec3::new(0.6, 1.0, -0.8),
        Quat::from_rotation_z(0.4),
        Vec3::new(1.7, 0.6, 0.5),
    );
    second.motion = Motion::Node { node: second.node.expect("a node"), node_from_thing };
    shared.instances.push(second);
    vec![
        ("a tube that is coiled up", coiled),
        ("a sheet pulled far", torn),
        ("a shape of two instances", shared),
    ]
}

/// Holds that rays have hardly a pixel of a shot wrong: two lights of 38 400 each, and an edge may lie through a pixel's middle.
fn check_rays(laboratory: &mut Laboratory<'_>, shot: &Shot, what: &str) {
    let settings = Settings { exact: Exact::Always, ..Settings::default() };
    let judged = laboratory.judge(shot, &settings, None, TruthKind::Hard, 0).expect("a measurement");
    let truth = &judged.measurement.truth;
    let wrong = judged.measurement.error.expect("judged pixels").mis_shadowed * truth.pixels as f64;
    println!("{what}: {wrong:.0} wrong, {} in shadow", truth.shadowed);
    assert!(truth.shadowed > 250, "{what}: {} in shadow", truth.shadowed);
    assert!(wrong < 3.5, "{what}: {wrong} pixels are wrong");
}

#[test]
fn rays_see_what_is_bent_as_the_judge_does() {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    for (name, mut scene) in bodies().into_iter().chain(far_bodies()) {
        scene.lights = lights().into();
        let origin = scene.instances[0].world_from_mesh.w_axis.truncate();
        scene.lights[1].world_from_light.w_axis += origin.extend(0.0);
        let mut laboratory = Laboratory::new(&gpu, &scene).expect("a laboratory");
        check_rays(&mut laboratory, &shot(&scene, scene.pose(0.0)), name);
    }
}

#[test]
fn rays_follow_an_animation() {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let mut scene = yard();
    scene.lights = lights().into();
    add_tube(&mut scene, 3, 2, 0.2, node(None, DVec3::NEG_X * 0.5));
    let (root, joint) = (0, scene.rig.skins[0].joints[1].0);
    let hung = scene.rig.nodes.len();
    add_sheet(&mut scene, [0.4; 3], node(None, DVec3::new(0.8, 0.4, 0.0)));
    turn_over_time(&mut scene, joint, -2.0);
    turn_over_time(&mut scene, root, 0.6);
    turn_over_time(&mut scene, hung, 1.0);
    let mut laboratory = Laboratory::new(&gpu, &scene).expect("a laboratory");
    for seconds in [0.0, 0.7, 1.3, 1.9, 0.3] {
        check_rays(&mut laboratory, &shot(&scene, scene.pose(seconds)), &format!("at {seconds} s"));
    }
}

#[test]
fn the_judge_leaves_out_what_is_hidden() {
    let mut scene = yard();
    let ground = World::new(&scene, &scene.pose(0.0)).triangles().len();
    let tube = add_tube(&mut scene, 2, 2, 0.5, node(None, DVec3::ZERO));
    assert!(World::new(&scene, &scene.pose(0.0)).triangles().len() > ground);
    let root = scene.instances[tube].node.expect("a node");
    scene.rig.nodes[root].visible = false;
    assert_eq!(World::new(&scene, &scene.pose(0.0)).triangles().len(), ground);
}
