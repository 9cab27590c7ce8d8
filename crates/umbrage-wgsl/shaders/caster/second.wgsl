// The second surface that the light meets: what does not lie behind the first is left out (depth peeling, Everitt 2001).

import package::current_view::umbrage_current_view;
import package::frame::umbrage_frame;
import package::light::umbrage_depth_rounding;

@group(0) @binding(2) var umbrage_first: texture_depth_2d_array;

/// A caster's fragment shader calls it with its position. It discards, after which derivatives and samples hold as before.
fn umbrage_caster_fragment(position: vec4f) {
    let layer = i32(umbrage_frame.views[umbrage_current_view.x].tile.w);
    let first = textureLoad(umbrage_first, vec2i(position.xy), layer, 0);
    // The same surface, drawn again, may round otherwise.
    if position.z >= first - 2.0 * umbrage_depth_rounding(umbrage_current_view.x, first) {
        discard;
    }
}
