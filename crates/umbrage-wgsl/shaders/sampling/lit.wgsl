// One texel, compared by itself.

import package::receiver::lookup::UmbrageLookup;
import package::storage::map::{umbrage_inside, umbrage_lit_share};

/// The depth to compare with at a place of the tile, given in texels: that of the lookup's plane there. Nothing that is
/// stored lies beyond 0.
fn umbrage_compare_depth(lookup: UmbrageLookup, texel: vec2f) -> f32 {
    return max(lookup.compare_depth + dot(lookup.gradient, texel - lookup.texel), 0.0);
}

/// Whether the texel around `centre` leaves a receiver lit: 1 or 0. It is compared with the depth at its centre.
fn umbrage_lit(lookup: UmbrageLookup, centre: vec2f) -> f32 {
    // The texel's centre: samplers round coordinates to fewer bits than f32 has. Not a load, which GL has not for depth.
    let inside = umbrage_inside(lookup.view_index, centre);
    return umbrage_lit_share(lookup.view_index, inside, umbrage_compare_depth(lookup, inside));
}
