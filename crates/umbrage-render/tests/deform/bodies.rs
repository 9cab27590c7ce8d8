//! Bodies that bend, small enough to know: a tube on a chain of joints, and a sheet with morph targets.

use glam::{DMat4, DVec3, Mat4, Quat, Vec2, Vec3};
use umbrage_scene::rig::{Animation, Channel, Node, Place, Skin, Track};
use umbrage_scene::{
    Camera, Curve, Instance, Keys, Light, Material, Mesh, MorphTarget, Motion, Primitive, Scene,
};

/// A node that stands somewhere in its parent.
pub fn node(parent: Option<usize>, at: DVec3) -> Node {
    let rest = Place::Parts { translation: at, rotation: Quat::IDENTITY, scale: Vec3::ONE };
    Node { name: String::new(), parent, rest, visible: true, weights: Vec::new() }
}

/// A scene with a ground of 40 m a side, a sun from the side, and a camera that sees a few metres around the origin.
pub fn yard() -> Scene {
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
    let positions: Vec<Vec3> = corners.map(|(x, z)| Vec3::new(x, 0.0, z) * 20.0).into();
    let ground = Primitive {
        normals: vec![Vec3::Y; 4],
        uvs: vec![Vec2::ZERO; 4],
        indices: vec![0, 1, 2, 0, 2, 3],
        positions,
        ..Primitive::default()
    };
    Scene {
        meshes: vec![Mesh::new("ground", &[ground])],
        instances: vec![Instance::still(0, Mat4::IDENTITY)],
        materials: vec![Material::plain("grey", 0.6, 0.6, 0.6)],
        cameras: vec![Camera::looking(
            "main",
            Vec3::new(0.5, 3.0, 4.0),
            Vec3::new(0.3, 0.8, 0.0),
            0.9,
            0.1,
            100.0,
        )],
        lights: vec![Light::sun(Vec3::new(0.6, -1.0, -0.3), 3.0)],
        ..Scene::default()
    }
}

/// A tube up along y, 2 m high and 0.4 m thick, closed, that `joints` joints bend: each vertex follows `per_vertex` of them,
/// those nearest to its height.
pub fn tube(joints: usize, per_vertex: usize) -> Primitive {
    const SIDES: usize = 12;
    const RINGS: usize = 17;
    const HEIGHT: f32 = 2.0;
    let mut tube = Primitive::default();
    tube.influences.per_vertex = per_vertex;
    let spacing = HEIGHT / joints as f32;
    let mut push = |y: f32, radius: f32, side: usize, normal: Vec3| {
        let (sin, cos) = (side as f32 / SIDES as f32 * std::f32::consts::TAU).sin_cos();
        tube.positions.push(Vec3::new(cos * radius, y, sin * radius));
        tube.normals.push(if normal == Vec3::ZERO { Vec3::new(cos, 0.0, sin) } else { normal });
        tube.uvs.push(Vec2::new(side as f32, y));
        let mut near: Vec<(usize, f32)> =
            (0..joints).map(|joint| (joint, (y - joint as f32 * spacing).abs() / spacing)).collect();
        near.sort_by(|a, b| a.1.total_cmp(&b.1));
        near.truncate(per_vertex);
        let weights: Vec<f32> = near.iter().map(|(_, far)| (1.5 - far).max(0.0) + 1e-3).collect();
        let sum: f32 = weights.iter().sum();
        for i in 0..per_vertex {
            tube.influences.joints.push(near.get(i).map_or(0, |near| near.0 as u16));
            tube.influences.weights.push(weights.get(i).map_or(0.0, |weight| weight / sum));
        }
    };
    for ring in 0..RINGS {
        let y = ring as f32 / (RINGS - 1) as f32 * HEIGHT;
        (0..SIDES).for_each(|side| push(y, 0.2, side, Vec3::ZERO));
    }
    for (y, normal) in [(0.0, Vec3::NEG_Y), (HEIGHT, Vec3::Y)] {
        (0..SIDES).for_each(|side| push(y, 0.2, side, normal));
        push(y, 0.0, 0, normal);
    }
    let at = |ring: usize, side: usize| (ring * SIDES + side % SIDES) as u32;
    for ring in 1..RINGS {
        for side in 0..SIDES {
            let [a, b, c, d] =
                [at(ring - 1, side), at(ring - 1, side + 1), at(ring, side + 1), at(ring, side)];
            tube.indices.extend([a, c, b, a, d, c]);
        }
    }
    for (first, is_top) in [(RINGS * SIDES, false), (RINGS * SIDES + SIDES + 1, true)] {
        for side in 0..SIDES {
            let [a, b, middle] = [first + side, first + (side + 1) % SIDES, first + SIDES].map(|i| i as u32);
            tube.indices.extend(if is_top { [a, middle, b] } else { [a, b, middle] });
        }
    }
    tube
}

