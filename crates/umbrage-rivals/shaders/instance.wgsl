// What the passes of shadow volumes know of an instance.

struct Instance {
    clip_from_mesh: mat4x4f,
    /// The light in the space of the mesh, homogeneous.
    light: vec4f,
    /// Where the mesh's own begin in the buffers of all: vertices, triangles, edges.
    first_vertex: u32,
    first_triangle: u32,
    first_edge: u32,
    /// Where the instance's own bits begin, in words.
    first_word: u32,
    triangles: u32,
    edges: u32,
    /// 1: it casts. 2: it mirrors its mesh. 4: the near plane may
    /// open it, and the light is outside of it.
    flags: u32,
    /// The distance from the light, in the space of the mesh, nearer than which nothing casts.
    near: f32,
    /// The camera in the space of the mesh, homogeneous: w is 0 where its rays are parallel.
    eye: vec4f,
    /// How often the way from the light to a vertex goes on beyond it, where shadows end somewhere; of a sun's unit vector
    /// likewise. 1 where they end at infinity.
    reach: f32,
}

const CASTS: u32 = 1u;
const MIRRORS: u32 = 2u;
const OPENED: u32 = 4u;

@group(0) @binding(1) var<storage, read> instances: array<Instance>;
