// The depths that were drawn, for the steps that make something else of them.

import package::current_view::umbrage_current_view;
import package::frame::umbrage_frame;

@group(0) @binding(2) var umbrage_depths: texture_depth_2d_array;

/// The depth that was drawn at a texel of the current view's tile, counted from its upper left corner.
fn umbrage_drawn_depth(texel: vec2i) -> f32 {
    let view_index = umbrage_current_view.x;
    let origin = vec2i(umbrage_frame.views[view_index].tile.xy);
    return textureLoad(umbrage_depths, origin + texel, i32(umbrage_frame.views[view_index].tile.w), 0);
}
