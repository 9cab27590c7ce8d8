//! Which meshes of a file are bent by a skin or morphed at all; of the others, joints and morph targets are not even read.

use super::animations::targets_of;
use super::document::Document;
use super::skins::Skin;
use crate::rig::{Animation, Track};

/// What bends a mesh of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Bent {
    /// The number of joints of the skin with the fewest that bends the mesh; `None` where none does.
    pub joints: Option<usize>,
    /// The number of morph targets that some node gives a weight; 0 where none does.
    pub targets: usize,
}

/// What bends each mesh.
pub(super) fn of(document: &Document, skins: &[Result<Skin, String>], animations: &[Animation]) -> Vec<Bent> {
    let root = &document.root;
    let mut bent = vec![Bent::default(); root.meshes.len()];
    let mut is_morphed = vec![false; root.nodes.len()];
    for channel in animations.iter().flat_map(|animation| &animation.channels) {
        is_morphed[channel.node] |= matches!(channel.track, Track::Weights(_));
    }
    for (node, is_morphed) in root.nodes.iter().zip(is_morphed) {
        let Some(mesh) = node.mesh.map(|mesh| mesh.value()).filter(|mesh| *mesh < bent.len()) else {
            continue;
        };
        let json = &root.meshes[mesh];
        let weights = node.weights.as_deref().or(json.weights.as_deref()).unwrap_or_default();
        if is_morphed || weights.iter().any(|weight| *weight != 0.0) {
            bent[mesh].targets = targets_of(json);
        }
        if let Some(Ok(skin)) = node.skin.and_then(|skin| skins.get(skin.value())) {
            let fewest = bent[mesh].joints.map_or(usize::MAX, |joints| joints);
            bent[mesh].joints = Some(fewest.min(skin.joints.len()));
        }
    }
    bent
}
