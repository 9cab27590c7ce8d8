// A receiver's view is the finest one whose map holds the whole footprint of the filter, whatever its slice. Most views that do
// not are left out by a product with their matrix, and a receiver is looked up in what is left.

import constants::UMBRAGE_FILTER_REACH;
import package::frame::umbrage_frame;
import package::light::{umbrage_face, umbrage_has_faces};
import package::receiver::lookup::{UmbrageLookup, umbrage_lookup};
import package::receiver::no_view::UMBRAGE_NO_VIEW;
import package::storage::map::{umbrage_local, umbrage_may_hold, umbrage_tile_size};

/// Where a receiver looks in the view of a light that serves it; the view is UMBRAGE_NO_VIEW where none does.
fn umbrage_select(light: u32, depth: f32, world_position: vec3f, world_normal: vec3f) -> UmbrageLookup {
    var start = umbrage_frame.lights[light].first_view;
    if umbrage_has_faces(light) {
        start += umbrage_face(light, world_position);
    }
    return umbrage_finest(light, start, world_position, world_normal);
}

/// The same in the first view of a light, from `start` on, that holds a receiver. Of faces it is the first.
fn umbrage_finest(light: u32, start: u32, world_position: vec3f, world_normal: vec3f) -> UmbrageLookup {
    let end = umbrage_frame.lights[light].first_view + umbrage_frame.lights[light].view_count;
    let is_face = umbrage_has_faces(light);
    // A lookup that is moved along the normal may lie in a map that does not hold its receiver.
    let looks_in_all = is_face || umbrage_frame.bias_normal > 0.0;
    var lookup: UmbrageLookup;
    // Views of a light begin in the same place.
    let local = umbrage_local(start, world_position);
    var i = start;
    loop {
        while i < end && !looks_in_all && !umbrage_may_hold(i, local) {
            i++;
        }
        if i >= end {
            lookup.view_index = UMBRAGE_NO_VIEW;
            break;
        }
        lookup = umbrage_lookup(i, light, world_position, world_normal);
        if is_face || umbrage_holds(lookup) {
            break;
        }
        i++;
    }
    return lookup;
}

/// Whether a view's map holds the whole footprint of a filter that looks there.
fn umbrage_holds(lookup: UmbrageLookup) -> bool {
    let low = vec2f(UMBRAGE_FILTER_REACH);
    let high = vec2f(umbrage_tile_size(lookup.view_index)) - low;
    let inside = all(lookup.texel >= low) && all(lookup.texel <= high);
    return inside && lookup.compare_depth <= 1.0 && lookup.compare_depth >= 0.0;
}
