// A receiver's view is the one whose slice holds its view depth: half-open, [C_i, C_i+1).

import package::frame::umbrage_frame;
import package::light::{umbrage_face, umbrage_has_faces};
import package::receiver::lookup::{UmbrageLookup, umbrage_lookup};

/// Where a receiver looks in the view of a light that serves it.
fn umbrage_select(light: u32, depth: f32, world_position: vec3f, world_normal: vec3f) -> UmbrageLookup {
    let first = umbrage_frame.lights[light].first_view;
    var split = 0u;
    for (var i = 0u; i + 1u < umbrage_frame.lights[light].view_count; i++) {
        split += u32(depth >= umbrage_frame.views[first + i].depth_end);
    }
    if umbrage_has_faces(light) {
        split = umbrage_face(light, world_position);
    }
    return umbrage_lookup(first + split, light, world_position, world_normal);
}
