// Where the vertices and triangles of all closed meshes are. It needs no other.

@group(0) @binding(6) var<storage, read> positions: array<f32>;
@group(0) @binding(7) var<storage, read> triangles: array<u32>;

/// Where a vertex is, in the space of its mesh.
fn place(vertex: u32) -> vec3f {
    return vec3f(positions[3u * vertex], positions[3u * vertex + 1u], positions[3u * vertex + 2u]);
}
