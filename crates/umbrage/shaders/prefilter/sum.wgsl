// Summed-area tables (Crow 1984): the sum of all texels to the left and above, first along rows and then along columns, in
// whole numbers that wrap around. A workgroup takes a row or a column: each of its 64 lanes sums a stretch, the stretches' sums
// are summed, and each lane goes over its stretch again. In front of it go the frame, `depth.wgsl` and a file of `moments/`.

@group(0) @binding(1) var<uniform> umbrage_prefilter_view: vec4u;
@group(0) @binding(2) var umbrage_depths: texture_depth_2d_array;
@group(0) @binding(3) var umbrage_rows: texture_storage_2d<UMBRAGE_SUM_FORMAT, write>;
@group(0) @binding(2) var umbrage_summed_rows: texture_2d<u32>;
@group(0) @binding(3) var umbrage_sums: texture_storage_2d<UMBRAGE_SUM_FORMAT, write>;

const LANES: u32 = 64u;
var<workgroup> stretches: array<vec4u, LANES>;

/// What a texel of the tile adds: its moments, in steps of 1 / UMBRAGE_SUM_SCALE.
fn umbrage_added(texel: vec2u) -> vec4u {
    let view_index = umbrage_prefilter_view.x;
    let origin = vec2u(umbrage_frame.views[view_index].tile_origin);
    let layer = umbrage_frame.views[view_index].layer;
    let stored = textureLoad(umbrage_depths, origin + texel, layer, 0);
    let depth = clamp(umbrage_linear_depth(view_index, vec2f(texel) + 0.5, stored), 0.0, 1.0);
    let moments = clamp(umbrage_moments_of(depth, vec2f(0.0)), vec4f(0.0), vec4f(1.0));
    return vec4u(round(moments * UMBRAGE_SUM_SCALE));
}

/// What the lanes before this one summed.
fn umbrage_before(lane: u32, own: vec4u) -> vec4u {
    stretches[lane] = own;
    workgroupBarrier();
    var before = vec4u(0u);
    for (var i = 0u; i < lane; i++) {
        before += stretches[i];
    }
    return before;
}

@compute @workgroup_size(LANES)
fn rows(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let side = u32(umbrage_frame.views[umbrage_prefilter_view.x].tile_size);
    let stretch = (side + LANES - 1u) / LANES;
    let start = min(lane * stretch, side);
    let end = min(start + stretch, side);
    var own = vec4u(0u);
    for (var x = start; x < end; x++) {
        own += umbrage_added(vec2u(x, group.x));
    }
    var sum = umbrage_before(lane, own);
    for (var x = start; x < end; x++) {
        sum += umbrage_added(vec2u(x, group.x));
        textureStore(umbrage_rows, vec2u(x, group.x), sum);
    }
}

@compute @workgroup_size(LANES)
fn columns(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let side = u32(umbrage_frame.views[umbrage_prefilter_view.x].tile_size);
    let origin = vec2u(umbrage_frame.views[umbrage_prefilter_view.x].tile_origin);
    let stretch = (side + LANES - 1u) / LANES;
    let start = min(lane * stretch, side);
    let end = min(start + stretch, side);
    var own = vec4u(0u);
    for (var y = start; y < end; y++) {
        own += textureLoad(umbrage_summed_rows, vec2u(group.x, y), 0);
    }
    var sum = umbrage_before(lane, own);
    for (var y = start; y < end; y++) {
        sum += textureLoad(umbrage_summed_rows, vec2u(group.x, y), 0);
        textureStore(umbrage_sums, origin + vec2u(group.x, y), sum);
    }
}
