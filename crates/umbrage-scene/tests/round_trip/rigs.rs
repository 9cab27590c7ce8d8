//! Scenes that move, written and read again: they move as before, and in the end are the same bit for bit.
//!
//! Before that, nodes that nothing concerns leave the rig and others join it, places are rounded to f32, what is always
//! hidden goes, and then what moved only that.

use std::collections::HashMap;

use glam::{DMat4, Mat4, Quat, Vec3};
use proptest::collection::vec;
use proptest::prelude::*;
use umbrage_scene::rig::{Animation, Channel, Node, Place, Rig, Skin, Track};
use umbrage_scene::*;

use super::{assert_survives, direction, scene};

/// How many morph targets the meshes have.
const TARGETS: usize = 2;

fn near() -> impl Strategy<Value = Vec3> {
    [-9.0f32..9.0, -9.0f32..9.0, -9.0f32..9.0].prop_map(Vec3::from)
}

fn rotation() -> impl Strategy<Value = Quat> {
    (direction(), -3.0f32..3.0).prop_map(|(axis, angle)| Quat::from_axis_angle(axis, angle))
}

fn scale() -> impl Strategy<Value = Vec3> {
    [0.5f32..2.0, 0.5f32..2.0, -2.0f32..-0.5].prop_map(Vec3::from)
}

fn place() -> impl Strategy<Value = Place> {
    (near(), rotation(), scale(), any::<bool>()).prop_map(|(at, rotation, scale, is_matrix)| {
        let parts = Place::Parts { translation: at.as_dvec3(), rotation, scale };
        if is_matrix { Place::Matrix(parts.matrix().as_mat4().as_dmat4()) } else { parts }
    })
}

fn node(i: usize) -> impl Strategy<Value = Node> {
    let weights = vec(prop_oneof![Just(0.0f32), -2.0f32..2.0], TARGETS);
    ("n?", any::<Option<prop::sample::Index>>(), place(), 0..5u8, weights).prop_map(
        move |(name, parent, rest, hidden, weights)| Node {
            name,
            parent: parent.filter(|_| i > 0).map(|parent| parent.index(i.max(1))),
            rest,
            visible: hidden > 0,
            weights,
        },
    )
}

/// Keys of a curve, as many as times.
fn curve<T: Between + std::fmt::Debug + 'static>(
    value: impl Strategy<Value = T> + 'static,
) -> impl Strategy<Value = Curve<T>> {
    (1..5usize, 0..3u8, vec(value, 12), -0.5f32..0.5).prop_map(|(count, kind, values, start)| {
        let times = (0..count).map(|key| start + key as f32 * 0.7).collect();
        let keys = match kind {
            0 => Keys::Step(values[..count].to_vec()),
            1 => Keys::Linear(values[..count].to_vec()),
            _ => Keys::Cubic(values.as_chunks::<3>().0[..count.min(4)].to_vec()),
        };
        Curve::new(times, keys).expect("times grow")
    })
}

fn track() -> impl Strategy<Value = Track> {
    let seen = (vec(any::<bool>(), 3), -0.5f32..0.5).prop_map(|(seen, start)| {
        let times = vec![start, start + 0.5, start + 1.5];
        Track::Visible(Curve::new(times, Keys::Step(seen)).expect("times grow"))
    });
    prop_oneof![
        curve(near()).prop_map(Track::Translation),
        curve(rotation()).prop_map(Track::Rotation),
        curve(scale()).prop_map(Track::Scale),
        curve(vec(-2.0f32..2.0, TARGETS)).prop_map(Track::Weights),
        seen,
    ]
}

/// The tracks of an animation, and when it begins again.
type Moves = (Vec<(usize, Track)>, Option<f32>);

