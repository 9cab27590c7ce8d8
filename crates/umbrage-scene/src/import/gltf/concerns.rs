//! What a file says of its nodes that concerns the rig: which an animation moves, which are joints, and which morph.

use std::collections::BTreeMap;

use glam::Mat4;

use super::contents::Contents;
use super::nodes::Walked;
use super::rigging::Concern;
use super::skins::Skin;
use crate::import::settle::FARTHEST;
use crate::import::warnings::Warnings;
use crate::rig;

/// The skins that bend something.
#[derive(Debug)]
pub(super) struct UsedSkins<'a> {
    /// The skins of the file, in the order of their first use.
    skins: Vec<&'a Skin>,
    /// Which of them bends the mesh of a node.
    by_node: BTreeMap<usize, usize>,
}

impl<'a> UsedSkins<'a> {
    /// The skins of all nodes in the scene that are ever seen. A skin without a joint there bends nothing.
    pub fn of(contents: &Contents<'a>, walk: &[Walked], ever: &[bool], warnings: &mut Warnings) -> Self {
        let mut is_placed = vec![false; contents.document.root.nodes.len()];
        walk.iter().for_each(|walked| is_placed[walked.node] = true);
        let mut used = Self { skins: Vec::new(), by_node: BTreeMap::new() };
        let mut known: BTreeMap<usize, usize> = BTreeMap::new();
        for (Walked { node, .. }, _) in walk.iter().zip(ever).filter(|(_, ever)| **ever) {
            let json = &contents.document.root.nodes[*node];
            let (Some(mesh), Some(index)) = (contents.mesh(json), json.skin) else {
                continue;
            };
            let mut ignored = |why: &str| {
                let label = json.name.clone().unwrap_or_else(|| format!("node {node}"));
                let what = "skins that cannot bend their mesh are ignored, it stands as it was modelled";
                warnings.note(what, &format!("{label}, {why}"));
            };
            let index = index.value();
            let skin = match contents.skins.get(index) {
                Some(Ok(skin)) => skin,
                Some(Err(why)) => {
                    ignored(why);
                    continue;
                }
                None => {
                    ignored(&format!("skin {index} of {} is not there", contents.skins.len()));
                    continue;
                }
            };
            if contents.meshes[mesh].influences.is_empty() {
                ignored("its mesh has no joints and weights");
                continue;
            }
            if !skin.joints.iter().flatten().any(|(joint, _)| is_placed[*joint]) {
                ignored(&format!("no joint of skin {index} is in the scene"));
                continue;
            }
            let place = *known.entry(index).or_insert_with(|| {
                used.skins.push(skin);
                used.skins.len() - 1
            });
            used.by_node.insert(*node, place);
        }
        used
    }

    /// The skin that bends the mesh of a node, by its number in the rig.
    pub fn of_node(&self, node: usize) -> Option<usize> {
        self.by_node.get(&node).copied()
    }

    /// The skins of the rig, whose nodes are those of the file at these places. Vertices of a joint that is missing follow the
    /// first that is there.
    pub fn in_rig(&self, in_rig: &[Option<usize>]) -> Vec<rig::Skin> {
        let joint = |joint: &Option<(usize, Mat4)>| {
            let (node, matrix) = (*joint)?;
            Some((in_rig[node]?, matrix))
        };
        let of = |skin: &&Skin| {
            let joints: Vec<Option<(usize, Mat4)>> = skin.joints.iter().map(joint).collect();
            let first = joints.iter().flatten().next().copied();
            rig::Skin { joints: joints.into_iter().filter_map(|joint| joint.or(first)).collect() }
        };
        self.skins.iter().map(of).collect()
    }
}

/// What concerns the rig of each node of the file; of nodes in the walk, those that are ever seen may be morphed.
pub(super) fn of(
    contents: &Contents<'_>,
    used: &UsedSkins<'_>,
    walk: &[Walked],
    ever: &[bool],
) -> Vec<Concern> {
    let nodes = &contents.document.root.nodes;
    let mut concerns = vec![Concern::default(); nodes.len()];
    for channel in contents.animations.iter().flat_map(|animation| &animation.channels) {
        let concern = &mut concerns[channel.node];
        concern.is_needed = true;
        concern.moves |= channel.track.is_of_place();
    }
    for (joint, _) in used.skins.iter().flat_map(|skin| skin.joints.iter().flatten()) {
        concerns[*joint].is_needed = true;
    }
    for (walked, _) in walk.iter().zip(ever).filter(|(_, ever)| **ever) {
        let (node, concern) = (&nodes[walked.node], &mut concerns[walked.node]);
        let targets = contents.mesh(node).map_or(0, |mesh| contents.meshes[mesh].targets.len());
        if targets > 0 {
            concern.weights = weights(contents, node, targets);
            concern.is_needed |= concern.weights.iter().any(|weight| *weight != 0.0);
        }
    }
    concerns
}

/// The weights of a node's morph targets at rest: its own, or else its mesh's.
fn weights(contents: &Contents<'_>, node: &gltf::json::Node, targets: usize) -> Vec<f32> {
    let of_mesh = || {
        let mesh = contents.document.root.meshes.get(node.mesh?.value())?;
        mesh.weights.as_deref()
    };
    let said = node.weights.as_deref().or_else(of_mesh).unwrap_or_default();
    let usable = |weight: &f32| if weight.abs() <= FARTHEST as f32 { *weight } else { 0.0 };
    let mut weights: Vec<f32> = said.iter().map(usable).collect();
    weights.resize(targets, 0.0);
    weights
}
