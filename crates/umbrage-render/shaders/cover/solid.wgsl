// The fragment shader of solid surfaces. It needs `material.wgsl` and `shown`, which says what the screen shows of a surface.

@fragment
fn shade(receiver: Receiver) -> @location(0) vec4f {
    return shown(base_colour(receiver.uv).rgb, receiver, geometric_normal(receiver.from_eye));
}
