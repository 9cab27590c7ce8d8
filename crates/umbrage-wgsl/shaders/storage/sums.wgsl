// A summed-area table of moments, in whole numbers.

import package::receiver::lookup::UmbrageLookup;
import package::storage::map::{umbrage_address, umbrage_layer, umbrage_tile_size};

@group(0) @binding(3) var umbrage_sums: texture_2d_array<u32>;

/// The sum up to and with a texel of the tile, counted from its upper left corner; nothing before the tile.
fn umbrage_sum(lookup: UmbrageLookup, place: vec2i) -> vec4u {
    if any(place < vec2i(0)) {
        return vec4u(0u);
    }
    let last = i32(umbrage_tile_size(lookup.view_index)) - 1;
    let address = umbrage_address(lookup.view_index, min(place, vec2i(last)));
    return textureLoad(umbrage_sums, address, umbrage_layer(lookup.view_index), 0);
}
