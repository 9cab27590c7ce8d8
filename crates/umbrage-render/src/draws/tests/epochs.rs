//! Tests of which moves change an instance.

use glam::{DVec3, Mat4, Quat, Vec3};
use umbrage_scene::rig::{Animation, Channel, Node, Place, Skin, Track};
use umbrage_scene::{Curve, Keys, MorphTarget, Motion};

use super::*;

#[test]
fn an_epoch_is_the_number_of_the_last_move_that_changed_an_instance() {
    let mut scene = scene();
    let turn =
        |radians_per_second| Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second };
    scene.instances[1].motion = turn(1.0);
    // What turns by nothing may move, and does not.
    scene.instances[2].motion = turn(0.0);
    let mut table = PartTable::new(&scene);
    assert_eq!([0, 1, 2, 3].map(|i| table.can_move(i)), [false, true, true, false]);
    let mut epochs = |seconds| {
        table.move_to(&scene.instances, &Pose::at(seconds));
        [0, 1, 2, 3].map(|i| table.epoch(i))
    };
    assert_eq!(epochs(0.0), [0, 0, 0, 0], "it stands there already");
    assert_eq!(epochs(1.0), [0, 1, 0, 0]);
    assert_eq!(epochs(1.0), [0, 1, 0, 0], "the same pose");
    assert_eq!(epochs(0.0), [0, 2, 0, 0], "back, which is another move");
}

/// A property that is one thing before a time, and another from then on.
fn step<T: umbrage_scene::Between>(seconds: f32, values: [T; 2]) -> Curve<T> {
    Curve::new(vec![0.0, seconds], Keys::Step(values.into())).expect("a curve")
}

#[test]
fn what_is_bent_morphed_or_hidden_otherwise_has_moved_and_time_alone_moves_nothing() {
    let mut scene = scene();
    let rest = Place::Parts { translation: DVec3::ZERO, rotation: Quat::IDENTITY, scale: Vec3::ONE };
    let node = Node { name: String::new(), parent: None, rest, visible: true, weights: vec![0.0] };
    scene.rig.nodes = vec![node; 4];
    scene.rig.skins = vec![Skin { joints: vec![(0, Mat4::IDENTITY), (1, Mat4::IDENTITY)] }];
    // The second joint moves after 1 s, the weight of the third node after 2 s, and the fourth hides after 3 s.
    let channels = vec![
        Channel { node: 1, track: Track::Translation(step(1.0, [Vec3::ZERO, Vec3::Y])) },
        Channel { node: 2, track: Track::Weights(step(2.0, [vec![0.0], vec![1.0]])) },
        Channel { node: 3, track: Track::Visible(step(3.0, [true, false])) },
    ];
    scene.rig.animations = vec![Animation { name: String::new(), seconds: 9.0, channels }];
    scene.rig.playing = Some(0);
    let vertices = scene.meshes[1].positions.len();
    scene.meshes[1].influences.per_vertex = 1;
    scene.meshes[1].influences.joints = vec![1; vertices];
    scene.meshes[1].influences.weights = vec![1.0; vertices];
    let up = MorphTarget { positions: vec![Vec3::Y; vertices], normals: vec![Vec3::ZERO; vertices] };
    scene.meshes[1].targets = vec![up];
    let still = Instance::still(1, Mat4::IDENTITY);
    scene.instances = vec![
        Instance { motion: Motion::Skin { node: 0 }, skin: Some(0), ..still.clone() },
        Instance { node: Some(2), ..still.clone() },
        Instance { node: Some(3), ..still.clone() },
        still,
    ];
    let mut table = PartTable::new(&scene);
    let mut at = |seconds| {
        table.move_to(&scene.instances, &scene.pose(seconds));
        let tops: Vec<f32> = (0..4).map(|i| top(&table, i)).collect();
        ([0, 1, 2, 3].map(|i| table.epoch(i)), tops)
    };
    let hidden = f32::NEG_INFINITY;
    assert_eq!(at(0.5), ([0, 0, 0, 0], vec![0.0, 0.0, 0.0, 0.0]));
    assert_eq!(at(1.5), ([2, 0, 0, 0], vec![1.0, 0.0, 0.0, 0.0]));
    assert_eq!(at(2.5), ([2, 3, 0, 0], vec![1.0, 1.0, 0.0, 0.0]));
    assert_eq!(at(3.5), ([2, 3, 4, 0], vec![1.0, 1.0, hidden, 0.0]));
    assert_eq!(at(3.6), ([2, 3, 4, 0], vec![1.0, 1.0, hidden, 0.0]));
    assert_eq!(at(0.5), ([6, 6, 6, 0], vec![0.0, 0.0, 0.0, 0.0]));
}

/// How high an instance reaches, rounded to whole metres.
fn top(table: &PartTable, instance: u32) -> f32 {
    let slots = (0..).zip(&table.slots).filter(|(_, slot)| slot.instance == instance);
    slots.map(|(number, _)| table.aabb(number).max.y.round()).fold(f32::NEG_INFINITY, f32::max)
}
