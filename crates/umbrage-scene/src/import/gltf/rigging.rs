//! Which nodes of a file are in the scene's rig, and what hangs on them.
//!
//! A node is in the rig where an animation moves, hides or morphs it, where it is a joint, and where its mesh is morphed; so
//! is what lies between two such nodes. Whatever else hangs below one stands still in it. Above them, where nothing
//! moves, one node with a matrix stands for all, or nothing where that only moves: then the rig's own node is moved. So
//! the outermost nodes of a rig are measured from the scene's origin, in f64.

use glam::{DMat3, DMat4, DVec3};

use super::document::Document;
use super::nodes::{Walked, then};
use super::visibility;
use crate::curve::Curve;
use crate::import::draft::Hang;
use crate::import::settle::FARTHEST;
use crate::import::warnings::Warnings;
use crate::rig::{Animation, Channel, Node, Place, Track};

/// What hangs farther than this from the nearest node of the rig, metres, gets one of its own: places in a node are f32,
/// which has a sixteenth of a millimetre here.
const FAR: f64 = 1000.0;

/// What the file says of a node beside where it stands.
#[derive(Clone, Debug, Default)]
pub(super) struct Concern {
    /// Whether an animation moves it.
    pub moves: bool,
    /// Whether it must be in the rig.
    pub is_needed: bool,
    /// The weights of the morph targets of its mesh; none where that is not morphed at all.
    pub weights: Vec<f32>,
}

/// The nodes of the rig, and how the file's nodes relate to them.
#[derive(Debug, Default)]
pub(super) struct Rigging {
    pub nodes: Vec<Node>,
    /// The node of the rig on which each node of the walk hangs, or which it is.
    pub hangs: Vec<Option<Hang>>,
    /// The node of the rig that each node of the file is.
    pub in_rig: Vec<Option<usize>>,
    /// How far each node of the rig was moved, because nothing stands for what is above it.
    shifts: Vec<DVec3>,
}

impl Rigging {
    /// Chooses the nodes of the rig. `origin` is as for [`super::nodes::walk`].
    pub fn of(
        document: &Document,
        walk: &[Walked],
        concerns: &[Concern],
        origin: DVec3,
        warnings: &mut Warnings,
    ) -> Self {
        let mut leads = vec![false; walk.len()];
        for (i, Walked { node, parent, .. }) in walk.iter().enumerate().rev() {
            leads[i] |= concerns[*node].is_needed;
            if let Some(parent) = *parent {
                leads[parent] |= leads[i];
            }
        }
        let mut builder = Builder {
            document,
            walk,
            concerns,
            leads,
            still: vec![None; walk.len()],
            top_from_file: DMat4::from_translation(-origin),
            rigging: Self { in_rig: vec![None; document.root.nodes.len()], ..Self::default() },
            warnings,
        };
        for i in 0..walk.len() {
            let hang = builder.hang(i);
            builder.rigging.hangs.push(hang);
        }
        builder.rigging
    }

    /// The animations of the file's nodes as animations of the rig's. What moves no node of the scene is left out.
    pub fn animations(&self, animations: Vec<Animation>) -> Vec<Animation> {
        let channel = |Channel { node, track }: Channel| {
            let node = self.in_rig[node]?;
            Some(Channel { node, track: self.shifted(node, track) })
        };
        let of = |Animation { name, seconds, channels }| Animation {
            name,
            seconds,
            channels: channels.into_iter().filter_map(channel).collect(),
        };
        animations.into_iter().map(of).filter(|animation| !animation.channels.is_empty()).collect()
    }

    /// The first animation as it is at 0 s, for ever.
    pub fn first_moment(&self, animations: &[Animation]) -> Option<Animation> {
        let stopped = |track: &Track| match track {
            Track::Translation(curve) => Track::Translation(curve.stopped(0.0)),
            Track::Rotation(curve) => Track::Rotation(curve.stopped(0.0)),
            Track::Scale(curve) => Track::Scale(curve.stopped(0.0)),
            Track::Weights(curve) => Track::Weights(curve.stopped(0.0)),
            Track::Visible(curve) => Track::Visible(curve.stopped(0.0)),
        };
        let channel = |Channel { node, track }: &Channel| {
            let node = self.in_rig[*node]?;
            Some(Channel { node, track: self.shifted(node, stopped(track)) })
        };
        let of = |animation: &Animation| animation.channels.iter().filter_map(channel).collect::<Vec<_>>();
        let channels = animations.iter().map(of).find(|channels| !channels.is_empty())?;
        Some(Animation { name: String::new(), seconds: 0.0, channels })
    }

    fn shifted(&self, node: usize, track: Track) -> Track {
        let shift = self.shifts[node];
        match track {
            Track::Translation(curve) if shift != DVec3::ZERO => {
                let moved: Curve<_> = curve.with_values(|at| (at.as_dvec3() + shift).as_vec3());
                Track::Translation(moved)
            }
            Track::Translation(_)
            | Track::Rotation(_)
            | Track::Scale(_)
            | Track::Weights(_)
            | Track::Visible(_) => track,
        }
    }
}

