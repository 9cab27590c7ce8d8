// One texel, compared by the sampler. OpenGL loads no depths.

import package::receiver::lookup::UmbrageLookup;
import package::sampling::compare_depth::umbrage_compare_depth;
import package::storage::compared::umbrage_lit_share;
import package::storage::map::umbrage_inside;

/// Whether the texel around `centre` leaves a receiver lit: 1 or 0. It is compared with the depth at its centre.
fn umbrage_lit(lookup: UmbrageLookup, centre: vec2f) -> f32 {
    // The texel's centre: samplers round coordinates to fewer bits than f32 has.
    let inside = umbrage_inside(lookup.view_index, centre);
    return umbrage_lit_share(lookup.view_index, inside, umbrage_compare_depth(lookup, inside));
}
