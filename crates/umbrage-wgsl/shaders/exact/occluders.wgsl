// What casts, for rays: a hierarchy of boxes over instances, one over the triangles of each mesh, and the triangles.
// `umbrage-occluders` makes it, and says how it lies.

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

/// An instance of a mesh.
struct UmbragePlaced {
    /// Rows of the matrix from the world to mesh space.
    row_x: vec4f,
    row_y: vec4f,
    row_z: vec4f,
    /// Index of the mesh's first node and of the one behind its last. They are the same for one that is bent.
    first: u32,
    end: u32,
}

/// The hierarchy over instances, in which the first node's `next` is the number of nodes; then those of all meshes.
@group(0) @binding(6) var<storage, read> umbrage_nodes: array<UmbrageNode>;
@group(0) @binding(7) var<storage, read> umbrage_placed: array<UmbragePlaced>;
/// Three corners, and one more than the surface of a triangle that is not solid.
@group(0) @binding(8) var<storage, read> umbrage_triangles: array<vec4u>;
/// Three coordinates each, in mesh space.
@group(0) @binding(9) var<storage, read> umbrage_corners: array<f32>;
