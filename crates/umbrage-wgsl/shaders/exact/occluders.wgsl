// What casts, for rays: a hierarchy of boxes over instances, one over the triangles of each mesh, and the triangles.
// `umbrage-occluders` makes it, and says how it lies. It lies in textures, of which every device holds larger ones than storage
// buffers, and which software reads several times faster; an entry is a texel or several, in rows of 4096.

/// A box of the hierarchy over instances, and what lies in it. The nodes of a subtree follow their root.
struct UmbrageTopNode {
    low: vec3f,
    /// Index of the node after the subtree.
    next: u32,
    high: vec3f,
    /// One more than the instance of a leaf, and 0 for an inner node.
    leaf: u32,
}

/// An instance of a mesh.
struct UmbragePlaced {
    /// Rows of the matrix from the world to mesh space.
    row_x: vec4f,
    row_y: vec4f,
    row_z: vec4f,
    /// Where the grid begins that the mesh's boxes are told in, in mesh space, and how many of its steps are a unit there.
    grid_low: vec3f,
    grid_scale: vec3f,
    /// Index of the mesh's first node and of the one behind its last. They are the same for one that is bent.
    first: u32,
    end: u32,
}

/// A box of the hierarchy over a mesh, in steps of the mesh's grid.
struct UmbrageNode {
    low: vec3f,
    high: vec3f,
    /// Eight times the node after the subtree; or for a leaf eight times its first triangle, plus their number.
    link: u32,
}

/// Two texels a node. The first node's `next` is the number of nodes.
@group(0) @binding(6) var umbrage_top_nodes: texture_2d<u32>;
/// Five texels an instance.
@group(0) @binding(7) var umbrage_placed: texture_2d<u32>;
/// A texel a node.
@group(0) @binding(8) var umbrage_nodes: texture_2d<u32>;
/// A texel a triangle: three corners, and one more than the surface of one that is not solid.
@group(0) @binding(9) var umbrage_triangles: texture_2d<u32>;
/// A texel a corner: its coordinates in mesh space.
@group(0) @binding(10) var umbrage_corners: texture_2d<u32>;

/// Where a texture holds a texel.
fn umbrage_texel(index: u32) -> vec2u {
    return vec2u(index & 4095u, index >> 12u);
}

fn umbrage_top_node(index: u32) -> UmbrageTopNode {
    let low = textureLoad(umbrage_top_nodes, umbrage_texel(2u * index), 0);
    let high = textureLoad(umbrage_top_nodes, umbrage_texel(2u * index + 1u), 0);
    return UmbrageTopNode(bitcast<vec3f>(low.xyz), low.w, bitcast<vec3f>(high.xyz), high.w);
}

fn umbrage_instance(index: u32) -> UmbragePlaced {
    let first = 5u * index;
    let x = textureLoad(umbrage_placed, umbrage_texel(first), 0);
    let y = textureLoad(umbrage_placed, umbrage_texel(first + 1u), 0);
    let z = textureLoad(umbrage_placed, umbrage_texel(first + 2u), 0);
    let low = textureLoad(umbrage_placed, umbrage_texel(first + 3u), 0);
    let scale = textureLoad(umbrage_placed, umbrage_texel(first + 4u), 0);
    return UmbragePlaced(
        bitcast<vec4f>(x), bitcast<vec4f>(y), bitcast<vec4f>(z),
        bitcast<vec3f>(low.xyz), bitcast<vec3f>(scale.xyz), low.w, scale.w);
}

fn umbrage_node(index: u32) -> UmbrageNode {
    let node = textureLoad(umbrage_nodes, umbrage_texel(index), 0);
    let low = vec3u(node.x & 0xffffu, node.x >> 16u, node.y & 0xffffu);
    let high = vec3u(node.y >> 16u, node.z & 0xffffu, node.z >> 16u);
    return UmbrageNode(vec3f(low), vec3f(high), node.w);
}

fn umbrage_triangle(index: u32) -> vec4u {
    return textureLoad(umbrage_triangles, umbrage_texel(index), 0);
}

/// The coordinates of a corner, in mesh space.
fn umbrage_corner(index: u32) -> vec3f {
    return bitcast<vec3f>(textureLoad(umbrage_corners, umbrage_texel(index), 0).xyz);
}
