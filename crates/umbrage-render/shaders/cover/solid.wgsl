// The fragment shader of solid surfaces. It needs `material.wgsl` and `shown`, which says what the screen shows of a surface.

@fragment
fn shade(receiver: Receiver, samples: Samples) -> @location(0) vec4f {
    asked_from_eye = place_of(receiver.from_eye, samples);
    return shown(base_colour(receiver.uv).rgb, receiver, geometric_normal(receiver.from_eye));
}
