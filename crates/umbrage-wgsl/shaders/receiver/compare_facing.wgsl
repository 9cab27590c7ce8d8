// Every texel is compared with the depth there of a plane through the receiver that faces the light. Under a sun without
// a warp that is the receiver's own depth; where a warp or a cone scales depth from texel to texel, it is what stays.

import package::receiver::texel_basis::{UmbrageTexelBasis, umbrage_slope};

/// How much the depth to compare with grows from a texel to the next, to the right and downward.
fn umbrage_gradient(texel_basis: UmbrageTexelBasis, slope: vec2f, to_light: vec3f) -> vec2f {
    return umbrage_slope(texel_basis, to_light, 1.0);
}

/// How far along its normal a receiver's plane must be moved to lie before all of itself within a texel, metres.
fn umbrage_normal_offset(texel_basis: UmbrageTexelBasis, world_normal: vec3f, to_light: vec3f) -> f32 {
    return abs(dot(world_normal, texel_basis.right)) + abs(dot(world_normal, texel_basis.down));
}
