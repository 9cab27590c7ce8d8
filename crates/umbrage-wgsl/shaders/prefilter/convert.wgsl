// From depths to moments: every texel of moments is the mean of UMBRAGE_DOWNSAMPLE² depths.

import constants::UMBRAGE_DOWNSAMPLE;
import chosen::{umbrage_moments_add, umbrage_moments_none, umbrage_moments_of, umbrage_stored};
import package::current_view::umbrage_current_view;
import package::frame::umbrage_frame;
import package::linear_depth::umbrage_linear_depth;
import package::prefilter::depths::umbrage_drawn_depth;

@group(0) @binding(3) var umbrage_converted: texture_storage_2d<UMBRAGE_FORMAT, write>;

/// The linear depth of a texel of the tile, counted from its upper left corner; the outermost one's outside.
fn umbrage_depth_at(texel: vec2i) -> f32 {
    let view_index = umbrage_current_view.x;
    let last = i32(umbrage_frame.views[view_index].tile.z) - 1;
    let inside = clamp(texel, vec2i(0), vec2i(last));
    return umbrage_linear_depth(view_index, vec2f(inside) + 0.5, umbrage_drawn_depth(inside));
}

/// The smaller of two in size: of a step before and one behind, the one that crosses no edge.
fn umbrage_lesser(a: f32, b: f32) -> f32 {
    return select(b, a, abs(a) < abs(b));
}

@compute @workgroup_size(8, 8)
fn convert(@builtin(global_invocation_id) id: vec3u) {
    let view_index = umbrage_current_view.x;
    let side = u32(umbrage_frame.views[view_index].tile.z) / UMBRAGE_DOWNSAMPLE;
    if any(id.xy >= vec2u(side)) {
        return;
    }
    var sum = umbrage_moments_none();
    for (var i = 0u; i < UMBRAGE_DOWNSAMPLE * UMBRAGE_DOWNSAMPLE; i++) {
        let texel = vec2i(id.xy * UMBRAGE_DOWNSAMPLE + vec2u(i % UMBRAGE_DOWNSAMPLE, i / UMBRAGE_DOWNSAMPLE));
        let depth = umbrage_depth_at(texel);
        let right = umbrage_lesser(
            umbrage_depth_at(texel + vec2i(1, 0)) - depth, depth - umbrage_depth_at(texel - vec2i(1, 0)));
        let down = umbrage_lesser(
            umbrage_depth_at(texel + vec2i(0, 1)) - depth, depth - umbrage_depth_at(texel - vec2i(0, 1)));
        let moments = umbrage_moments_of(depth, vec2f(right, down));
        sum = umbrage_moments_add(sum, moments, 1.0 / f32(UMBRAGE_DOWNSAMPLE * UMBRAGE_DOWNSAMPLE));
    }
    let origin = vec2u(umbrage_frame.views[view_index].tile.xy) / UMBRAGE_DOWNSAMPLE;
    textureStore(umbrage_converted, origin + id.xy, umbrage_stored(sum));
}
