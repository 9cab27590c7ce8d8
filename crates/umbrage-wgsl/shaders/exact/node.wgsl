// A node of a hierarchy of boxes.

/// A box, and what lies in it. The nodes of a subtree follow their root.
struct UmbrageNode {
    low: vec3f,
    /// Index of the node after the subtree.
    next: u32,
    high: vec3f,
    /// What a leaf holds, and 0 for an inner node: one more than an instance, or eight times the first of some triangles plus their
    /// number.
    leaf: u32,
}
