// Stored depths as numbers. They have a file of their own, since OpenGL takes no text that loads depths.

import package::storage::map::{umbrage_address_around, umbrage_layer, umbrage_map};

/// The depth that is stored in the texel around a place of a tile.
fn umbrage_stored_depth(view_index: u32, texel: vec2f) -> f32 {
    let address = umbrage_address_around(view_index, texel);
    return textureLoad(umbrage_map, address, umbrage_layer(view_index), 0);
}