/// The nodes of a chain of joints up along y, and the skin for [`tube`]: each joint turns about z by its share of
/// `radians`. The first node's parent is `root`, where there is one.
pub fn chain(scene: &mut Scene, joints: usize, radians: f32, root: Node) -> (usize, usize) {
    let first = scene.rig.nodes.len();
    scene.rig.nodes.push(root);
    let spacing = 2.0 / joints as f64;
    let turn = Quat::from_rotation_z(radians / joints as f32);
    for joint in 0..joints {
        let at = if joint == 0 { DVec3::ZERO } else { DVec3::Y * spacing };
        let rotation = if joint == 0 { Quat::IDENTITY } else { turn };
        let rest = Place::Parts { translation: at, rotation, scale: Vec3::ONE };
        scene.rig.nodes.push(Node { rest, ..node(Some(first + joint), at) });
    }
    let bind = |joint: usize| DMat4::from_translation(DVec3::NEG_Y * spacing * joint as f64).as_mat4();
    let joints = (0..joints).map(|joint| (first + 1 + joint, bind(joint))).collect();
    scene.rig.skins.push(Skin { joints });
    (first, scene.rig.skins.len() - 1)
}

/// An instance that a skin bends, and whose weights are those of `node`.
pub fn skinned(scene: &Scene, mesh: usize, node: usize, skin: usize) -> Instance {
    let joint = scene.rig.skins[skin].joints[0].0;
    let world_from_mesh = Motion::Skin { node: joint }.moved(Mat4::IDENTITY, &scene.pose(0.0));
    Instance {
        motion: Motion::Skin { node: joint },
        node: Some(node),
        skin: Some(skin),
        ..Instance::still(mesh, world_from_mesh)
    }
}

/// Adds a tube that its joints bend.
pub fn add_tube(scene: &mut Scene, joints: usize, per_vertex: usize, radians: f32, root: Node) -> usize {
    let mesh = scene.meshes.len();
    scene.meshes.push(Mesh::new("tube", &[tube(joints, per_vertex)]));
    let (node, skin) = chain(scene, joints, radians, root);
    let instance = skinned(scene, mesh, node, skin);
    scene.instances.push(instance);
    scene.instances.len() - 1
}

/// A sheet of 2 m a side at a height of 1 m, with three targets: a hill, a wave across, and a corner that is pulled up.
pub fn sheet() -> Primitive {
    const CELLS: usize = 24;
    let mut sheet = Primitive { targets: vec![MorphTarget::default(); 3], ..Primitive::default() };
    for i in 0..(CELLS + 1) * (CELLS + 1) {
        let [x, z] = [i % (CELLS + 1), i / (CELLS + 1)].map(|i| 2.0 * i as f32 / CELLS as f32 - 1.0);
        sheet.positions.push(Vec3::new(x, 1.0, z));
        sheet.normals.push(Vec3::Y);
        sheet.uvs.push(Vec2::new(x, z));
        let hill = (1.0 - x * x - z * z).max(0.0);
        let corner = (x + z - 1.0).max(0.0);
        let moves = [Vec3::Y * hill, Vec3::new(0.1, 0.3 * (6.0 * x).sin(), 0.0), Vec3::splat(corner)];
        let turns = [
            Vec3::new(2.0 * x, 0.0, 2.0 * z) * f32::from(u8::from(hill > 0.0)),
            Vec3::new(-1.8 * (6.0 * x).cos(), 0.0, 0.0),
            Vec3::new(-1.0, 0.0, -1.0) * f32::from(u8::from(corner > 0.0)),
        ];
        for (target, (moves, turns)) in sheet.targets.iter_mut().zip(moves.into_iter().zip(turns)) {
            target.positions.push(moves);
            target.normals.push(turns);
        }
    }
    for i in 0..CELLS * CELLS {
        let a = (i / CELLS * (CELLS + 1) + i % CELLS) as u32;
        let (b, c) = (a + 1, a + CELLS as u32 + 1);
        sheet.indices.extend([a, c, b, b, c, c + 1]);
    }
    sheet
}

/// Adds a sheet that is morphed by its node's weights.
pub fn add_sheet(scene: &mut Scene, weights: [f32; 3], node: Node) -> usize {
    let (mesh, number) = (scene.meshes.len(), scene.rig.nodes.len());
    scene.meshes.push(Mesh::new("sheet", &[sheet()]));
    scene.rig.nodes.push(Node { weights: weights.into(), ..node });
    let motion = Motion::Node { node: number, node_from_thing: Mat4::IDENTITY };
    let world_from_mesh = motion.moved(Mat4::IDENTITY, &scene.pose(0.0));
    scene.instances.push(Instance { motion, node: Some(number), ..Instance::still(mesh, world_from_mesh) });
    scene.instances.len() - 1
}

