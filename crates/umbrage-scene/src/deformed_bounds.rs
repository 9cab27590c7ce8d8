//! Boxes around the parts of a mesh however joints and morph targets bend it, without touching a vertex for a pose.
//!
//! The weights of a vertex are 0 or more and sum to 1, so it lies among the places to which each of its joints alone would
//! take it: a part lies in the union, over joints, of the box of those vertices that the joint bends, moved by the joint.
//! Morph targets move vertices before that, each by no more than its extents times its weight.

use glam::{Mat4, Vec3};

use crate::{Aabb, Instance, Mesh, Pose, Scene};

/// The boxes of a mesh's parts as functions of joints and weights. They are made once of all vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct DeformedBounds {
    parts: Vec<Reach>,
}

/// The reach of a part.
#[derive(Clone, Debug, PartialEq)]
struct Reach {
    /// The box around all of the part, at rest.
    rest: Aabb,
    /// The box around those of its vertices that each joint bends, at rest; joints that bend none are left out.
    joints: Vec<(u16, Aabb)>,
    /// The extents of the displacements of each morph target; targets that move nothing are left out.
    targets: Vec<(usize, Aabb)>,
}

/// What f32 may lose of a vertex that is bent, as a share of all terms that it is a sum of: 16 roundings.
const ROUNDING: f32 = 16.0 / 16_777_216.0;

impl DeformedBounds {
    /// Makes the boxes of a mesh.
    pub fn of(mesh: &Mesh) -> Self {
        let joints = mesh.influences.joints.iter().max().map_or(0, |last| usize::from(*last) + 1);
        let mut room = vec![Aabb::EMPTY; joints];
        let parts = mesh.parts.iter().map(|part| {
            let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
            Reach {
                rest: part.bounds,
                joints: boxes_by_joint(mesh, indices, &mut room),
                targets: extents(mesh, indices),
            }
        });
        Self { parts: parts.collect() }
    }

    /// Returns the box around a part, in the space that `joints` lead to; in mesh space where there are none. `weights` are
    /// those of the morph targets, 0 for those that have none. The box is rounded outward, and empty where a joint or weight is not finite.
    pub fn in_pose(&self, part: usize, joints: &[Mat4], weights: &[f32]) -> Aabb {
        let Some(reach) = self.parts.get(part) else { return Aabb::EMPTY };
        let (moved, terms) = reach.morphed(weights);
        let widened = |aabb: Aabb| Aabb { min: aabb.min + moved.min, max: aabb.max + moved.max };
        let size = |aabb: Aabb| aabb.min.abs().max(aabb.max.abs()) + terms;
        if joints.is_empty() {
            return outward(widened(reach.rest), size(reach.rest));
        }
        let by_joint = reach.joints.iter().filter_map(|(joint, aabb)| {
            let joint = joints.get(usize::from(*joint))?;
            let [x, y, z, w] =
                [joint.x_axis, joint.y_axis, joint.z_axis, joint.w_axis].map(|v| v.truncate().abs());
            let largest = size(*aabb);
            let terms = x * largest.x + y * largest.y + z * largest.z + w;
            Some(outward(widened(*aabb).transformed(joint), terms))
        });
        by_joint.fold(Aabb::EMPTY, Aabb::union)
    }

    /// Returns the box around all parts, as [`Self::in_pose`] does for one.
    pub fn whole(&self, joints: &[Mat4], weights: &[f32]) -> Aabb {
        (0..self.parts.len()).fold(Aabb::EMPTY, |sum, part| sum.union(self.in_pose(part, joints, weights)))
    }
}

impl Reach {
    /// The extents of what morph targets add with these weights, and the sum of their sizes.
    fn morphed(&self, weights: &[f32]) -> (Aabb, Vec3) {
        let none = (Aabb { min: Vec3::ZERO, max: Vec3::ZERO }, Vec3::ZERO);
        self.targets.iter().fold(none, |(sum, terms), (target, extents)| {
            let weight = weights.get(*target).copied().unwrap_or(0.0);
            let (a, b) = (extents.min * weight, extents.max * weight);
            let sum = Aabb { min: sum.min + a.min(b), max: sum.max + a.max(b) };
            (sum, terms + a.abs().max(b.abs()))
        })
    }
}

/// The box of the vertices that each joint bends. `room` has an empty box for each joint, and again afterwards.
fn boxes_by_joint(mesh: &Mesh, indices: &[u32], room: &mut [Aabb]) -> Vec<(u16, Aabb)> {
    let mut found = Vec::new();
    for &vertex in indices {
        let vertex = vertex as usize;
        for (joint, _) in mesh.influences.of(vertex).filter(|(_, weight)| *weight > 0.0) {
            if room[joint].is_empty() {
                found.push(joint as u16);
            }
            room[joint] = room[joint].union(Aabb::of_points([mesh.positions[vertex]]));
        }
    }
    found.sort_unstable();
    found
        .into_iter()
        .map(|joint| (joint, std::mem::replace(&mut room[usize::from(joint)], Aabb::EMPTY)))
        .collect()
}

/// The extents of the displacements of each target that moves one of the vertices.
fn extents(mesh: &Mesh, indices: &[u32]) -> Vec<(usize, Aabb)> {
    let of = |positions: &[Vec3]| Aabb::of_points(indices.iter().map(|i| positions[*i as usize]));
    let all = mesh.targets.iter().map(|target| of(&target.positions)).enumerate();
    all.filter(|(_, extents)| extents.min != Vec3::ZERO || extents.max != Vec3::ZERO).collect()
}

/// A box that holds what was rounded when terms of these sizes were added; empty where one is not finite.
fn outward(aabb: Aabb, terms: Vec3) -> Aabb {
    let margin = terms * ROUNDING;
    let (min, max) = (aabb.min - margin, aabb.max + margin);
    if min.is_finite() && max.is_finite() { Aabb { min, max } } else { Aabb::EMPTY }
}

impl Instance {
    /// Whether the rig bends the instance: it has a skin and a mesh that follows one, or a node and a mesh with morph
    /// targets.
    pub fn is_deformed(&self, mesh: &Mesh) -> bool {
        self.skin.is_some() && !mesh.influences.is_empty() || self.node.is_some() && !mesh.targets.is_empty()
    }
}

impl Scene {
    /// Returns the box around everything that is seen in a pose, in world space.
    pub fn bounds_in(&self, pose: &Pose) -> Aabb {
        self.boxes_in(pose).map(|(_, aabb)| aabb).fold(Aabb::EMPTY, Aabb::union)
    }

    /// Returns the box around each instance that is seen in a pose, in world space, and the instance.
    pub(crate) fn boxes_in<'a>(&'a self, pose: &'a Pose) -> impl Iterator<Item = (&'a Instance, Aabb)> + 'a {
        let mut deformed: Vec<Option<DeformedBounds>> = vec![None; self.meshes.len()];
        self.instances.iter().filter(|instance| instance.is_visible_in(pose)).map(move |instance| {
            let mesh = &self.meshes[instance.mesh];
            let local = if instance.is_deformed(mesh) {
                let bounds = deformed[instance.mesh].get_or_insert_with(|| DeformedBounds::of(mesh));
                let skin = instance.skin.filter(|_| !mesh.influences.is_empty());
                let joints: Vec<Mat4> =
                    skin.map_or_else(Vec::new, |skin| pose.joints(&self.rig, skin).collect());
                bounds.whole(&joints, instance.node.map_or(&[], |node| pose.weights(node)))
            } else {
                mesh.bounds
            };
            (instance, local.transformed(&instance.world_from_mesh_in(pose)))
        })
    }
}
