//! What a crowd costs: a hundred figures of one mesh that walk, each in a pose of its own, and the time of each stage of their
//! frames, beside that of a hundred still copies.
//!
//! `cargo run --release -p umbrage-render --example crowd -- [FIGURES] [FRAMES] [PICTURE.png]`

use std::f32::consts::TAU;
use std::sync::Arc;

use glam::{DVec3, Mat4, Quat, Vec2, Vec3};
use umbrage_render::umbrage::Settings;
use umbrage_render::{Frame, FrameTimes, Gpu, RenderError, Rendered, Renderer, Show};
use umbrage_scene::rig::{Animation, Channel, Node, Place, Skin, Track};
use umbrage_scene::{
    Camera, Curve, Influences, Instance, Keys, Light, Material, Mesh, Motion, Primitive, Scene,
};

/// A bone: its parent, where its joint is, and where its limb ends, in metres; how far it swings, in radians, and when.
type Bone = (usize, [f32; 3], [f32; 3], f32, f32);

/// The hip is joint 0, and bone `i` is joint `i + 1`.
const BONES: [Bone; 14] = [
    (0, [0.0, 1.0, 0.0], [0.0, 1.25, 0.0], 0.05, 0.0),
    (1, [0.0, 1.25, 0.0], [0.0, 1.5, 0.0], 0.05, 0.5),
    (2, [0.0, 1.5, 0.0], [0.0, 1.62, 0.0], 0.1, 0.0),
    (3, [0.0, 1.62, 0.0], [0.0, 1.8, 0.0], 0.1, 0.3),
    (2, [0.18, 1.45, 0.0], [0.22, 1.15, 0.0], 0.6, 0.5),
    (5, [0.22, 1.15, 0.0], [0.24, 0.9, 0.0], 0.3, 0.5),
    (6, [0.24, 0.9, 0.0], [0.24, 0.78, 0.0], 0.2, 0.5),
    (2, [-0.18, 1.45, 0.0], [-0.22, 1.15, 0.0], 0.6, 0.0),
    (8, [-0.22, 1.15, 0.0], [-0.24, 0.9, 0.0], 0.3, 0.0),
    (9, [-0.24, 0.9, 0.0], [-0.24, 0.78, 0.0], 0.2, 0.0),
    (0, [0.1, 0.98, 0.0], [0.1, 0.5, 0.0], 0.55, 0.0),
    (11, [0.1, 0.5, 0.0], [0.1, 0.04, 0.0], 0.5, 0.25),
    (0, [-0.1, 0.98, 0.0], [-0.1, 0.5, 0.0], 0.55, 0.5),
    (13, [-0.1, 0.5, 0.0], [-0.1, 0.04, 0.0], 0.5, 0.75),
];

fn start(joint: usize) -> Vec3 {
    if joint == 0 { Vec3::Y } else { Vec3::from_array(BONES[joint - 1].1) }
}

/// A figure of 1.8 m of round limbs, each of which bends into its parent's at its joint.
fn figure() -> Mesh {
    const SIDES: usize = 16;
    const RINGS: usize = 20;
    let mut body = Primitive {
        influences: Influences { per_vertex: 4, ..Influences::default() },
        material: 1,
        ..Primitive::default()
    };
    for (i, (parent, from, to, ..)) in BONES.into_iter().enumerate() {
        let (from, to) = (Vec3::from_array(from), Vec3::from_array(to));
        let first = body.positions.len() as u32;
        for step in 0..RINGS * SIDES {
            let share = (step / SIDES) as f32 / (RINGS - 1) as f32;
            let (sin, cos) = ((step % SIDES) as f32 / SIDES as f32 * TAU).sin_cos();
            let round = (4.0 * share * (1.0 - share)).sqrt().max(0.05);
            let thick = if i < 3 { Vec3::new(0.18, 1.0, 0.11) } else { Vec3::new(0.07, 1.0, 0.07) };
            let side = Vec3::new(cos, 0.0, sin);
            body.positions.push(from.lerp(to, share) + side * thick * round.powf(0.3));
            body.normals.push(side);
            body.uvs.push(Vec2::ZERO);
            let own = (0.5 + 2.0 * share).min(1.0);
            body.influences.joints.extend([i as u16 + 1, parent as u16, 0, 0]);
            body.influences.weights.extend([own, 1.0 - own, 0.0, 0.0]);
        }
        for ring in 0..RINGS as u32 - 1 {
            for side in 0..SIDES as u32 {
                let at = |ring: u32, side: u32| first + ring * SIDES as u32 + side % SIDES as u32;
                let (a, b, c, d) =
                    (at(ring, side), at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side));
                body.indices.extend([a, b, c, a, c, d]);
            }
        }
    }
    Mesh::new("figure", &[body])
}

/// Lets one more figure walk, from a place and turned somewhere, at a phase of its own.
fn add_figure(scene: &mut Scene, at: Vec3, yaw: f32, phase: f32) {
    let first = scene.rig.nodes.len();
    let rest = |translation: Vec3, rotation| Place::Parts {
        translation: translation.as_dvec3(),
        rotation,
        scale: Vec3::ONE,
    };
    let node = |parent, rest| Node { name: String::new(), parent, rest, visible: true, weights: Vec::new() };
    scene.rig.nodes.push(node(None, rest(at + start(0), Quat::from_rotation_y(yaw))));
    let mut joints = vec![(first, Mat4::from_translation(-start(0)))];
    for (i, (parent, from, _, swing, delay)) in BONES.into_iter().enumerate() {
        let place = Vec3::from_array(from) - start(parent);
        scene.rig.nodes.push(node(Some(first + parent), rest(place, Quat::IDENTITY)));
        joints.push((first + i + 1, Mat4::from_translation(-Vec3::from_array(from))));
        let times: Vec<f32> = (0..=16).map(|key| key as f32 / 16.0).collect();
        let turn = |time: &f32| Quat::from_rotation_x(swing * ((time + delay + phase) * TAU).sin());
        let turns = times.iter().map(turn).collect();
        if let Some(curve) = Curve::new(times, Keys::Linear(turns)) {
            let channel = Channel { node: first + i + 1, track: Track::Rotation(curve) };
            scene.rig.animations[0].channels.push(channel);
        }
    }
    let skin = scene.rig.skins.len();
    scene.rig.skins.push(Skin { joints });
    let motion = Motion::Skin { node: first };
    let world_from_mesh = Mat4::from_translation(at + start(0));
    scene.instances.push(Instance {
        motion,
        node: Some(first),
        skin: Some(skin),
        ..Instance::still(1, world_from_mesh)
    });
}

