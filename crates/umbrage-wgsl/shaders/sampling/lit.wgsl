// One texel, compared by itself.

import package::receiver::lookup::{UMBRAGE_OWN_TEXEL, UmbrageLookup};
import package::storage::map::{umbrage_inside, umbrage_lit_share};

/// No receiver is nearer than this. A steep plane may be, a texel beside its receiver; casters that were flattened onto the
/// near plane count as before it there.
const UMBRAGE_NEAREST_COMPARED: f32 = 0.9999;

/// The depth to compare with at a place of the tile, given in texels: that of the lookup's plane there, bent toward the light
/// the more the farther it is. Nothing that is stored lies beyond 0.
fn umbrage_compare_depth(lookup: UmbrageLookup, texel: vec2f) -> f32 {
    let beside = texel - lookup.texel;
    let bent = lookup.bend * max(max(abs(beside.x), abs(beside.y)) - UMBRAGE_OWN_TEXEL, 0.0);
    let plane = lookup.compare_depth + dot(lookup.gradient, beside);
    return clamp(plane + bent, 0.0, max(lookup.compare_depth, UMBRAGE_NEAREST_COMPARED));
}

/// Whether the texel around `centre` leaves a receiver lit: 1 or 0. It is compared with the depth at its centre.
fn umbrage_lit(lookup: UmbrageLookup, centre: vec2f) -> f32 {
    // The texel's centre: samplers round coordinates to fewer bits than f32 has. Not a load, which GL has not for depth.
    let inside = umbrage_inside(lookup.view_index, centre);
    return umbrage_lit_share(lookup.view_index, inside, umbrage_compare_depth(lookup, inside));
}