struct Builder<'a> {
    document: &'a Document,
    walk: &'a [Walked],
    concerns: &'a [Concern],
    /// Whether a node, or one below it, must be in the rig.
    leads: Vec<bool>,
    /// The node of the rig that stands for a still node and all above it.
    still: Vec<Option<usize>>,
    top_from_file: DMat4,
    rigging: Rigging,
    warnings: &'a mut Warnings,
}

impl Builder<'_> {
    /// Where the next node of the walk hangs; puts it into the rig where it belongs there.
    fn hang(&mut self, i: usize) -> Option<Hang> {
        let Walked { node, parent, .. } = self.walk[i];
        let concern = &self.concerns[node];
        let above = parent.and_then(|parent| self.rigging.hangs[parent]);
        let Some(above) = above else {
            if !concern.is_needed {
                return None;
            }
            let (parent, shift) = self.still_parent(parent);
            let place = self.place(node);
            let own = self.add(node, parent, place, shift);
            return Some(Hang { node: own, node_from_it: DMat4::IDENTITY, moves: concern.moves });
        };
        let moves = above.moves || concern.moves;
        let parent_from_node = self.parent_from_node(node);
        let node_from_it = then(above.node_from_it, parent_from_node);
        let json = &self.document.root.nodes[node];
        let is_far = json.mesh.is_some() && node_from_it.w_axis.truncate().length() > FAR;
        if self.leads[i] || !concern.weights.is_empty() || is_far {
            // Nothing is between what leads on and the rig.
            let is_next = above.node_from_it == DMat4::IDENTITY;
            let place = if is_next { self.place(node) } else { Place::Matrix(node_from_it) };
            let own = self.add(node, Some(above.node), place, DVec3::ZERO);
            return Some(Hang { node: own, node_from_it: DMat4::IDENTITY, moves });
        }
        Some(Hang { node: above.node, node_from_it, moves })
    }

    /// What a node of the rig hangs on that is below none, and how far it is moved instead.
    fn still_parent(&mut self, parent: Option<usize>) -> (Option<usize>, DVec3) {
        let world_from_parent = parent.map_or(self.top_from_file, |parent| self.walk[parent].world_from_node);
        if DMat3::from_mat4(world_from_parent) == DMat3::IDENTITY {
            return (None, world_from_parent.w_axis.truncate());
        }
        let Some(parent) = parent else {
            return (None, DVec3::ZERO);
        };
        let known = self.still[parent].unwrap_or_else(|| {
            let node = self.walk[parent].node;
            self.add(node, None, Place::Matrix(world_from_parent), DVec3::ZERO)
        });
        self.still[parent] = Some(known);
        (Some(known), DVec3::ZERO)
    }

    fn add(&mut self, node: usize, parent: Option<usize>, place: Place, shift: DVec3) -> usize {
        let json = &self.document.root.nodes[node];
        let rest = match place {
            // Adding nothing would take the sign of zeros.
            _ if shift == DVec3::ZERO => place,
            Place::Parts { translation, rotation, scale } => {
                Place::Parts { translation: translation + shift, rotation, scale }
            }
            Place::Matrix(matrix) => Place::Matrix(then(DMat4::from_translation(shift), matrix)),
        };
        // Neither a pose nor a file that is written could hold it.
        let is_near = rest.matrix().abs_diff_eq(DMat4::ZERO, FARTHEST);
        if !is_near {
            let label = json.name.clone().unwrap_or_else(|| format!("node {node}"));
            self.warnings
                .note("what hangs on nodes that stand too far, or are stretched too much, is hidden", &label);
        }
        self.rigging.nodes.push(Node {
            name: json.name.clone().unwrap_or_default(),
            parent,
            rest: if is_near { rest } else { Place::HERE },
            visible: is_near && visibility::of(json),
            weights: self.concerns[node].weights.clone(),
        });
        self.rigging.shifts.push(shift);
        let own = self.rigging.nodes.len() - 1;
        self.rigging.in_rig[node] = Some(own);
        own
    }

    fn parent_from_node(&self, node: usize) -> DMat4 {
        match self.document.transforms.get(node) {
            Some(Ok(transform)) => transform.parent_from_node,
            Some(Err(_)) | None => DMat4::IDENTITY,
        }
    }

    /// The place of a node in its parent. A matrix is taken apart where an animation moves a part of it.
    fn place(&mut self, node: usize) -> Place {
        let place = match self.document.transforms.get(node) {
            Some(Ok(transform)) => transform.place,
            Some(Err(_)) | None => Place::HERE,
        };
        match place {
            Place::Matrix(matrix) if self.concerns[node].moves => {
                let (scale, rotation, translation) = matrix.to_scale_rotation_translation();
                let whole = DMat4::from_scale_rotation_translation(scale, rotation, translation);
                if !whole
                    .abs_diff_eq(matrix, 1e-4 * matrix.to_scale_rotation_translation().0.abs().max_element())
                {
                    let what = "matrices of nodes that an animation moves lose their shear";
                    let json = &self.document.root.nodes[node];
                    let label = json.name.clone().unwrap_or_else(|| format!("node {node}"));
                    self.warnings.note(what, &label);
                }
                if !whole.is_finite() {
                    return Place::HERE;
                }
                Place::Parts { translation, rotation: rotation.as_quat(), scale: scale.as_vec3() }
            }
            Place::Parts { .. } | Place::Matrix(_) => place,
        }
    }
}