fn rig() -> impl Strategy<Value = Rig> {
    let nodes = [node(0), node(1), node(2), node(3), node(4)];
    let skin = vec((0..5usize, place()), 1..4);
    let channels = vec((0..5usize, track()), 1..6);
    let animations = vec((channels, prop_oneof![Just(None), (0.5f32..4.0).prop_map(Some)]), 0..3);
    (nodes, vec(skin, 1..3), animations, any::<prop::sample::Index>()).prop_map(
        |(nodes, skins, animations, playing)| {
            let joint = |(node, place): (usize, Place)| (node, place.matrix().as_mat4());
            // Matrices are not animated.
            let is_matrix = |node: usize| matches!(nodes[node].rest, Place::Matrix(_));
            let animations: Vec<Animation> = (0..)
                .zip(animations)
                .map(|(i, (channels, seconds)): (u32, Moves)| {
                    let channels: Vec<Channel> = channels
                        .into_iter()
                        .filter(|(node, track)| !(is_matrix(*node) && track.is_of_place()))
                        .map(|(node, track)| Channel { node, track })
                        .collect();
                    let last = channels.iter().filter_map(|channel| channel.track.times().last().copied());
                    let seconds = seconds.unwrap_or(last.fold(0.0, f32::max));
                    Animation { name: format!("animation {i}"), seconds, channels }
                })
                .collect();
            let playing = playing.index(animations.len() + 1);
            Rig {
                playing: Some(playing).filter(|playing| *playing < animations.len()),
                skins: skins
                    .into_iter()
                    .map(|joints| Skin { joints: joints.into_iter().map(joint).collect() })
                    .collect(),
                nodes: nodes.to_vec(),
                animations,
            }
        },
    )
}

/// Bends a mesh: so many joints a vertex, of weights that sum to 1.
fn bend(mesh: &mut Mesh, per_vertex: usize, seeds: &[u16]) {
    let count = mesh.positions.len();
    let seed = |i: usize| seeds[i % seeds.len()];
    let size = |i: usize| f32::from(seed(i + 5) % 7 + 1);
    let sum = |vertex: usize| (0..per_vertex).map(|k| size(vertex + k)).sum::<f32>();
    mesh.influences = Influences {
        per_vertex,
        joints: (0..count * per_vertex).map(seed).map(|joint| joint % 3).collect(),
        weights: (0..count * per_vertex)
            .map(|i| size(i / per_vertex + i % per_vertex) / sum(i / per_vertex))
            .collect(),
    };
    let target = |k: usize| MorphTarget {
        positions: (0..count).map(|i| Vec3::splat(size(i + k) - 4.0)).collect(),
        normals: (0..count).map(|i| Vec3::X * (size(i + k) - 4.0)).collect(),
    };
    mesh.targets = (0..TARGETS).map(target).collect();
}

/// What an instance or a light hangs on: kind, node, skin.
type Hook = (u8, usize, prop::sample::Index, Vec3);

fn moving() -> impl Strategy<Value = Scene> {
    let hooks = vec((0..4u8, 0..5usize, any::<prop::sample::Index>(), near()), 10);
    (scene(), rig(), hooks, 1..7usize, vec(any::<u16>(), 13)).prop_map(
        |(mut scene, mut rig, hooks, per_vertex, seeds): (Scene, Rig, Vec<Hook>, usize, Vec<u16>)| {
            // All skins have as many joints, which the mesh may use.
            for skin in &mut rig.skins {
                let first = skin.joints[0];
                skin.joints.resize(3, first);
            }
            bend(&mut scene.meshes[1], per_vertex, &seeds);
            let matrix = |at: Vec3| if at.x > 0.0 { Mat4::from_translation(at) } else { Mat4::IDENTITY };
            for ((i, instance), (kind, node, skin, at)) in scene.instances.iter_mut().enumerate().zip(&hooks)
            {
                instance.name =
                    if at.y > 0.0 { format!("instance {i}") } else { rig.nodes[*node].name.clone() };
                match kind {
                    0 => (instance.node, instance.skin) = (None, None),
                    1 | 2 => {
                        instance.node = Some(*node);
                        instance.motion = Motion::Node { node: *node, node_from_thing: matrix(*at) };
                    }
                    _ => {
                        let skin = skin.index(rig.skins.len());
                        (instance.mesh, instance.skin) = (1, Some(skin));
                        instance.node = (at.z > 0.0).then_some(*node);
                        instance.motion = Motion::Skin { node: rig.skins[skin].joints[0].0 };
                    }
                }
            }
            // One stays, so that none is added.
            for ((i, light), (kind, node, _, at)) in
                scene.lights.iter_mut().enumerate().skip(1).zip(&hooks[6..])
            {
                light.name = format!("light {i}");
                if *kind > 1 {
                    light.motion = Motion::Node { node: *node, node_from_thing: matrix(*at) };
                }
            }
            scene.rig = rig;
            scene
        },
    )
}

