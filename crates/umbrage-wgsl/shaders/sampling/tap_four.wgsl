// A comparison is bilinear: the sampler's, with one depth for four texels.

import package::receiver::lookup::UmbrageLookup;
import package::storage::compared::umbrage_lit_share;

/// How much a place beside the receiver leaves it lit; `offset` is in texels.
fn umbrage_tap(lookup: UmbrageLookup, offset: vec2f) -> f32 {
    return umbrage_lit_share(lookup.view_index, lookup.texel + offset, lookup.compare_depth);
}
