// A receiver's view is the one whose slice holds its view depth: half-open, [C_i, C_i+1).

import package::frame::umbrage_frame;

/// The view of a light that serves a receiver.
fn umbrage_select(light: u32, depth: f32, world_position: vec3f, world_normal: vec3f) -> u32 {
    let first = umbrage_frame.lights[light].first_view;
    var split = 0u;
    for (var i = 0u; i + 1u < umbrage_frame.lights[light].view_count; i++) {
        split += u32(depth >= umbrage_frame.views[first + i].depth_end);
    }
    return first + split;
}
