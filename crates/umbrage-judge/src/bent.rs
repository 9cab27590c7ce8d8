//! The vertices of what joints and morph targets bend, in world space and f64.
//!
//! Morph targets move a vertex by their displacements times their weights; then it goes to the mean, by the vertex's weights, of
//! where each of its joints would take it. Source: glTF 2.0, sections 3.7.2.2 and 3.7.3.3.
//!
//! Whoever draws this may do so in f32. That rounds the joints' matrices relative to where the skeleton stands, and sums of
//! their products with the vertex: each term of the sum by some units in its last place, and so a vertex by no more than that
//! share of the sum of all terms' sizes. Nothing of it grows with the skeleton's distance from the world's origin.

use glam::{DMat4, DVec3};
use umbrage_scene::{Instance, Mesh, Pose, Scene};

use crate::triangles::HALF_ULP;

/// The number of roundings that the terms of a vertex are off by: of the file's coordinate, of a matrix, of the blended matrix, and of
/// their product and its sum.
const ROUNDINGS: f64 = 6.0;

/// A vertex in world space, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Vertex {
    pub position: DVec3,
    /// Rounding may have moved it so far along each axis.
    pub moved: DVec3,
}

/// The vertices of an instance in a pose; `None` where nothing bends it.
pub(crate) fn vertices(scene: &Scene, instance: &Instance, pose: &Pose) -> Option<Vec<Vertex>> {
    let mesh = &scene.meshes[instance.mesh];
    let skin = instance.skin.filter(|_| !mesh.influences.is_empty());
    let weights = instance.node.map_or(&[][..], |node| pose.weights(node));
    if skin.is_none() && (mesh.targets.is_empty() || instance.node.is_none()) {
        return None;
    }
    let place = instance.world_from_mesh_in(pose).as_dmat4();
    let (origin, joints) = match skin.and_then(|skin| scene.rig.skins.get(skin)) {
        // Relative to where the instance stands, so that what is rounded is small.
        Some(skin) => {
            let origin = place.w_axis.truncate();
            let from_world = DMat4::from_translation(-origin);
            let joint = |(node, bind): &(usize, glam::Mat4)| {
                from_world * pose.world_from_node(*node) * bind.as_dmat4()
            };
            (origin, Some(skin.joints.iter().map(joint).collect::<Vec<DMat4>>()))
        }
        None => (DVec3::ZERO, None),
    };
    let bend = |i| {
        let (at, size) = morphed(mesh, weights, i);
        let matrix = match &joints {
            Some(joints) => blended(mesh, joints, i),
            None => place,
        };
        let position = origin + matrix.transform_point3(at);
        // Instances without joints keep their translation: it is not added to anything before it is to the origin's.
        let shift = if joints.is_some() { matrix.w_axis.truncate().abs() } else { DVec3::ZERO };
        let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(|axis| axis.truncate().abs());
        let terms = x * size.x + y * size.y + z * size.z + shift;
        Vertex { position, moved: terms * (ROUNDINGS * HALF_ULP) }
    };
    Some((0..mesh.positions.len()).map(bend).collect())
}

/// A vertex in mesh space as morph targets move it, and the sum of the sizes of all that it is a sum of.
fn morphed(mesh: &Mesh, weights: &[f32], vertex: usize) -> (DVec3, DVec3) {
    let rest = mesh.positions[vertex].as_dvec3();
    let moves = mesh.targets.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
    moves.fold((rest, rest.abs()), |(at, size), (target, weight)| {
        let moved = target.positions[vertex].as_dvec3() * f64::from(*weight);
        (at + moved, size + moved.abs())
    })
}

/// The mean of the joints of a vertex, by its weights.
fn blended(mesh: &Mesh, joints: &[DMat4], vertex: usize) -> DMat4 {
    let counting = mesh.influences.of(vertex).filter(|(_, weight)| *weight > 0.0);
    counting.fold(DMat4::ZERO, |sum, (joint, weight)| {
        sum + joints.get(joint).copied().unwrap_or(DMat4::ZERO) * f64::from(weight)
    })
}

#[cfg(test)]
mod tests {
    use glam::{Mat4, Quat, Vec2, Vec3};
    use umbrage_scene::rig::{Node, Place, Skin};
    use umbrage_scene::{Influences, MorphTarget, Motion, Primitive};

