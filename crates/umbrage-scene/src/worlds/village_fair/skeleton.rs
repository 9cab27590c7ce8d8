//! The bones of a figure that stands on the origin, looks to +Z and is 1.75 m tall; its left is at +X. Arms hang a little
//! away from the body, as people model figures.

use glam::{Mat4, Quat, Vec3};

use crate::rig::Skin;
use crate::worlds::stage::Stage;

/// A joint, whose number is its place in [`JOINTS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Joint {
    Hips,
    Spine,
    Chest,
    Neck,
    Head,
    ArmLeft,
    ForearmLeft,
    HandLeft,
    ArmRight,
    ForearmRight,
    HandRight,
    ThighLeft,
    ShinLeft,
    FootLeft,
    ThighRight,
    ShinRight,
    FootRight,
}

/// Every joint in order, with the one that it moves with, and where it is, metres.
const JOINTS: [(Joint, Joint, [f32; 3]); 17] = [
    (Joint::Hips, Joint::Hips, [0.0, 0.95, 0.0]),
    (Joint::Spine, Joint::Hips, [0.0, 1.07, -0.01]),
    (Joint::Chest, Joint::Spine, [0.0, 1.25, -0.02]),
    (Joint::Neck, Joint::Chest, [0.0, 1.47, -0.02]),
    (Joint::Head, Joint::Neck, [0.0, 1.56, 0.0]),
    (Joint::ArmLeft, Joint::Chest, [0.185, 1.41, -0.02]),
    (Joint::ForearmLeft, Joint::ArmLeft, [0.27, 1.15, -0.02]),
    (Joint::HandLeft, Joint::ForearmLeft, [0.33, 0.92, 0.0]),
    (Joint::ArmRight, Joint::Chest, [-0.185, 1.41, -0.02]),
    (Joint::ForearmRight, Joint::ArmRight, [-0.27, 1.15, -0.02]),
    (Joint::HandRight, Joint::ForearmRight, [-0.33, 0.92, 0.0]),
    (Joint::ThighLeft, Joint::Hips, [0.095, 0.92, 0.0]),
    (Joint::ShinLeft, Joint::ThighLeft, [0.10, 0.50, 0.01]),
    (Joint::FootLeft, Joint::ShinLeft, [0.105, 0.09, -0.02]),
    (Joint::ThighRight, Joint::Hips, [-0.095, 0.92, 0.0]),
    (Joint::ShinRight, Joint::ThighRight, [-0.10, 0.50, 0.01]),
    (Joint::FootRight, Joint::ShinRight, [-0.105, 0.09, -0.02]),
];

impl Joint {
    /// Where the joint is while the figure stands as it was modelled.
    pub fn at(self) -> Vec3 {
        JOINTS[self as usize].2.into()
    }
}

/// A figure's nodes: where it stands, and the first of its bones, which follow each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bones {
    pub root: usize,
    pub hips: usize,
    pub skin: usize,
}

impl Bones {
    /// Adds the nodes and the skin of a figure that stands at `feet`, `size` times as large and turned by `yaw`.
    pub fn add(stage: &mut Stage, feet: Vec3, yaw: f32, size: Vec3) -> Self {
        let root = stage.node("figure", None, feet, Quat::from_rotation_y(yaw), size);
        let hips = root + 1;
        for (joint, parent, _) in JOINTS {
            let is_first = joint == parent;
            let (parent_node, from) =
                if is_first { (root, Vec3::ZERO) } else { (hips + parent as usize, parent.at()) };
            let name = format!("{joint:?}").to_lowercase();
            stage.node(&name, Some(parent_node), joint.at() - from, Quat::IDENTITY, Vec3::ONE);
        }
        let bind = |(joint, ..): (Joint, Joint, [f32; 3])| {
            (hips + joint as usize, Mat4::from_translation(-joint.at()))
        };
        stage.scene.rig.skins.push(Skin { joints: JOINTS.map(bind).to_vec() });
        Self { root, hips, skin: stage.scene.rig.skins.len() - 1 }
    }

    /// The node of a joint.
    pub fn node(&self, joint: Joint) -> usize {
        self.hips + joint as usize
    }
}

#[test]
fn a_joints_number_is_its_place_in_the_list_and_parents_come_first() {
    for (i, (joint, parent, _)) in JOINTS.into_iter().enumerate() {
        assert!(joint as usize == i && (i == 0 || (parent as usize) < i), "{joint:?}");
    }
}
