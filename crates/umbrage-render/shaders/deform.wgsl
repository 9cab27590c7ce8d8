// Bends meshes, once for all passes of a frame: first morph targets move a vertex, then the joints of a skin.
//
// A workgroup bends a patch of 64 vertices of one shape. Buffers of vertices are arrays of floats, for passes read them as
// vertices: 3 a position; 5 a normal with texture coordinates, which stay.

struct Patch {
    /// The first of its vertices among those at rest, and among those that are bent.
    rest: u32,
    bent: u32,
    count: u32,
    /// The shape's first joint and first weight; NONE where it has none.
    joint: u32,
    weight: u32,
}

const NONE: u32 = 0xffffffffu;

struct Vertex {
    position: vec3f,
    /// Where its list of joints begins; it ends where that of the next vertex begins.
    influences: u32,
    normal: vec3f,
    /// The same for the morph targets that move it.
    deltas: u32,
}

struct Influence {
    joint: u32,
    weight: f32,
}

struct Delta {
    position: vec3f,
    morph: u32,
    normal: vec3f,
}

@group(0) @binding(0) var<storage, read> patches: array<Patch>;
@group(0) @binding(1) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(2) var<storage, read> influences: array<Influence>;
@group(0) @binding(3) var<storage, read> deltas: array<Delta>;
/// The three rows of each joint's matrix.
@group(0) @binding(4) var<storage, read> joints: array<mat3x4f>;
@group(0) @binding(5) var<storage, read> weights: array<f32>;
@group(0) @binding(6) var<storage, read_write> positions: array<f32>;
@group(0) @binding(7) var<storage, read_write> attributes: array<f32>;

@compute @workgroup_size(64)
fn deform(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) index: u32,
) {
    let number = group.y * groups.x + group.x;
    if number >= arrayLength(&patches) {
        return;
    }
    let piece = patches[number];
    if index >= piece.count {
        return;
    }
    let vertex = vertices[piece.rest + index];
    let next = vertices[piece.rest + index + 1u];
    var position = vertex.position;
    var normal = vertex.normal;
    if piece.weight != NONE {
        for (var i = vertex.deltas; i < next.deltas; i++) {
            let delta = deltas[i];
            let weight = weights[piece.weight + delta.morph];
            position += weight * delta.position;
            normal += weight * delta.normal;
        }
    }
    if piece.joint != NONE {
        var rows = mat3x4f();
        for (var i = vertex.influences; i < next.influences; i++) {
            rows += influences[i].weight * joints[piece.joint + influences[i].joint];
        }
        position = vec4f(position, 1.0) * rows;
        normal = turned(rows, normal);
    }
    normal *= inverseSqrt(max(dot(normal, normal), 1e-30));
    let bent = piece.bent + index;
    for (var axis = 0u; axis < 3u; axis++) {
        positions[3u * bent + axis] = position[axis];
        attributes[5u * bent + axis] = normal[axis];
    }
}

/// A normal by the cofactors of a matrix, which is right under any scale; a mirror turns it over. How large the matrix is does
/// not matter, so that products do not vanish.
fn turned(rows: mat3x4f, normal: vec3f) -> vec3f {
    let sizes = max(abs(rows[0]), max(abs(rows[1]), abs(rows[2]))).xyz;
    let scale = 1.0 / max(max(sizes.x, max(sizes.y, sizes.z)), 1e-30);
    let a = scale * rows[0].xyz;
    let b = scale * rows[1].xyz;
    let c = scale * rows[2].xyz;
    let cofactors = mat3x3f(cross(b, c), cross(c, a), cross(a, b));
    return (normal * cofactors) * select(1.0, -1.0, dot(a, cross(b, c)) < 0.0);
}