fn crowd(figures: usize) -> Scene {
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
    let ground = Primitive {
        positions: corners.map(|(x, z)| Vec3::new(x, 0.0, z) * 60.0).into(),
        normals: vec![Vec3::Y; 4],
        uvs: vec![Vec2::ZERO; 4],
        indices: vec![0, 1, 2, 0, 2, 3],
        ..Primitive::default()
    };
    let mut scene = Scene {
        meshes: vec![Mesh::new("ground", &[ground]), figure()],
        instances: vec![Instance::still(0, Mat4::IDENTITY)],
        materials: vec![Material::plain("sand", 0.6, 0.55, 0.5), Material::plain("cloth", 0.25, 0.35, 0.6)],
        cameras: vec![Camera::looking("main", Vec3::new(0.0, 4.0, 14.0), Vec3::Y, 0.9, 0.1, 200.0)],
        lights: vec![Light::sun(Vec3::new(0.6, -1.0, -0.4), 3.0)],
        ..Scene::default()
    };
    scene.rig.animations.push(Animation { name: "walk".to_owned(), seconds: 1.0, channels: Vec::new() });
    scene.rig.playing = Some(0);
    let side = (figures as f32).sqrt().ceil() as usize;
    for i in 0..figures {
        let [x, z] = [i % side, i / side].map(|i| 1.6 * (i as f32 - 0.5 * (side as f32 - 1.0)));
        add_figure(&mut scene, Vec3::new(x, 0.0, z), i as f32 * 2.4, i as f32 * 0.137);
    }
    scene
}

/// The same figures without their rig, as they stand at rest.
fn still(scene: &Scene) -> Scene {
    let mut still = scene.clone();
    for instance in &mut still.instances {
        let skin = instance.skin.take();
        if let Some((node, _)) = skin.and_then(|skin| scene.rig.skins[skin].joints.first()) {
            let root = scene.pose(0.0).world_from_node(*node);
            instance.world_from_mesh = (root * glam::DMat4::from_translation(DVec3::NEG_Y)).as_mat4();
        }
        (instance.motion, instance.node) = (Motion::Still, None);
    }
    still
}

/// The median of each stage over some frames, and what was drawn into each view.
fn time(gpu: &Gpu, scene: &Scene, frames: usize) -> Result<String, RenderError> {
    let mut renderer = Renderer::new(gpu, scene, Settings::default())?;
    let (mut all, mut views, mut size) = (Vec::new(), 0, 0);
    for number in 0..frames + 3 {
        let pose = Arc::new(scene.pose(number as f32 / 60.0));
        let frame = Frame::of(&scene.cameras[0], &scene.lights, &pose, [1280, 720], Show::World)?;
        let Rendered { drawn, times } = renderer.render(&frame)?;
        (views, size) = (drawn.loads().len(), drawn.loads().iter().map(|view| view.triangles).sum::<u64>());
        if number >= 3 {
            all.push(times);
        }
    }
    let median = |pick: fn(&FrameTimes) -> f64| {
        let mut times: Vec<f64> = all.iter().map(pick).collect();
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    };
    Ok(format!(
        "plan {:.2}  deform {:.2}  casters {:.2}  shade {:.2}  frame {:.2} ms; {views} views of {size} triangles, \
         bent {} times in {} frames",
        median(|t| t.plan),
        median(|t| t.deform),
        median(|t| t.casters),
        median(|t| t.shade),
        median(|t| t.frame),
        renderer.deformations(),
        frames + 3
    ))
}

fn main() -> Result<(), RenderError> {
    let mut arguments = std::env::args().skip(1).filter_map(|argument| argument.parse().ok());
    let (figures, frames) = (arguments.next().unwrap_or(100), arguments.next().unwrap_or(20).max(1));
    let (gpu, scene) = (Gpu::new(None)?, crowd(figures));
    let vertices = scene.meshes[1].positions.len();
    println!("{figures} figures of {vertices} vertices and {} joints on {}", BONES.len() + 1, gpu.adapter);
    println!("walking: {}", time(&gpu, &scene, frames)?);
    println!("still:   {}", time(&gpu, &still(&scene), frames)?);
    if let Some(path) = std::env::args().nth(3) {
        let mut renderer = Renderer::new(&gpu, &scene, Settings::default())?;
        let pose = Arc::new(scene.pose(0.3));
        let frame = Frame::of(&scene.cameras[0], &scene.lights, &pose, [1280, 720], Show::World)?;
        let picture = renderer.draw(&frame)?.picture()?;
        let saved = image::save_buffer(
            &path,
            &picture.rgba,
            picture.width,
            picture.height,
            image::ExtendedColorType::Rgba8,
        );
        saved.map_err(|error| RenderError::Device(format!("the picture is not saved: {error}: {path}")))?;
    }
    Ok(())
}