/// The times at which scenes are compared, seconds.
const TIMES: [f32; 5] = [0.0, 0.3, 0.9, 1.7, 5.0];

/// What is drawn in a pose: the corners of all triangles that are seen, and where lights stand, in any order.
fn drawn(scene: &Scene, pose: &Pose) -> Vec<(String, Vec<Vec3>)> {
    let baked = scene.baked(pose);
    let mut drawn: Vec<(String, Vec<Vec3>)> = Vec::new();
    for Instance { name, mesh, world_from_mesh, casts, .. } in &baked.instances {
        let Mesh { positions, indices, .. } = &baked.meshes[*mesh];
        let corner = |i: &u32| world_from_mesh.transform_point3(positions[*i as usize]);
        drawn.push((format!("{name} {casts}"), indices.iter().map(corner).collect()));
    }
    for light in &baked.lights {
        let axes = light.world_from_light;
        drawn.push((
            light.name.clone(),
            vec![axes.w_axis.truncate(), axes.w_axis.truncate() - axes.z_axis.truncate()],
        ));
    }
    let order = |(name, corners): &(String, Vec<Vec3>)| {
        let sum: f32 = corners.iter().map(|p| p.x + p.y + p.z).sum();
        (name.clone(), sum)
    };
    drawn.sort_by(|a, b| {
        let ((a, of_a), (b, of_b)) = (order(a), order(b));
        a.cmp(&b).then(of_a.total_cmp(&of_b))
    });
    drawn
}

/// The animation of this name, if there is one.
fn called(scene: &Scene, name: Option<&str>) -> Option<usize> {
    name.and_then(|name| scene.rig.animations.iter().position(|animation| animation.name == name))
}

