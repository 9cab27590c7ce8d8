// Whether the texels around a receiver agree.
//
// Sixteen texels are asked: those that a bilinear lookup weighs, and their neighbours, since an edge may lie anywhere within a
// texel. One is for light that stores no more than the receiver's plane and a share of its bias, and for shadow that stores more
// than the plane and all of it. What lies between may be the receiver itself or something that touches it: it decides nothing.

import package::exact::not_known::UMBRAGE_UNDECIDED;
import package::receiver::lookup::{UMBRAGE_OWN_TEXEL, UmbrageLookup};
import package::storage::gathered::umbrage_stored_around;
import package::storage::map::umbrage_tile_size;

/// The share of the bias up to which a texel is for light: less asks for rays on every bent surface, more takes contacts for light.
const UMBRAGE_LIT_BIAS: f32 = 0.5;

/// Which of four texels are for light, or for shadow.
struct UmbrageVotes {
    lit: bool,
    dark: bool,
}

/// The votes of the four texels around a corner of texels.
fn umbrage_votes(lookup: UmbrageLookup, corner: vec2f) -> UmbrageVotes {
    let inside = clamp(corner, vec2f(1.0), vec2f(umbrage_tile_size(lookup.view_index) - 1.0));
    let right = inside.x + vec4f(-0.5, 0.5, 0.5, -0.5) - lookup.texel.x;
    let down = inside.y + vec4f(0.5, 0.5, -0.5, -0.5) - lookup.texel.y;
    let stored = umbrage_stored_around(lookup.view_index, inside);
    let biased = lookup.compare_depth + lookup.gradient.x * right + lookup.gradient.y * down;
    let bent = lookup.bend * max(max(abs(right), abs(down)) - UMBRAGE_OWN_TEXEL, vec4f(0.0));
    let lit = stored <= biased + bent - (1.0 - UMBRAGE_LIT_BIAS) * (lookup.bias + bent);
    let dark = stored > biased + bent;
    return UmbrageVotes(all(lit), all(dark));
}

/// 1 where the map is sure that a receiver is lit, and for one that it does not hold; 0 where it is sure that it is not lit; and
/// otherwise UMBRAGE_UNDECIDED.
fn umbrage_decided(lookup: UmbrageLookup) -> f32 {
    let low = floor(lookup.texel - 0.5);
    let a = umbrage_votes(lookup, low);
    let b = umbrage_votes(lookup, low + vec2f(2.0, 0.0));
    let c = umbrage_votes(lookup, low + vec2f(0.0, 2.0));
    let d = umbrage_votes(lookup, low + vec2f(2.0));
    let lit = a.lit && b.lit && c.lit && d.lit;
    let dark = a.dark && b.dark && c.dark && d.dark;
    let outside = lookup.compare_depth < 0.0 || any(lookup.texel < vec2f(0.0))
        || any(lookup.texel > vec2f(umbrage_tile_size(lookup.view_index)));
    return select(select(UMBRAGE_UNDECIDED, 0.0, dark), 1.0, lit || outside);
}
