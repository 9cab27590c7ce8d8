//! The joints and the morph weights of a pose, in the order in which a scene's shapes know them.

use glam::Mat4;
use umbrage_scene::Pose;

use crate::shapes::{Entries, Shapes};

/// What bends all shapes of a scene in one pose.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Palette {
    /// The matrices from mesh space to the space of the instance.
    pub joints: Vec<Mat4>,
    pub weights: Vec<f32>,
}

impl Palette {
    /// Takes on a pose. What it held makes room.
    pub fn take(&mut self, shapes: &Shapes, pose: &Pose) {
        let Self { joints, weights } = self;
        joints.clear();
        for skin in &shapes.skins {
            joints.extend(pose.joints(&shapes.rig, *skin));
        }
        weights.clear();
        for (node, count) in &shapes.nodes {
            let end = weights.len() + count;
            weights.extend(pose.weights(*node).iter().take(*count));
            weights.resize(end, 0.0);
        }
    }

    pub fn joints(&self, entries: Option<Entries>) -> &[Mat4] {
        entries.and_then(|Entries { first, count }| self.joints.get(first..first + count)).unwrap_or(&[])
    }

    pub fn weights(&self, entries: Option<Entries>) -> &[f32] {
        entries.and_then(|Entries { first, count }| self.weights.get(first..first + count)).unwrap_or(&[])
    }
}
