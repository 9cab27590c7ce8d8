// Four texels at once are compared with the receiver's own depth, as it is stored.

import package::receiver::texel_basis::UmbrageTexelBasis;

/// How much the depth to compare with grows from a texel to the next: not at all.
fn umbrage_gradient(texel_basis: UmbrageTexelBasis, slope: vec2f, to_light: vec3f) -> vec2f {
    return vec2f(0.0);
}

/// How far along its normal a receiver's plane must be moved so that no depth stored within a texel lies before it, metres.
fn umbrage_normal_offset(texel_basis: UmbrageTexelBasis, world_normal: vec3f, to_light: vec3f) -> f32 {
    let right = dot(world_normal, cross(texel_basis.depth_gradient, texel_basis.down_gradient));
    let down = dot(world_normal, cross(texel_basis.right_gradient, texel_basis.depth_gradient));
    let rise = dot(texel_basis.depth_gradient, to_light);
    let across = length(cross(texel_basis.right_gradient, texel_basis.down_gradient));
    return (abs(right) + abs(down)) / max(across * rise, 1.1754944e-38);
}
