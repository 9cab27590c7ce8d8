// Summed-area tables (Crow 1984): the sum of all texels to the left and above, first along rows and then along columns, in
// whole numbers that wrap around. A workgroup takes a row or a column: each of its 64 lanes sums a stretch, the stretches' sums
// are summed, and each lane goes over its stretch again.

import constants::UMBRAGE_SUM_SCALE;
import chosen::umbrage_moments_of;
import package::current_view::umbrage_current_view;
import package::frame::umbrage_frame;
import package::linear_depth::umbrage_linear_depth;
import package::prefilter::depths::umbrage_drawn_depth;

@group(0) @binding(2) var umbrage_summed_rows: texture_2d<u32>;
/// Where the sums of rows go, and then those of columns.
@group(0) @binding(3) var umbrage_summed: texture_storage_2d<UMBRAGE_FORMAT, write>;

const UMBRAGE_LANES: u32 = 64u;
var<workgroup> umbrage_stretches: array<vec4u, UMBRAGE_LANES>;

/// What a texel of the tile adds: its moments, in steps of 1 / UMBRAGE_SUM_SCALE.
fn umbrage_added(texel: vec2u) -> vec4u {
    let stored = umbrage_drawn_depth(vec2i(texel));
    let depth = clamp(umbrage_linear_depth(umbrage_current_view.x, vec2f(texel) + 0.5, stored), 0.0, 1.0);
    let moments = clamp(umbrage_moments_of(depth, vec2f(0.0)), vec4f(0.0), vec4f(1.0));
    return vec4u(round(moments * UMBRAGE_SUM_SCALE));
}

/// What the lanes before this one summed.
fn umbrage_before(lane: u32, own: vec4u) -> vec4u {
    umbrage_stretches[lane] = own;
    workgroupBarrier();
    var before = vec4u(0u);
    for (var i = 0u; i < lane; i++) {
        before += umbrage_stretches[i];
    }
    return before;
}

@compute @workgroup_size(UMBRAGE_LANES)
fn rows(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let side = u32(umbrage_frame.views[umbrage_current_view.x].tile.z);
    let stretch = (side + UMBRAGE_LANES - 1u) / UMBRAGE_LANES;
    let start = min(lane * stretch, side);
    let end = min(start + stretch, side);
    var own = vec4u(0u);
    for (var x = start; x < end; x++) {
        own += umbrage_added(vec2u(x, group.x));
    }
    var sum = umbrage_before(lane, own);
    for (var x = start; x < end; x++) {
        sum += umbrage_added(vec2u(x, group.x));
        textureStore(umbrage_summed, vec2u(x, group.x), sum);
    }
}

@compute @workgroup_size(UMBRAGE_LANES)
fn columns(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let side = u32(umbrage_frame.views[umbrage_current_view.x].tile.z);
    let origin = vec2u(umbrage_frame.views[umbrage_current_view.x].tile.xy);
    let stretch = (side + UMBRAGE_LANES - 1u) / UMBRAGE_LANES;
    let start = min(lane * stretch, side);
    let end = min(start + stretch, side);
    var own = vec4u(0u);
    for (var y = start; y < end; y++) {
        own += textureLoad(umbrage_summed_rows, vec2u(group.x, y), 0);
    }
    var sum = umbrage_before(lane, own);
    for (var y = start; y < end; y++) {
        sum += textureLoad(umbrage_summed_rows, vec2u(group.x, y), 0);
        textureStore(umbrage_summed, origin + vec2u(group.x, y), sum);
    }
}
