// A receiver's view is the finest one whose map holds the whole footprint of the filter, whatever its slice.

import constants::UMBRAGE_FILTER_REACH;
import package::frame::umbrage_frame;
import package::receiver::no_view::UMBRAGE_NO_VIEW;
import package::receiver::lookup::umbrage_lookup;
import package::storage::map::umbrage_tile_size;

/// The view of a light that serves a receiver.
fn umbrage_select(light: u32, depth: f32, world_position: vec3f, world_normal: vec3f) -> u32 {
    return umbrage_finest(light, umbrage_frame.lights[light].first_view, world_position, world_normal);
}

/// The first view of a light, from `start` on, that holds a receiver.
fn umbrage_finest(light: u32, start: u32, world_position: vec3f, world_normal: vec3f) -> u32 {
    let end = umbrage_frame.lights[light].first_view + umbrage_frame.lights[light].view_count;
    for (var i = start; i < end; i++) {
        let lookup = umbrage_lookup(i, light, world_position, world_normal);
        let tile_size = umbrage_tile_size(i);
        let low = vec2f(UMBRAGE_FILTER_REACH);
        let inside = all(lookup.texel >= low) && all(lookup.texel <= vec2f(tile_size) - low);
        if inside && lookup.compare_depth <= 1.0 && lookup.compare_depth >= 0.0 {
            return i;
        }
    }
    return UMBRAGE_NO_VIEW;
}
