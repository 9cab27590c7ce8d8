// Which view serves a receiver.

import chosen::umbrage_select;
import package::frame::umbrage_frame;
import package::receiver::lookup::UmbrageLookup;
import package::receiver::no_view::UMBRAGE_NO_VIEW;

/// View depth of a point, metres from the eye.
fn umbrage_view_depth(world_position: vec3f) -> f32 {
    return dot(umbrage_frame.depth_row, vec4f(world_position, 1.0));
}

/// Where a receiver looks in the view that serves it; the view is UMBRAGE_NO_VIEW where none does. `world_normal` is the unit
/// geometric normal.
fn umbrage_lookup_of(light: u32, world_position: vec3f, world_normal: vec3f) -> UmbrageLookup {
    let depth = umbrage_view_depth(world_position);
    var lookup: UmbrageLookup;
    lookup.view_index = UMBRAGE_NO_VIEW;
    if light < umbrage_frame.light_count && depth <= umbrage_frame.shadow_end {
        lookup = umbrage_select(light, depth, world_position, world_normal);
    }
    return lookup;
}

/// Index of the view that serves a receiver, or UMBRAGE_NO_VIEW.
fn umbrage_view_of(light: u32, world_position: vec3f, world_normal: vec3f) -> u32 {
    return umbrage_lookup_of(light, world_position, world_normal).view_index;
}
