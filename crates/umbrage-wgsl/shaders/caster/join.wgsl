// From the first two surfaces that the light meets to the one depth that is stored. Where there is no second one, it is taken to
// lie twice the limit behind the first. Casters before the near plane are flattened onto it, both surfaces at once, and then
// the second is not theirs: all that the view shows is in their shadow.

import chosen::umbrage_joined;
import package::caster::whole_tile::umbrage_whole_tile;
import package::current_view::umbrage_current_view;
import package::frame::umbrage_frame;
import package::light::umbrage_stored_a_metre;
import package::linear_depth::{umbrage_depth_scale, umbrage_linear_depth};

@group(0) @binding(2) var umbrage_first: texture_depth_2d_array;
@group(0) @binding(3) var umbrage_second: texture_depth_2d_array;

/// A triangle over the whole tile.
@vertex
fn everywhere(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return umbrage_whole_tile(index, 0.0);
}

@fragment
fn join(@builtin(position) position: vec4f) -> @builtin(frag_depth) f32 {
    let view_index = umbrage_current_view.x;
    let layer = i32(umbrage_frame.views[view_index].tile.w);
    let first = textureLoad(umbrage_first, vec2i(position.xy), layer, 0);
    // Nothing is there, or a caster before the near plane.
    if first <= 0.0 || first >= 1.0 {
        return first;
    }
    let second = textureLoad(umbrage_second, vec2i(position.xy), layer, 0);
    let texel = position.xy - umbrage_frame.views[view_index].tile.xy;
    let linear = umbrage_linear_depth(view_index, texel, first);
    let scale = umbrage_depth_scale(view_index, texel);
    let limit = umbrage_frame.depth_layer_limit * umbrage_stored_a_metre(view_index, linear, scale);
    return max(umbrage_joined(first, select(second, first - 2.0 * limit, second <= 0.0), limit), 0.0);
}
