// Pieces of volumes, appended to one list in any order. A piece is an instance, and what it is of: a triangle's number, twice; or an
// edge's number four times, and 1, and 2 where its right triangle faces away. It needs `shot.wgsl`.

struct Draw {
    vertex_count: atomic<u32>,
    instance_count: u32,
    first_vertex: u32,
    first_instance: u32,
}

@group(0) @binding(2) var<storage, read> jobs: array<vec2u>;
@group(0) @binding(3) var<storage, read_write> turned_away: array<u32>;
@group(0) @binding(4) var<storage, read_write> pieces: array<vec2u>;
@group(0) @binding(5) var<storage, read_write> draw: Draw;

var<workgroup> wanted: atomic<u32>;
var<workgroup> first_piece: u32;

/// Appends the pieces that a workgroup wants; all of it must call this.
fn append(lane: u32, is_wanted: bool, piece: vec2u) {
    var rank = 0u;
    if is_wanted {
        rank = atomicAdd(&wanted, 1u);
    }
    workgroupBarrier();
    if lane == 0u {
        first_piece = atomicAdd(&draw.vertex_count, atomicLoad(&wanted) * shot.corners) / shot.corners;
    }
    workgroupBarrier();
    if is_wanted {
        pieces[first_piece + rank] = piece;
    }
}
