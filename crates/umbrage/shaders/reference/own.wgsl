// Four texels at once are compared with the receiver's own depth, as it is stored.

/// How much the depth to compare with grows from a texel to the next: not at all.
fn umbrage_gradient(footing: UmbrageFooting, world_normal: vec3f, to_light: vec3f) -> vec2f {
    return vec2f(0.0);
}

/// How far along its normal a receiver's plane must be moved so that no depth stored within a texel lies before it, metres.
fn umbrage_lift(footing: UmbrageFooting, world_normal: vec3f, to_light: vec3f) -> f32 {
    let right = dot(world_normal, cross(footing.depth_gradient, footing.down_gradient));
    let down = dot(world_normal, cross(footing.right_gradient, footing.depth_gradient));
    let rise = -dot(footing.depth_gradient, to_light);
    let across = length(cross(footing.right_gradient, footing.down_gradient));
    return (abs(right) + abs(down)) / max(across * rise, 1.1754944e-38);
}
