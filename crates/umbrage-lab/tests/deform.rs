//! The judge sees what joints and morph targets bend as it sees the same pose in still meshes, and finds the renderer's shadows
//! of it as right.

#[path = "../../umbrage-render/tests/deform/bodies.rs"]
#[expect(dead_code, reason = "tests of the renderer use the rest")]
mod bodies;
#[path = "../../umbrage-render/tests/deform/reference.rs"]
mod reference;

use std::sync::Arc;

use bodies::{add_tube, bodies, node, yard};
use glam::DVec3;
use reference::baked;
use umbrage::Settings;
use umbrage_judge::{Eye, Pixel, Truth, World};
use umbrage_lab::{Laboratory, Shot, TruthKind};
use umbrage_render::Gpu;
use umbrage_scene::{Light, Pose, Scene};

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
    [
        Light::sun(glam::Vec3::new(0.6, -1.0, -0.3), 3.0),
        Light::point("lamp", glam::Vec3::new(-2.0, 4.0, 1.5), 20.0, 40.0),
    ]
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
