//! The nodes of all hierarchies, in the order in which a ray without a stack asks them.
//!
//! A node is followed by its subtree. A ray that meets a node's box goes on to the node after it, and one that does not follows
//! `next` past the subtree. The child with the larger surface stands first, as it is the more likely to end the walk.

use bytemuck::{Pod, Zeroable};
use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;

/// A node is a box, and what lies in it. Mirrors `UmbrageNode` of `exact/node.wgsl`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Node {
    /// The least coordinates of what lies in the box.
    pub low: [f32; 3],
    /// The index of the node after this one's subtree.
    pub next: u32,
    /// The largest coordinates.
    pub high: [f32; 3],
    /// What a leaf holds; 0 for an inner node. In a mesh it is eight times the first triangle plus their number, in the top level
    /// one more than the instance.
    pub leaf: u32,
}

/// The most triangles in a leaf.
pub(crate) const MAX_TRIANGLES: u32 = 7;

/// Rounding may move a ray by this share of its coordinates: boxes are so much larger.
const MARGIN: f32 = 1.0 / 1_048_576.0;

/// Builds the hierarchy over some boxes. A leaf holds at most `most` of them.
pub(crate) fn bvh(boxes: &[Aabb], most: u32) -> Bvh2 {
    let params = BvhBuildParams::fast_build();
    let mut bvh = PlocBuilder::with_capacity(boxes.len()).build(
        params.ploc_search_distance,
        boxes,
        (0..boxes.len() as u32).collect(),
        params.sort_precision,
        params.search_depth_threshold,
    );
    ReinsertionOptimizer::default().run(&mut bvh, params.reinsertion_batch_ratio, None);
    collapse(&mut bvh, most, params.collapse_traversal_cost);
    bvh
}

/// A box around some corners, with a margin for the rounding of a ray.
pub(crate) fn padded(corners: impl IntoIterator<Item = Vec3A>) -> Aabb {
    let bounds = corners.into_iter().fold(Aabb::empty(), |mut bounds, corner| {
        bounds.extend(corner);
        bounds
    });
    let margin = bounds.min.abs().max(bounds.max.abs()) * MARGIN;
    Aabb { min: bounds.min - margin, max: bounds.max + margin }
}

/// Appends the nodes of a hierarchy. `leaf` says what is written for a leaf of so many primitives that begin at one.
pub(crate) fn append(nodes: &mut Vec<Node>, bvh: &Bvh2, leaf: impl Fn(u32, u32) -> u32) {
    enum Step {
        Enter(u32),
        Leave(usize),
    }
    let mut steps = vec![Step::Enter(0)];
    while let Some(step) = steps.pop() {
        match step {
            Step::Leave(node) => nodes[node].next = nodes.len() as u32,
            Step::Enter(index) => {
                let Some(node) = bvh.nodes.get(index as usize) else { continue };
                let Aabb { min, max } = *node.aabb();
                let place = nodes.len();
                let what = if node.is_leaf() { leaf(node.first_index, node.prim_count) } else { 0 };
                nodes.push(Node { low: min.into(), next: 0, high: max.into(), leaf: what });
                steps.push(Step::Leave(place));
                if !node.is_leaf() {
                    let [a, b] = [node.first_index, node.first_index + 1];
                    let area = |i: u32| bvh.nodes[i as usize].aabb().half_area();
                    let (first, second) = if area(a) >= area(b) { (a, b) } else { (b, a) };
                    steps.extend([Step::Enter(second), Step::Enter(first)]);
                }
            }
        }
    }
}

/// The box around what a hierarchy holds.
pub(crate) fn bounds(bvh: &Bvh2) -> Aabb {
    bvh.nodes.first().map_or(Aabb::empty(), |root| *root.aabb())
}
