//! Boxes of what joints and morph targets bend: they hold every vertex in every pose, and are not much larger than they need
//! be.

use glam::{DMat4, DVec3, EulerRot, Mat4, Quat, Vec2, Vec3};
use proptest::prelude::*;
use umbrage_scene::rig::{Node, Place, Skin};
use umbrage_scene::{
    Aabb, DeformedBounds, Influences, Instance, Mesh, MorphTarget, Motion, Primitive, Scene,
};

/// Where every vertex of a part goes, in f64.
fn bent(mesh: &Mesh, part: usize, joints: &[Mat4], weights: &[f32]) -> Vec<DVec3> {
    let range = mesh.parts[part].indices.clone();
    let vertex = |index: &u32| {
        let i = *index as usize;
        let morphed =
            mesh.targets.iter().zip(weights).fold(mesh.positions[i].as_dvec3(), |at, (target, weight)| {
                at + target.positions[i].as_dvec3() * f64::from(*weight)
            });
        if joints.is_empty() {
            return morphed;
        }
        let terms = mesh.influences.of(i).map(|(joint, weight)| joints[joint].as_dmat4() * f64::from(weight));
        (terms.fold(DMat4::ZERO, |sum, term| sum + term) * morphed.extend(1.0)).truncate()
    };
    mesh.indices[range.start as usize..range.end as usize].iter().map(vertex).collect()
}

fn holds(outer: Aabb, point: DVec3) -> bool {
    point.cmpge(outer.min.as_dvec3()).all() && point.cmple(outer.max.as_dvec3()).all()
}

/// A cloud of triangles with targets and influences.
fn cloud(points: &[Vec3], moves: &[Vec3], joints: usize, shares: &[f32]) -> Mesh {
    let count = points.len() / 3 * 3;
    let per_vertex = shares.len();
    let mut influences = Influences { per_vertex, ..Influences::default() };
    for vertex in 0..count {
        // Neighbours share most joints, as in a body.
        influences.joints.extend((0..per_vertex).map(|i| ((vertex / 7 + i) % joints) as u16));
        let turned: Vec<f32> = (0..per_vertex).map(|i| shares[(i + vertex) % per_vertex]).collect();
        let sum: f32 = turned.iter().sum();
        influences.weights.extend(turned.iter().map(|share| share / sum));
    }
    let targets = moves.iter().map(|step| MorphTarget {
        positions: (0..count)
            .map(|i| if i % 3 == 0 { *step } else { *step * (i as f32 / 20.0).sin() })
            .collect(),
        normals: vec![Vec3::ZERO; count],
    });
    let primitive = Primitive {
        positions: points[..count].to_vec(),
        normals: vec![Vec3::Y; count],
        uvs: vec![Vec2::ZERO; count],
        indices: (0..count as u32).collect(),
        influences,
        targets: targets.collect(),
        ..Primitive::default()
    };
    Mesh::new("cloud", &[primitive])
}

fn vector(size: f32) -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(-size..size).prop_map(Vec3::from_array)
}

fn joint() -> impl Strategy<Value = Mat4> {
    let scale = prop::array::uniform3(prop_oneof![-3.0f32..-0.01, 0.01f32..3.0]);
    (prop::array::uniform3(-3.0f32..3.0), vector(10.0), scale).prop_map(|([x, y, z], at, scale)| {
        let rotation = Quat::from_euler(EulerRot::XYZ, x, y, z);
        Mat4::from_scale_rotation_translation(Vec3::from_array(scale), rotation, at)
    })
}

proptest! {
    #[test]
    fn the_box_holds_every_vertex_that_joints_and_targets_bend(
        points in prop::collection::vec(vector(2.0), 3..90),
        moves in prop::collection::vec(vector(1.0), 0..4),
        joints in prop::collection::vec(joint(), 0..6),
        shares in prop::collection::vec(0.001f32..1.0, 1..7),
        weights in prop::collection::vec(-2.0f32..2.0, 0..4),
    ) {
        let mesh = cloud(&points, &moves, joints.len().max(1), &shares);
        let bounds = DeformedBounds::of(&mesh);
        for part in 0..mesh.parts.len() {
            let aabb = bounds.in_pose(part, &joints, &weights);
            for vertex in bent(&mesh, part, &joints, &weights) {
                prop_assert!(holds(aabb, vertex), "{vertex} is not in {aabb:?}");
            }
        }
    }
}

