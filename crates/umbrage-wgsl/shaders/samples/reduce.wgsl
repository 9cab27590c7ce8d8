// How far the receivers of each view reach across the light, from the camera's depth (Lauritzen et al. 2011, §4). A workgroup
// takes 64² pixels of one view: each of its 64 lanes every eighth pixel of every eighth row, then all lanes together, then all
// workgroups. Depth is reversed; where it is 0 there is the sky.

import package::samples::looks::{UMBRAGE_SEEN, umbrage_key, umbrage_looks, umbrage_seen};

@group(0) @binding(4) var umbrage_seen_depth: texture_2d<f32>;

var<workgroup> umbrage_seen_here: array<atomic<u32>, UMBRAGE_SEEN>;

/// What reaches so much farther than everything that nothing was seen.
const UMBRAGE_NOTHING: f32 = -3.0e38;

fn umbrage_reach_here(first: u32, reach: vec3f) {
    for (var i = 0u; i < 3u; i++) {
        atomicMax(&umbrage_seen_here[first + i], umbrage_key(reach[i]));
    }
}

@compute @workgroup_size(8, 8)
fn reduce(
    @builtin(workgroup_id) group: vec3u,
    @builtin(local_invocation_id) lane: vec3u,
    @builtin(local_invocation_index) index: u32,
) {
    let size = textureDimensions(umbrage_seen_depth);
    let view = group.z;
    let start = umbrage_looks.views[view].depth_start;
    let end = umbrage_looks.views[view].depth_end;
    let rights = umbrage_looks.views[view].rights;
    let ups = umbrage_looks.views[view].ups;
    let steps = select(0u, 64u, umbrage_looks.views[view].is_fitted != 0u);
    let pixel_height = umbrage_looks.picture_height / f32(size.y);
    var right = vec3f(UMBRAGE_NOTHING);
    var left = vec3f(UMBRAGE_NOTHING);
    var up = vec3f(UMBRAGE_NOTHING);
    var down = vec3f(UMBRAGE_NOTHING);
    var far = UMBRAGE_NOTHING;
    var near = UMBRAGE_NOTHING;
    for (var i = 0u; i < steps; i++) {
        let pixel = group.xy * 64u + lane.xy + 8u * vec2u(i % 8u, i / 8u);
        if any(pixel >= size) {
            continue;
        }
        let depth = textureLoad(umbrage_seen_depth, pixel, 0).x;
        let ndc = ((vec2f(pixel) + 0.5) / vec2f(size) * 2.0 - 1.0) * vec2f(1.0, -1.0);
        let clip = umbrage_looks.world_from_clip * vec4f(ndc, depth, 1.0);
        let position = clip.xyz / clip.w;
        let view_depth = dot(umbrage_looks.depth_row, vec4f(position, 1.0));
        if depth <= 0.0 || view_depth < start || view_depth > end {
            continue;
        }
        // A surface may go on to where the next pixel begins.
        let pixel_metres = pixel_height / clip.w;
        let x = position * rights;
        let y = position * ups;
        right = max(right, x + pixel_metres);
        left = max(left, pixel_metres - x);
        up = max(up, y + pixel_metres);
        down = max(down, pixel_metres - y);
        far = max(far, view_depth);
        near = max(near, -view_depth);
    }
    if far > UMBRAGE_NOTHING {
        umbrage_reach_here(0u, right);
        umbrage_reach_here(3u, left);
        umbrage_reach_here(6u, up);
        umbrage_reach_here(9u, down);
        atomicMax(&umbrage_seen_here[12], umbrage_key(far));
        atomicMax(&umbrage_seen_here[13], umbrage_key(near));
    }
    workgroupBarrier();
    if index < UMBRAGE_SEEN {
        let most = atomicLoad(&umbrage_seen_here[index]);
        if most > 0u {
            atomicMax(&umbrage_seen[view * UMBRAGE_SEEN + index], most);
        }
    }
}
