//! What it takes to make a hierarchy fit again when its mesh was bent: which vertex each corner was, and in what order nodes are
//! asked, so that a box is known before those around it.

use crate::node::Node;

/// A refit moves the corners of a mesh to where its vertices are, and makes the boxes around them anew, from the leaves up. Copies
/// of a mesh share one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Refit {
    /// The index of the mesh's first corner; copies have theirs [`MeshRange::corner_offset`](crate::MeshRange::corner_offset) behind it.
    pub first_corner: u32,
    /// The vertex of the host's mesh that each corner was.
    pub vertices: Vec<u32>,
    /// The nodes, counted from the first of the mesh: leaves, then what is one step above them, and so on.
    pub nodes: Vec<u32>,
    /// Where the nodes of each height end in `nodes`.
    pub heights: Vec<u32>,
}

impl Refit {
    /// The refit of a mesh whose nodes link among themselves.
    pub(crate) fn of(nodes: &[Node], vertices: Vec<u32>) -> Self {
        let mut height_of = vec![0; nodes.len()];
        for (i, node) in nodes.iter().enumerate().rev().filter(|(_, node)| node.leaf == 0) {
            // A child follows its parent, and the other one the first one's subtree.
            let children = [i + 1, nodes[i + 1].next as usize];
            debug_assert!(children[1] < node.next as usize);
            height_of[i] = 1 + children.map(|child| height_of[child]).into_iter().fold(0, u32::max);
        }
        let mut order: Vec<u32> = (0..nodes.len() as u32).collect();
        order.sort_by_key(|node| height_of[*node as usize]);
        let highest = height_of.first().copied().unwrap_or(0);
        let end = |height| order.partition_point(|node| height_of[*node as usize] <= height) as u32;
        let heights = (0..=highest).map(end).collect();
        Self { first_corner: 0, vertices, nodes: order, heights }
    }
}