/// A figure of sticks, as skinned figures are: a hip, two thighs and shins, a trunk, two arms and a head, each a prism of its
/// own and of its parent's joint where it begins.
fn figure() -> Scene {
    const BONES: [(usize, [f32; 3], [f32; 3]); 8] = [
        // The parent, where the joint is, and where the limb ends.
        (0, [0.0, 1.0, 0.0], [0.0, 1.5, 0.0]),
        (0, [0.1, 1.0, 0.0], [0.1, 0.5, 0.0]),
        (2, [0.1, 0.5, 0.0], [0.1, 0.0, 0.0]),
        (0, [-0.1, 1.0, 0.0], [-0.1, 0.5, 0.0]),
        (4, [-0.1, 0.5, 0.0], [-0.1, 0.0, 0.0]),
        (1, [0.2, 1.5, 0.0], [0.2, 0.8, 0.0]),
        (1, [-0.2, 1.5, 0.0], [-0.2, 0.8, 0.0]),
        (1, [0.0, 1.5, 0.0], [0.0, 1.8, 0.0]),
    ];
    let place = |at: [f32; 3], from: [f32; 3]| Place::Parts {
        translation: (Vec3::from_array(at) - Vec3::from_array(from)).as_dvec3(),
        rotation: Quat::IDENTITY,
        scale: Vec3::ONE,
    };
    let node = |parent, rest| Node { name: String::new(), parent, rest, visible: true, weights: Vec::new() };
    let mut scene = Scene::default();
    scene.rig.nodes.push(node(None, place([0.0, 1.0, 0.0], [0.0; 3])));
    let mut joints = vec![(0, Mat4::from_translation(-Vec3::Y))];
    let mut body = Primitive {
        influences: Influences { per_vertex: 2, ..Influences::default() },
        ..Primitive::default()
    };
    let starts = |joint: usize| if joint == 0 { [0.0, 1.0, 0.0] } else { BONES[joint - 1].1 };
    for (i, (parent, from, to)) in BONES.into_iter().enumerate() {
        scene.rig.nodes.push(node(Some(parent), place(from, starts(parent))));
        joints.push((i + 1, Mat4::from_translation(-Vec3::from_array(from))));
        let (from, to) = (Vec3::from_array(from), Vec3::from_array(to));
        for step in 0..5 {
            let share = step as f32 / 4.0;
            let own = (0.5 + 2.0 * share).min(1.0);
            for corner in [Vec3::X, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Z] {
                body.positions.push(from.lerp(to, share) + corner * 0.06);
                body.normals.push(corner);
                body.uvs.push(Vec2::ZERO);
                body.influences.joints.extend([i as u16 + 1, parent as u16]);
                body.influences.weights.extend([own, 1.0 - own]);
            }
        }
        let first = (body.positions.len() - 20) as u32;
        body.indices.extend((0..16).flat_map(|j| [first + j, first + j + 4, first + (j + 1) % 20]));
    }
    scene.rig.skins.push(Skin { joints });
    scene.meshes.push(Mesh::new("figure", &[body]));
    let instance = Instance {
        motion: Motion::Skin { node: 0 },
        node: Some(0),
        skin: Some(0),
        ..Instance::still(0, Mat4::IDENTITY)
    };
    scene.instances.push(instance);
    scene
}

/// Lets the figure walk: legs and arms swing against each other, and knees bend.
fn step(scene: &mut Scene, phase: f32) {
    let swing = 0.6 * phase.sin();
    let turns = [(2, swing), (3, -0.5 * (1.0 + phase.cos())), (4, -swing), (6, -swing), (7, swing)];
    for (joint, radians) in turns {
        if let Place::Parts { rotation, .. } = &mut scene.rig.nodes[joint].rest {
            *rotation = Quat::from_rotation_x(radians);
        }
    }
    if let Place::Parts { translation, rotation, .. } = &mut scene.rig.nodes[0].rest {
        *translation = DVec3::new(3.0, 1.0, f64::from(phase));
        *rotation = Quat::from_rotation_y(0.5);
    }
}

#[test]
fn the_box_of_a_walking_figure_is_little_larger_than_it_must_be() {
    let mut scene = figure();
    for phase in 0..12 {
        step(&mut scene, phase as f32 * 0.5);
        let pose = scene.pose(0.0);
        let joints: Vec<Mat4> = pose.joints(&scene.rig, 0).collect();
        let place = scene.instances[0].world_from_mesh_in(&pose).w_axis.truncate();
        let vertices = bent(&scene.meshes[0], 0, &joints, &[]);
        let tight = Aabb::of_points(vertices.iter().map(|v| v.as_vec3() + place));
        let found = scene.bounds_in(&pose);
        assert!(vertices.iter().all(|v| holds(found, *v + place.as_dvec3())), "phase {phase}");
        let (tight, found) = (tight.size(), found.size());
        let larger = found / tight;
        assert!(
            larger.max_element() < 1.35 && larger.element_product() < 1.8,
            "phase {phase}: {found} for {tight}"
        );
    }
}

#[test]
fn what_is_hidden_is_in_no_box_and_what_is_morphed_is_in_the_scenes() {
    let mut scene = figure();
    scene.rig.nodes[0].visible = false;
    assert!(scene.bounds_in(&scene.pose(0.0)).is_empty());
    let box_of = |weight: f32| {
        let mesh = cloud(&[Vec3::ZERO, Vec3::X, Vec3::Z], &[Vec3::Y * 4.0], 1, &[1.0]);
        let mut scene =
            Scene { meshes: vec![Mesh { influences: Influences::default(), ..mesh }], ..Scene::default() };
        let rest = Place::Parts { translation: DVec3::Y, rotation: Quat::IDENTITY, scale: Vec3::splat(2.0) };
        scene.rig.nodes.push(Node {
            name: String::new(),
            parent: None,
            rest,
            visible: true,
            weights: vec![weight],
        });
        let motion = Motion::Node { node: 0, node_from_thing: Mat4::IDENTITY };
        scene.instances.push(Instance { motion, node: Some(0), ..Instance::still(0, Mat4::IDENTITY) });
        scene.bounds_in(&scene.pose(0.0)).max.y
    };
    // The first corner rises by four times the weight, in a node that doubles it and stands at 1.
    for (weight, top) in [(0.0, 1.0), (1.0, 9.0), (0.5, 5.0)] {
        assert!((box_of(weight) - top).abs() < 1e-4, "weight {weight}: {}", box_of(weight));
    }
}
