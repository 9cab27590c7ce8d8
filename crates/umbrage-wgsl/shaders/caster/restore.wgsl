// What stands in a tile, from the maps of what stands: a triangle over all of it. What moves is drawn over it then.

import package::caster::whole_tile::umbrage_whole_tile;
import package::current_view::umbrage_current_view;
import package::frame::umbrage_frame;

@group(0) @binding(2) var umbrage_still: texture_depth_2d_array;

@vertex
fn everywhere(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return umbrage_whole_tile(index, 0.0);
}

@fragment
fn restore(@builtin(position) position: vec4f) -> @builtin(frag_depth) f32 {
    let layer = i32(umbrage_frame.views[umbrage_current_view.x].tile.w);
    return textureLoad(umbrage_still, vec2i(position.xy), layer, 0);
}
