// Every texel is compared with the depth that the receiver's plane has at the texel's centre: a flat receiver agrees with
// what it has drawn itself, whatever its slope, in any view: what is flat in the world is flat in the map.

import package::receiver::texel_basis::UmbrageTexelBasis;

/// How much the depth to compare with grows from a texel to the next, to the right and downward. `slope` is that of the
/// receiver's plane.
fn umbrage_gradient(texel_basis: UmbrageTexelBasis, slope: vec2f, to_light: vec3f) -> vec2f {
    return slope;
}

/// How far along its normal a receiver's plane must be moved to lie before all of itself within a texel, metres.
fn umbrage_normal_offset(texel_basis: UmbrageTexelBasis, world_normal: vec3f, to_light: vec3f) -> f32 {
    return abs(dot(world_normal, texel_basis.right)) + abs(dot(world_normal, texel_basis.down));
}