fn assert_moves_alike(scene: &Scene, again: &Scene) {
    let names = scene.rig.animations.iter().map(|animation| Some(animation.name.as_str()));
    for name in names.chain([None]) {
        for seconds in TIMES {
            let pose = |scene: &Scene| scene.rig.pose_of(called(scene, name), seconds);
            let (want, got) = (drawn(scene, &pose(scene)), drawn(again, &pose(again)));
            assert_eq!(want.len(), got.len(), "{name:?} at {seconds} s");
            for ((label, want), (also, got)) in want.iter().zip(&got) {
                assert_eq!((label, want.len()), (also, got.len()), "{name:?} at {seconds} s");
                for (want, got) in want.iter().zip(got) {
                    let most = 1e-4 * want.abs().max_element().max(10.0);
                    assert!(
                        want.abs_diff_eq(*got, most),
                        "{label} of {name:?} at {seconds} s: {got}, not {want}"
                    );
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn scenes_that_move_survive(scene in moving()) {
        let read = load_glb_bytes(&to_glb(&scene).unwrap(), "again.glb");
        // Where all that has size is hidden for ever, nothing can be read.
        prop_assume!(read.is_ok());
        let Imported { scene: again, warnings } = read.unwrap();
        prop_assert_eq!(warnings, [""; 0]);
        assert_moves_alike(&scene, &again);
        let settled = (0..3).fold(again, |again, _| load_glb_bytes(&to_glb(&again).unwrap(), "again.glb").unwrap().scene);
        assert_moves_alike(&scene, &settled);
        assert_survives(&settled);
    }
}

/// A node under a node that turns, with a mesh of its own name on it.
#[test]
fn an_animated_tree_is_written_as_it_is() {
    let mesh = Mesh::new("sail", &[super::field(2)]);
    let nodes = [("mast", None), ("sail", Some(0))].map(|(name, parent)| Node {
        name: name.to_owned(),
        parent,
        rest: Place::HERE,
        visible: true,
        weights: Vec::new(),
    });
    let turn = Curve::new(vec![0.0, 1.0], Keys::Linear(vec![Quat::IDENTITY, Quat::from_rotation_y(1.0)]));
    let seen = Curve::new(vec![0.0, 0.5], Keys::Step(vec![true, false]));
    let channels = [(0, Track::Rotation(turn.unwrap())), (1, Track::Visible(seen.unwrap()))];
    let channels = channels.map(|(node, track)| Channel { node, track }).to_vec();
    let scene = Scene {
        name: "boat".to_owned(),
        meshes: vec![mesh],
        instances: vec![Instance {
            name: "sail".to_owned(),
            motion: Motion::Node { node: 1, node_from_thing: Mat4::IDENTITY },
            node: Some(1),
            ..Instance::still(0, Mat4::IDENTITY)
        }],
        materials: vec![Material::plain("cloth", 0.9, 0.9, 0.8)],
        cameras: vec![Camera::looking("c", Vec3::splat(40.0), Vec3::ZERO, 1.0, 0.1, 200.0)],
        lights: vec![Light::sun(Vec3::NEG_Y, 3.0)],
        path: CameraPath { keys: vec![PathKey { eye: Vec3::ONE, target: Vec3::ZERO }] },
        rig: Rig {
            nodes: nodes.to_vec(),
            skins: Vec::new(),
            animations: vec![Animation { name: "sway".to_owned(), seconds: 4.0, channels }],
            playing: None,
        },
        ..Scene::default()
    };
    assert_survives(&scene);
    let json = String::from_utf8_lossy(&to_glb(&scene).unwrap()).into_owned();
    let used: HashMap<&str, bool> = ["KHR_node_visibility", "KHR_animation_pointer"]
        .map(|name| (name, json.contains(&format!("\"{name}\""))))
        .into();
    assert!(used.values().all(|used| *used), "{used:?}");
    assert!(
        json.contains("/nodes/1/extensions/KHR_node_visibility/visible"),
        "the pointer leads to the sail"
    );
}

#[test]
fn rigs_that_contradict_themselves_are_not_written() {
    let spoils: [fn(&mut Rig); 6] = [
        |rig| rig.nodes[0].parent = Some(0),
        |rig| rig.nodes[0].rest = Place::Matrix(DMat4::from_cols_array(&[f64::NAN; 16])),
        |rig| rig.skins.push(Skin { joints: vec![(7, Mat4::IDENTITY)] }),
        |rig| rig.skins.push(Skin { joints: vec![(0, Mat4::NAN)] }),
        |rig| rig.animations[0].channels[0].node = 9,
        |rig| rig.animations[0].seconds = f32::NAN,
    ];
    for (i, spoil) in spoils.iter().enumerate() {
        let mut scene = super::large_scene();
        let up = Curve::new(vec![0.0], Keys::Step(vec![Vec3::Y])).unwrap();
        let channels = vec![Channel { node: 0, track: Track::Translation(up) }];
        scene.rig = Rig {
            nodes: vec![Node {
                name: String::new(),
                parent: None,
                rest: Place::HERE,
                visible: true,
                weights: Vec::new(),
            }],
            animations: vec![Animation { name: "up".to_owned(), seconds: 0.0, channels }],
            ..Rig::default()
        };
        to_glb(&scene).unwrap();
        spoil(&mut scene.rig);
        let error = to_glb(&scene).unwrap_err().to_string();
        assert!(error.ends_with("in scene \"large\"") && !error.contains('\n'), "spoil {i}: {error}");
    }
    let mut scene = super::large_scene();
    scene.instances[0].skin = Some(3);
    to_glb(&scene).unwrap_err();
    scene = super::large_scene();
    scene.instances[0].motion = Motion::Node { node: 3, node_from_thing: Mat4::IDENTITY };
    to_glb(&scene).unwrap_err();
}
