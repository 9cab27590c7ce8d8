// One texel, compared here: a sampler would compare four to weigh one.

import package::receiver::lookup::UmbrageLookup;
import package::sampling::compare_depth::umbrage_compare_depth;
import package::storage::map::umbrage_inside;
import package::storage::stored_depth::umbrage_stored_depth;

/// Whether the texel around `centre` leaves a receiver lit: 1 or 0. It is compared with the depth at its centre.
fn umbrage_lit(lookup: UmbrageLookup, centre: vec2f) -> f32 {
    let inside = umbrage_inside(lookup.view_index, centre);
    let is_lit = umbrage_compare_depth(lookup, inside) >= umbrage_stored_depth(lookup.view_index, inside);
    return select(0.0, 1.0, is_lit);
}
