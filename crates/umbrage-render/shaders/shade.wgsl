// The fragment shader of surfaces. It needs `material.wgsl`, `matte.wgsl` or `glossy.wgsl`, and `painted`, which says what is
// drawn onto them.

@fragment
fn shade(receiver: Receiver) -> @location(0) vec4f {
    let facing = geometric_normal(receiver.from_eye);
    return seen_surface(painted(base_colour(receiver), receiver, facing), receiver, facing);
}