/// Adds a tube that is both: targets make it thicker and lean, then joints bend it.
pub fn add_both(scene: &mut Scene, weights: [f32; 2], root: Node) -> usize {
    let mut both = tube(3, 2);
    let wider = both.positions.iter().map(|at| Vec3::new(at.x, 0.0, at.z) * 0.75).collect();
    let leaning = both.positions.iter().map(|at| Vec3::new(0.0, 0.0, 0.3 * at.y)).collect();
    let still = vec![Vec3::ZERO; both.positions.len()];
    both.targets = vec![
        MorphTarget { positions: wider, normals: still.clone() },
        MorphTarget { positions: leaning, normals: still },
    ];
    let mesh = scene.meshes.len();
    scene.meshes.push(Mesh::new("both", &[both]));
    let (node, skin) = chain(scene, 3, 1.2, Node { weights: weights.into(), ..root });
    let instance = skinned(scene, mesh, node, skin);
    scene.instances.push(instance);
    scene.instances.len() - 1
}

/// Lets an animation of two seconds play that turns a node about z, from 0 to `radians`.
pub fn turn_over_time(scene: &mut Scene, node: usize, radians: f32) {
    let turns = vec![Quat::IDENTITY, Quat::from_rotation_z(radians)];
    let track = Track::Rotation(Curve::new(vec![0.0, 2.0], Keys::Linear(turns)).expect("two keys"));
    play(scene, Channel { node, track });
}

/// Lets an animation play that has this channel among its own.
pub fn play(scene: &mut Scene, channel: Channel) {
    let animations = &mut scene.rig.animations;
    if animations.is_empty() {
        animations.push(Animation { name: "all".to_owned(), seconds: 2.0, channels: Vec::new() });
    }
    animations[0].channels.push(channel);
    scene.rig.playing = Some(0);
}

/// Bodies of all kinds, each with what it is called.
pub fn bodies() -> Vec<(&'static str, Scene)> {
    let mut all = Vec::new();
    let mut add = |name, make: &dyn Fn(&mut Scene)| {
        let mut scene = yard();
        make(&mut scene);
        all.push((name, scene));
    };
    let scaled = |scale: Vec3, at: DVec3| Node {
        rest: Place::Parts { translation: at, rotation: Quat::from_rotation_y(0.7), scale },
        ..node(None, at)
    };
    add("a tube with two joints", &|scene| {
        add_tube(scene, 2, 2, 1.2, node(None, DVec3::ZERO));
    });
    add("a sheet with three targets", &|scene| {
        add_sheet(scene, [0.7, -0.5, 1.3], node(None, DVec3::Y * 0.2));
    });
    add("joints and targets at once", &|scene| {
        add_both(scene, [1.0, 0.8], node(None, DVec3::X));
    });
    add("a mirrored tube", &|scene| {
        add_tube(scene, 3, 2, 1.5, scaled(Vec3::new(-1.0, 1.0, 1.0), DVec3::ZERO));
    });
    add("a tube scaled unevenly", &|scene| {
        add_tube(scene, 3, 2, 0.8, scaled(Vec3::new(2.0, 0.7, 0.5), DVec3::ZERO));
    });
    add("a mirrored sheet", &|scene| {
        add_sheet(scene, [1.0, 0.2, 0.4], scaled(Vec3::new(1.0, 1.0, -1.5), DVec3::ZERO));
    });
    add("seven joints a vertex", &|scene| {
        add_tube(scene, 8, 7, 2.0, node(None, DVec3::ZERO));
    });
    add("two instances of a mesh in two poses", &|scene| {
        let first = add_tube(scene, 2, 2, 1.0, node(None, DVec3::NEG_X));
        let mesh = scene.instances[first].mesh;
        let (node, skin) = chain(scene, 2, -1.4, node(None, DVec3::X));
        let second = skinned(scene, mesh, node, skin);
        scene.instances.push(second);
    });
    add("a still instance beside a bent one", &|scene| {
        let first = add_tube(scene, 2, 2, 1.0, node(None, DVec3::NEG_X));
        let mesh = scene.instances[first].mesh;
        scene.instances.push(Instance::still(mesh, Mat4::from_translation(Vec3::X * 2.0)));
    });
    add("a tube 100 km from the origin", &|scene| {
        let at = DVec3::new(1e5, 0.0, -1e5);
        add_tube(scene, 3, 2, 1.2, node(None, at + DVec3::new(0.377, 0.0, 0.1)));
        scene.instances[0].world_from_mesh = Mat4::from_translation(at.as_vec3());
        scene.cameras[0].world_from_camera.w_axis += at.as_vec3().extend(0.0);
    });
    add("thousands of joints", &|scene| {
        add_tube(scene, 3000, 5, 4.0, node(None, DVec3::ZERO));
    });
    all
}