    use super::*;
    use crate::triangles::Triangles;

    /// A triangle whose corners follow the first joint, the second and both alike; the first target lifts all by 1 m.
    fn scene(place: DVec3, weights: Vec<f32>) -> Scene {
        let count = 3;
        let influences = Influences {
            per_vertex: 2,
            joints: [0, 1].repeat(count),
            weights: vec![1.0, 0.0, 0.0, 1.0, 0.5, 0.5],
        };
        let lift = MorphTarget { positions: vec![Vec3::Y; count], normals: vec![Vec3::ZERO; count] };
        let primitive = Primitive {
            positions: vec![Vec3::ZERO, Vec3::X * 2.0, Vec3::Z],
            normals: vec![Vec3::Y; count],
            uvs: vec![Vec2::ZERO; count],
            indices: vec![0, 1, 2],
            influences,
            targets: vec![lift],
            ..Primitive::default()
        };
        let mut scene = Scene { meshes: vec![Mesh::new("m", &[primitive])], ..Scene::default() };
        let node = |parent, translation, rotation| {
            let rest = Place::Parts { translation, rotation, scale: Vec3::ONE };
            Node { name: String::new(), parent, rest, visible: true, weights: weights.clone() }
        };
        // The second joint, at x = 1, turns x into z.
        let turn = Quat::from_rotation_y(-std::f32::consts::FRAC_PI_2);
        scene.rig.nodes = vec![node(None, place, Quat::IDENTITY), node(Some(0), DVec3::X, turn)];
        let bind = Mat4::from_translation(Vec3::NEG_X);
        scene.rig.skins = vec![Skin { joints: vec![(0, Mat4::IDENTITY), (1, bind)] }];
        let motion = Motion::Skin { node: 0 };
        let instance =
            Instance { motion, node: Some(0), skin: Some(0), ..Instance::still(0, Mat4::IDENTITY) };
        scene.instances.push(instance);
        scene
    }

    #[test]
    fn corners_follow_their_joints_after_they_are_morphed() {
        for (weight, y) in [(0.0, 0.0), (0.5, 0.5), (-2.0, -2.0)] {
            let scene = scene(DVec3::new(0.0, 3.0, 0.0), vec![weight]);
            let all = Triangles::of(&scene, &scene.pose(0.0));
            // The first stays; the second, 1 m from its joint, is 1 m along z there; the third, from (0, 0, 1), is the mean
            // of itself and of (0, 0, -1), which is 1 m back from the joint and 1 m to its side.
            let wanted =
                [DVec3::ZERO, DVec3::new(1.0, 0.0, 1.0), DVec3::ZERO].map(|at| at + DVec3::Y * (3.0 + y));
            for (found, wanted) in all.corners[0].iter().zip(wanted) {
                assert!(found.distance(wanted) < 1e-6, "weight {weight}: {found}, not {wanted}");
            }
            assert!(!all.still[0]);
        }
    }

    #[test]
    fn what_stands_far_away_is_rounded_no_more_than_what_stands_here() {
        let at = |place| {
            let scene = scene(place, vec![0.25]);
            Triangles::of(&scene, &scene.pose(0.0))
        };
        let (near, far) = (at(DVec3::ZERO), at(DVec3::splat(1e5)));
        assert_eq!(near.rounding, far.rounding);
        assert!(near.rounding[0] > 0.0 && near.rounding[0] < 1e-5, "{:?}", near.rounding);
        for (near, far) in near.corners[0].iter().zip(far.corners[0]) {
            assert!((far - DVec3::splat(1e5)).distance(*near) < 1e-9, "{far}");
        }
    }

    #[test]
    fn what_nothing_bends_has_no_vertices_of_its_own() {
        let mut scene = scene(DVec3::ZERO, vec![1.0]);
        assert!(vertices(&scene, &scene.instances[0], &scene.pose(0.0)).is_some());
        scene.meshes[0].targets.clear();
        scene.meshes[0].influences = Influences::default();
        assert!(vertices(&scene, &scene.instances[0], &scene.pose(0.0)).is_none());
    }
}
