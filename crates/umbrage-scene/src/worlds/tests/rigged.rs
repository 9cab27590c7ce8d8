//! Is the rig of a world whole, and do triangles of cards have an area?

use super::*;
use crate::rig::Track;
use crate::{Motion, Pose};

/// Demands that indices of the rig are in range, that parents come first, and that influences sum to one.
pub(super) fn assert_rig_valid(scene: &Scene) {
    let (name, rig) = (&scene.name, &scene.rig);
    let nodes = rig.nodes.len();
    for (i, node) in rig.nodes.iter().enumerate() {
        assert!(node.parent.is_none_or(|parent| parent < i), "{name}: the parent of {}", node.name);
    }
    for skin in &rig.skins {
        assert!(skin.joints.iter().all(|(node, bind)| *node < nodes && bind.is_finite()), "{name}: a skin");
    }
    for animation in &rig.animations {
        assert!(animation.channels.iter().all(|channel| channel.node < nodes), "{name}: a channel");
        let ends = animation.channels.iter().map(|channel| match &channel.track {
            Track::Translation(curve) | Track::Scale(curve) => curve.times().last().copied(),
            Track::Rotation(curve) => curve.times().last().copied(),
            Track::Weights(curve) => curve.times().last().copied(),
            Track::Visible(curve) => curve.times().last().copied(),
        });
        assert!(ends.flatten().all(|end| end <= animation.seconds), "{name}: what ends after its animation");
    }
    assert!(rig.playing.is_none_or(|playing| playing < rig.animations.len()), "{name}: what plays");
    scene.meshes.iter().for_each(|mesh| assert_bends(name, mesh));
    let start = scene.pose(0.0);
    for instance in &scene.instances {
        assert!(instance.node.is_none_or(|node| node < nodes), "{name}: a node of an instance");
        let joints = instance.skin.map_or(usize::MAX, |skin| rig.skins[skin].joints.len());
        let influences = &scene.meshes[instance.mesh].influences;
        assert!(influences.joints.iter().all(|joint| usize::from(*joint) < joints), "{name}: a joint");
        let at = instance.world_from_mesh_in(&start);
        assert!(at.abs_diff_eq(instance.world_from_mesh, 1e-6), "{name}: an instance starts elsewhere");
    }
}

/// Demands that influences and targets are as many as vertices.
fn assert_bends(world: &str, mesh: &crate::Mesh) {
    let (name, count) = (&mesh.name, mesh.positions.len());
    assert!(mesh.colours.is_empty() || mesh.colours.len() == count, "{world}: colours of {name}");
    for target in &mesh.targets {
        let [places, normals] = [&target.positions, &target.normals].map(Vec::len);
        assert_eq!([places, normals], [count; 2], "{world}: a target of {name}");
    }
    if !mesh.influences.is_empty() {
        assert_eq!(mesh.influences.weights.len(), count * mesh.influences.per_vertex, "{world}: {name}");
        for vertex in 0..count {
            let sum: f32 = mesh.influences.of(vertex).map(|(_, weight)| weight).sum();
            assert!((sum - 1.0).abs() < 1e-5, "{world}: influences of {name} sum to {sum}");
        }
    }
}

/// The worlds that a rig moves.
fn rigged() -> impl Iterator<Item = Scene> {
    ALL.iter().map(|world| world.build(0)).filter(|scene| !scene.rig.animations.is_empty())
}

#[test]
fn worlds_that_a_rig_moves_have_no_triangle_without_an_area() {
    for scene in rigged() {
        for mesh in &scene.meshes {
            for t in mesh.indices.as_chunks().0 {
                let [a, b, c] = (*t as [u32; 3]).map(|i| mesh.positions[i as usize]);
                let longest = (b - a).length().max((c - b).length()).max((a - c).length());
                let area = (b - a).cross(c - a).length();
                assert!(area > 1e-6 * longest * longest, "{}, {}: a triangle at {a}", scene.name, mesh.name);
            }
        }
    }
}

#[test]
fn animations_begin_again_where_they_end() {
    for scene in rigged() {
        let seconds = scene.rig.animations[0].seconds;
        let [start, end] = [0.0, seconds * (1.0 - 1e-6)].map(|seconds| scene.pose(seconds));
        for instance in
            scene.instances.iter().filter(|instance| !matches!(instance.motion, Motion::Rotation { .. }))
        {
            let [from, to] = [&start, &end].map(|pose: &Pose| instance.world_from_mesh_in(pose));
            assert!(from.abs_diff_eq(to, 0.01), "{}: {from} and {to}", scene.name);
        }
        for (node, rest) in scene.rig.nodes.iter().enumerate() {
            let pairs = start.weights(node).iter().zip(end.weights(node));
            assert!(pairs.clone().all(|(a, b)| (a - b).abs() < 0.01), "{}: {rest:?}", scene.name);
        }
    }
}
