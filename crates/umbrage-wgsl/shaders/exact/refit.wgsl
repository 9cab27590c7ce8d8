// Makes hierarchies fit meshes that were bent: corners go to where the host's vertices are, and boxes are made anew, from the
// leaves up.
//
// A workgroup refits one mesh. Nodes of one height know nothing of each other, so its lanes share them, and wait for each other
// between two heights. What lies in which node stays as it was at rest.

import package::exact::node::UmbrageNode;

/// A mesh to refit.
struct UmbrageRefit {
    /// Index of its first vertex among the positions.
    vertex: u32,
    /// Index of its first corner, and their number.
    corner: u32,
    corners: u32,
    /// What to add to the corners of its triangles.
    corner_offset: u32,
    /// Index of its first node, and their number.
    node: u32,
    nodes: u32,
    /// Where its lists begin: where each height ends among the nodes; the nodes, leaves first; the vertex of each corner.
    lists: u32,
    heights: u32,
}

@group(0) @binding(0) var<storage, read> umbrage_refits: array<UmbrageRefit>;
@group(0) @binding(1) var<storage, read> umbrage_refit_lists: array<u32>;
/// Three coordinates a vertex.
@group(0) @binding(2) var<storage, read> umbrage_bent_positions: array<f32>;
@group(0) @binding(3) var<storage, read> umbrage_bent_triangles: array<vec4u>;
@group(0) @binding(4) var<storage, read_write> umbrage_bent_corners: array<f32>;
@group(0) @binding(5) var<storage, read_write> umbrage_bent_nodes: array<UmbrageNode>;

struct UmbrageBox {
    low: vec3f,
    high: vec3f,
}

const UMBRAGE_REFIT_LANES: u32 = 64u;

/// Rounding may move a ray by this share of its coordinates: boxes are so much larger.
const UMBRAGE_BOX_MARGIN: f32 = 1.0 / 1048576.0;

/// Farther than any vertex: one that is not nearer is nowhere.
const UMBRAGE_NOWHERE: f32 = 1e30;

fn umbrage_bent_corner(corner: u32) -> vec3f {
    let at = 3u * corner;
    return vec3f(umbrage_bent_corners[at], umbrage_bent_corners[at + 1u], umbrage_bent_corners[at + 2u]);
}

/// The box around the triangles of a leaf. Those with a corner that is nowhere can be met by no ray, and do not count.
fn umbrage_leaf_box(leaf: u32, corner_offset: u32) -> UmbrageBox {
    var bounds = UmbrageBox(vec3f(UMBRAGE_NOWHERE), vec3f(-UMBRAGE_NOWHERE));
    let first = leaf >> 3u;
    for (var i = first; i < first + (leaf & 7u); i++) {
        let triangle = umbrage_bent_triangles[i].xyz + corner_offset;
        let a = umbrage_bent_corner(triangle.x);
        let b = umbrage_bent_corner(triangle.y);
        let c = umbrage_bent_corner(triangle.z);
        let low = min(a, min(b, c));
        let high = max(a, max(b, c));
        if all(max(abs(low), abs(high)) < vec3f(UMBRAGE_NOWHERE)) {
            bounds.low = min(bounds.low, low);
            bounds.high = max(bounds.high, high);
        }
    }
    let margin = max(abs(bounds.low), abs(bounds.high)) * UMBRAGE_BOX_MARGIN;
    return UmbrageBox(bounds.low - margin, bounds.high + margin);
}

/// The box around both children of a node.
fn umbrage_inner_box(node: u32) -> UmbrageBox {
    let a = node + 1u;
    let b = umbrage_bent_nodes[a].next;
    return UmbrageBox(
        min(umbrage_bent_nodes[a].low, umbrage_bent_nodes[b].low),
        max(umbrage_bent_nodes[a].high, umbrage_bent_nodes[b].high));
}

@compute @workgroup_size(UMBRAGE_REFIT_LANES)
fn refit(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let number = group.y * groups.x + group.x;
    if number >= arrayLength(&umbrage_refits) {
        return;
    }
    let bent = umbrage_refits[number];
    let nodes = bent.lists + bent.heights;
    let vertices = nodes + bent.nodes;
    for (var i = lane; i < bent.corners; i += UMBRAGE_REFIT_LANES) {
        let vertex = bent.vertex + umbrage_refit_lists[vertices + i];
        for (var axis = 0u; axis < 3u; axis++) {
            umbrage_bent_corners[3u * (bent.corner + i) + axis] = umbrage_bent_positions[3u * vertex + axis];
        }
    }
    var begin = 0u;
    for (var height = 0u; height < bent.heights; height++) {
        // What is below stands.
        storageBarrier();
        let end = umbrage_refit_lists[bent.lists + height];
        for (var i = begin + lane; i < end; i += UMBRAGE_REFIT_LANES) {
            let node = bent.node + umbrage_refit_lists[nodes + i];
            let leaf = umbrage_bent_nodes[node].leaf;
            var bounds: UmbrageBox;
            if leaf > 0u {
                bounds = umbrage_leaf_box(leaf, bent.corner_offset);
            } else {
                bounds = umbrage_inner_box(node);
            }
            umbrage_bent_nodes[node].low = bounds.low;
            umbrage_bent_nodes[node].high = bounds.high;
        }
        begin = end;
    }
}
