// A Gaussian over the texels of a row, and then over those of a column.

import constants::{UMBRAGE_BLUR, UMBRAGE_DOWNSAMPLE, UMBRAGE_WEIGHTS};
import chosen::{umbrage_moments_add, umbrage_moments_none, umbrage_stored};
import package::current_view::umbrage_current_view;
import package::frame::umbrage_frame;

@group(0) @binding(2) var umbrage_sharp: texture_2d<f32>;
@group(0) @binding(3) var umbrage_blurred: texture_storage_2d<UMBRAGE_FORMAT, write>;

/// The weighted sum over texels along `step`, of a square of `side` texels at `origin`; its outermost texels go on outside.
fn umbrage_blur(origin: vec2i, texel: vec2i, side: i32, step: vec2i) -> vec4f {
    var weights = UMBRAGE_WEIGHTS;
    var sum = umbrage_moments_none();
    for (var i = -UMBRAGE_BLUR; i <= UMBRAGE_BLUR; i++) {
        let inside = clamp(texel + step * i, vec2i(0), vec2i(side - 1));
        sum = umbrage_moments_add(sum, textureLoad(umbrage_sharp, origin + inside, 0), weights[abs(i)]);
    }
    return sum;
}

/// A view's square of moments: its first texel, and texels a side.
struct UmbrageSquare {
    origin: vec2i,
    side: i32,
}

fn umbrage_square() -> UmbrageSquare {
    let view_index = umbrage_current_view.x;
    let origin = vec2i(umbrage_frame.views[view_index].tile.xy);
    let side = i32(umbrage_frame.views[view_index].tile.z);
    return UmbrageSquare(origin / i32(UMBRAGE_DOWNSAMPLE), side / i32(UMBRAGE_DOWNSAMPLE));
}

@compute @workgroup_size(64)
fn across(@builtin(global_invocation_id) id: vec3u) {
    let square = umbrage_square();
    let texel = vec2i(id.xy);
    if any(texel >= vec2i(square.side)) {
        return;
    }
    let blurred = umbrage_blur(square.origin, texel, square.side, vec2i(1, 0));
    textureStore(umbrage_blurred, texel, umbrage_stored(blurred));
}

@compute @workgroup_size(64)
fn down(@builtin(global_invocation_id) id: vec3u) {
    let square = umbrage_square();
    let texel = vec2i(id.xy);
    if any(texel >= vec2i(square.side)) {
        return;
    }
    let blurred = umbrage_blur(vec2i(0), texel, square.side, vec2i(0, 1));
    textureStore(umbrage_blurred, square.origin + texel, umbrage_stored(blurred));
}
