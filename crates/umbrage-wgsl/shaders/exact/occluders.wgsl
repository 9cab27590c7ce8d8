// What casts, for rays: a hierarchy of boxes over instances, one over the triangles of each mesh, and the triangles.
// `umbrage-occluders` makes it, and says how it lies.

import package::exact::node::UmbrageNode;

/// An instance of a mesh.
struct UmbragePlaced {
    /// Rows of the matrix from the world to mesh space.
    row_x: vec4f,
    row_y: vec4f,
    row_z: vec4f,
    /// Index of the mesh's first node and of the one behind its last. They are the same for one that is left to maps.
    first: u32,
    end: u32,
    /// What to add to the corners of its triangles: bent meshes have corners of their own.
    corner_offset: u32,
}

/// The hierarchy over instances, in which the first node's `next` is the number of nodes; then those of all meshes.
@group(0) @binding(6) var<storage, read> umbrage_nodes: array<UmbrageNode>;
@group(0) @binding(7) var<storage, read> umbrage_placed: array<UmbragePlaced>;
/// Three corners, and one more than the surface of a triangle that is not solid.
@group(0) @binding(8) var<storage, read> umbrage_triangles: array<vec4u>;
/// Three coordinates each, in mesh space.
@group(0) @binding(9) var<storage, read> umbrage_corners: array<f32>;
