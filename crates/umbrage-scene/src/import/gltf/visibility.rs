//! Which nodes are hidden, with all that hangs on them.
//!
//! Source: `KHR_node_visibility`: a node is seen where it and all that it hangs on are visible. Cameras see from hidden
//! nodes, too.

use gltf::json::{Node, Value};

use super::nodes::Walked;
use crate::curve::Keys;
use crate::rig::{Animation, Track};

/// The extension's name.
pub(crate) const VISIBILITY: &str = "KHR_node_visibility";

/// Whether a node is visible by itself.
pub(super) fn of(node: &Node) -> bool {
    let extension = node.extensions.as_ref().and_then(|extensions| extensions.others.get(VISIBILITY));
    extension.and_then(|extension| extension.get("visible")).and_then(Value::as_bool).unwrap_or(true)
}

/// Whether each node of a walk is seen at any time: no node above it is hidden without an animation that shows it.
pub(super) fn ever(nodes: &[Node], walk: &[Walked], animations: &[Animation]) -> Vec<bool> {
    let mut own: Vec<bool> = nodes.iter().map(of).collect();
    for channel in animations.iter().flat_map(|animation| &animation.channels) {
        if let Track::Visible(curve) = &channel.track {
            own[channel.node] |= match curve.keys() {
                Keys::Step(values) | Keys::Linear(values) => values.contains(&true),
                Keys::Cubic(values) => values.iter().any(|[_, visible, _]| *visible),
            };
        }
    }
    let mut ever: Vec<bool> = Vec::with_capacity(walk.len());
    for Walked { node, parent, .. } in walk {
        ever.push(own[*node] && parent.is_none_or(|parent| ever[parent]));
    }
    ever
}
