// What one view says of a receiver.

import chosen::umbrage_filter;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver, umbrage_lookup};
import package::storage::map::umbrage_tile_size;

/// What a view says of a receiver that looks there: 1 for lit. Points outside the map are lit.
fn umbrage_read(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let tile_size = umbrage_tile_size(lookup.view_index);
    let outside =
        any(lookup.texel < vec2f(0.0)) || any(lookup.texel > vec2f(tile_size)) || lookup.compare_depth < 0.0;
    if outside {
        return 1.0;
    }
    return umbrage_filter(lookup, receiver);
}

/// What any view of a light says of a receiver.
fn umbrage_visibility_in(view_index: u32, light: u32, receiver: UmbrageReceiver) -> f32 {
    return umbrage_read(umbrage_lookup(view_index, light, receiver.position, receiver.normal), receiver);
}
