//! A scene while it is being read: its parts with their transforms in f64, before they are settled around an origin.

use std::rc::Rc;

use glam::{DMat4, DVec3};

use super::extent::Extent;
use super::recentre::Rebased;
use crate::{Camera, CameraPath, Light, Mesh, Motion, Pose, Rig};

/// Everything that a file places.
#[derive(Debug, Default)]
pub(super) struct Draft {
    /// The instances, each of a mesh of the scene, before that was rebased.
    pub instances: Vec<Placed>,
    /// The cameras and the lights, each at its own origin, and where they stand.
    pub cameras: Vec<(Camera, DMat4)>,
    pub lights: Vec<(Light, DMat4)>,
    pub path: CameraPath,
    pub exposed_for: Option<f32>,
    /// Where in the file the draft's own origin is; everything else is measured from there.
    pub origin: DVec3,
    /// What moves the instances and lights, and how it stands at 0 s.
    pub rig: Rig,
    pub pose: Pose,
}

/// A mesh placed in the world.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    /// The mesh in [`crate::Scene::meshes`].
    pub what: usize,
    /// Where it stands at 0 s, unless it has a skin.
    pub world_from_it: DMat4,
    /// How it moves, unless it hangs on a node of the rig.
    pub motion: Motion,
    pub hang: Option<Hang>,
    /// The skin of the rig that bends it.
    pub skin: Option<usize>,
    /// The name in the file; empty where it has none.
    pub name: Rc<str>,
    /// Whether it casts shadows, if the file says so.
    pub casts: Option<bool>,
    /// What a warning calls it.
    pub label: Rc<str>,
}

/// A place in a node of the rig.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hang {
    pub node: usize,
    pub node_from_it: DMat4,
    /// Whether an animation moves the node, or one that it hangs on.
    pub moves: bool,
}

impl Hang {
    /// Where it stands in the world.
    pub fn in_pose(&self, pose: &Pose) -> DMat4 {
        pose.world_from_node(self.node) * self.node_from_it
    }

    pub fn motion(&self) -> Motion {
        Motion::Node { node: self.node, node_from_thing: self.node_from_it.as_mat4() }
    }
}

impl Placed {
    /// `world_from_mesh` of the mesh as it is after it was rebased; of a mesh with a skin, that of its first joint, unturned.
    pub fn world_from_mesh(&self, rebased: &Rebased, draft: &Draft) -> DMat4 {
        match self.first_joint(&draft.rig) {
            Some(joint) => DMat4::from_translation(draft.pose.place(joint)),
            None => then_rebased(self.world_from_it, rebased),
        }
    }

    /// How the mesh moves after it was rebased.
    pub fn moves(&self, rebased: &Rebased, rig: &Rig) -> Motion {
        match (self.first_joint(rig), self.hang) {
            (Some(node), _) => Motion::Skin { node },
            (None, Some(hang)) => {
                let node_from_it = then_rebased(hang.node_from_it, rebased);
                Hang { node_from_it, ..hang }.motion()
            }
            (None, None) => self.motion,
        }
    }

    fn first_joint(&self, rig: &Rig) -> Option<usize> {
        let skin = rig.skins.get(self.skin?)?;
        skin.joints.first().map(|(node, _)| *node)
    }

    /// How far morph targets, which move a vertex so far at most, move one at 0 s.
    pub fn displacement(&self, targets: &[f64], draft: &Draft) -> f64 {
        let weights = self.hang.map_or(&[][..], |hang| draft.pose.weights(hang.node));
        targets.iter().zip(weights).map(|(by, weight)| by * f64::from(weight.abs())).sum()
    }

    /// The box around the mesh, or a part of it, at 0 s, measured from the draft's origin; a little too large where a skin
    /// bends it.
    pub fn extent(&self, part: Extent, rebased: &Rebased, draft: &Draft) -> Extent {
        let world_from_mesh = self.world_from_mesh(rebased, draft);
        match self.skin {
            Some(skin) => draft
                .pose
                .exact_joints(&draft.rig, skin)
                .map(|joint| part.transformed(&(world_from_mesh * joint)))
                .fold(Extent::EMPTY, Extent::union),
            None => part.transformed(&world_from_mesh),
        }
    }
}

fn then_rebased(matrix: DMat4, rebased: &Rebased) -> DMat4 {
    if rebased.offset == DVec3::ZERO { matrix } else { matrix * DMat4::from_translation(rebased.offset) }
}

impl Draft {
    /// A box for each part of each instance, at time 0, measured from the draft's origin.
    pub fn boxes(&self, meshes: &[Mesh], rebased: &[Rebased]) -> Vec<Extent> {
        let of = |placed: &Placed| {
            let mesh = &meshes[placed.what];
            let bounds = match placed.skin {
                // Joints bend all of it.
                Some(_) => vec![mesh.bounds],
                None => mesh.parts.iter().map(|part| part.bounds).collect(),
            };
            let extent = |bounds| placed.extent(Extent::of(bounds), &rebased[placed.what], self);
            bounds.into_iter().map(extent).collect::<Vec<_>>()
        };
        self.instances.iter().flat_map(of).filter(Extent::is_finite).collect()
    }
}
