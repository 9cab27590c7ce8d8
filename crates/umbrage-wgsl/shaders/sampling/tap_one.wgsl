// A comparison is that of one texel, with the depth of a plane at its centre.

import chosen::umbrage_lit;
import package::receiver::lookup::UmbrageLookup;

/// How much a place beside the receiver leaves it lit; `offset` is in texels.
fn umbrage_tap(lookup: UmbrageLookup, offset: vec2f) -> f32 {
    return umbrage_lit(lookup, floor(lookup.texel + offset) + 0.5);
}
