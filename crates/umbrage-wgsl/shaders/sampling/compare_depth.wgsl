// The depth that a texel beside a receiver is compared with.

import package::receiver::lookup::{UMBRAGE_OWN_TEXEL, UmbrageLookup};

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

/// As `umbrage_compare_depth`, at four places.
fn umbrage_compare_depths(lookup: UmbrageLookup, x: vec4f, y: vec4f) -> vec4f {
    let right = x - lookup.texel.x;
    let down = y - lookup.texel.y;
    let bent = lookup.bend * max(max(abs(right), abs(down)) - UMBRAGE_OWN_TEXEL, vec4f(0.0));
    let plane = lookup.compare_depth + lookup.gradient.x * right + lookup.gradient.y * down;
    return clamp(plane + bent, vec4f(0.0), vec4f(max(lookup.compare_depth, UMBRAGE_NEAREST_COMPARED)));
}
