//! The nodes of a rig as nodes of glTF, and what hangs on them.
//!
//! A mesh is the node's own where it stands in it unmoved and is called as it is; else it hangs on a child. Places are
//! rounded to f32, as all of glTF is.

use std::collections::HashSet;

use glam::Mat4;
use gltf::json::extensions::scene::Node as NodeExtensions;
use gltf::json::scene::UnitQuaternion;
use gltf::json::{Index, Node, Value};

use super::bytes::Document;
use crate::error::Fault;
use crate::import::VISIBILITY;
use crate::rig::{self, Place, Rig, Track};
use crate::{Instance, Mesh, Motion};

/// The nodes of a rig in a document.
#[derive(Debug)]
pub(super) struct Tree<'a> {
    rig: &'a Rig,
    nodes: Vec<Index<Node>>,
    /// What hangs on each node, beside other nodes of the rig.
    things: Vec<Vec<Index<Node>>>,
    /// The nodes that carry meshes morphed by the weights of a node of the rig, and which of it.
    pub morphed: Vec<(usize, Index<Node>)>,
}

impl<'a> Tree<'a> {
    /// Adds the nodes, without children yet.
    pub fn new(document: &mut Document, rig: &'a Rig) -> Result<Self, Fault> {
        let channels = rig.animations.iter().flat_map(|animation| &animation.channels);
        let shown = channels.filter(|channel| matches!(channel.track, Track::Visible(_)));
        let shown: HashSet<usize> = shown.map(|channel| channel.node).collect();
        let mut nodes = Vec::with_capacity(rig.nodes.len());
        for (i, node) in rig.nodes.iter().enumerate() {
            if node.parent.is_some_and(|parent| parent >= i) {
                return Err(Fault(format!(
                    "node {i} of the rig hangs on {:?}, need an earlier one",
                    node.parent
                )));
            }
            let says = !node.visible || shown.contains(&i);
            let json = place(node)?;
            let extensions = says.then(|| visibility(document, node.visible));
            nodes.push(document.root.push(Node { extensions, ..json }));
        }
        Ok(Self { rig, things: vec![Vec::new(); nodes.len()], nodes, morphed: Vec::new() })
    }

    /// Returns the document's node of a node of the rig.
    pub fn node(&self, node: usize) -> Result<Index<Node>, Fault> {
        let missing = || Fault(format!("node {node} of a rig of {}", self.nodes.len()));
        self.nodes.get(node).copied().ok_or_else(missing)
    }

    /// Adds a node that hangs on the rig, or returns its number where it hangs on nothing.
    pub fn hang(
        &mut self,
        document: &mut Document,
        on: Option<usize>,
        json: Node,
    ) -> Result<Option<Index<Node>>, Fault> {
        let own = document.root.push(json);
        let Some(on) = on else {
            return Ok(Some(own));
        };
        self.node(on)?;
        self.things[on].push(own);
        Ok(None)
    }

    /// Adds an instance, whose node without a place is given; returns its number where it hangs on nothing.
    pub fn hang_mesh(
        &mut self,
        document: &mut Document,
        instance: &Instance,
        mesh: &Mesh,
        json: Node,
    ) -> Result<Option<Index<Node>>, Fault> {
        let (on, matrix) = match instance.motion {
            Motion::Node { node, node_from_thing } => (Some(node), Some(node_from_thing)),
            Motion::Skin { .. } => (instance.node, None),
            Motion::Rotation { .. } => (None, Some(instance.world_from_mesh)),
            Motion::Still => (instance.node, Some(self.at_rest(instance))),
        };
        let weights = instance.node.filter(|_| !mesh.targets.is_empty());
        let weighs = weights.and_then(|node| self.rig.nodes.get(node)).map(|node| node.weights.clone());
        let weighs = weighs.filter(|weights| !weights.is_empty());
        if let Some(own) = on.and_then(|on| self.nodes.get(on)) {
            let is_in_place = matrix.is_none_or(|matrix| matrix == Mat4::IDENTITY);
            let carrier = &mut document.root.nodes[own.value()];
            if is_in_place && carrier.mesh.is_none() && carrier.name == json.name {
                (carrier.mesh, carrier.skin, carrier.extras) = (json.mesh, json.skin, json.extras);
                carrier.weights = weighs;
                self.morphed.extend(weights.map(|weights| (weights, *own)));
                return Ok(None);
            }
        }
        let placed = match matrix {
            Some(matrix) => node(matrix)?,
            None => Node::default(),
        };
        let own = Index::new(document.root.nodes.len() as u32);
        self.morphed.extend(weights.map(|weights| (weights, own)));
        self.hang(document, on, Node { matrix: placed.matrix, weights: weighs, ..json })
    }

    /// Where a still instance stands in the node that hides it.
    fn at_rest(&self, instance: &Instance) -> Mat4 {
        let Some(node) = instance.node else {
            return instance.world_from_mesh;
        };
        let node_from_world = self.rig.pose_of(None, 0.0).world_from_node(node).inverse();
        (node_from_world * instance.world_from_mesh.as_dmat4()).as_mat4()
    }

    /// Hangs the nodes on each other; returns those that hang on nothing.
    pub fn close(mut self, document: &mut Document) -> Vec<Index<Node>> {
        let mut tops = Vec::new();
        for (own, node) in self.nodes.iter().zip(&self.rig.nodes) {
            match node.parent {
                Some(parent) => self.things[parent].push(*own),
                None => tops.push(*own),
            }
        }
        for (own, things) in self.nodes.iter().zip(self.things) {
            if !things.is_empty() {
                document.root.nodes[own.value()].children = Some(things);
            }
        }
        tops
    }
}

/// A node that stands there. The matrix is written even where it is the identity: its zeros have signs.
pub(super) fn node(world_from_node: Mat4) -> Result<Node, Fault> {
    if !world_from_node.is_finite() {
        return Err(Fault(format!("a matrix that is not finite, {world_from_node}")));
    }
    Ok(Node { matrix: Some(world_from_node.to_cols_array()), ..Node::default() })
}

fn place(node: &rig::Node) -> Result<Node, Fault> {
    let name = (!node.name.is_empty()).then(|| node.name.clone());
    let fault = || Fault(format!("node {:?} of the rig stands at {:?}", node.name, node.rest));
    match node.rest {
        Place::Matrix(matrix) => {
            self::node(matrix.as_mat4()).map(|json| Node { name, ..json }).map_err(|_| fault())
        }
        Place::Parts { translation, rotation, scale } => {
            let translation = translation.as_vec3();
            if !(translation.is_finite() && rotation.is_finite() && scale.is_finite()) {
                return Err(fault());
            }
            Ok(Node {
                name,
                translation: Some(translation.to_array()),
                rotation: Some(UnitQuaternion(rotation.to_array())),
                scale: Some(scale.to_array()),
                ..Node::default()
            })
        }
    }
}

fn visibility(document: &mut Document, visible: bool) -> NodeExtensions {
    document.declare(VISIBILITY);
    let says: Value = [("visible", visible)].into_iter().collect();
    NodeExtensions {
        others: [(VISIBILITY.to_owned(), says)].into_iter().collect(),
        ..NodeExtensions::default()
    }
}
