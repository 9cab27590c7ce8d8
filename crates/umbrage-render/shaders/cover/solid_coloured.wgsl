// The fragment shader of solid surfaces whose vertices have colours. It needs what `solid.wgsl` needs, and `coloured.wgsl`.

@fragment
fn shade(receiver: Receiver, @location(3) colour: vec4f, samples: Samples) -> @location(0) vec4f {
    asked_from_eye = place_of(receiver.from_eye, samples);
    let base = base_colour(receiver.uv).rgb * colour.rgb;
    return shown(base, receiver, geometric_normal(receiver.from_eye));
}
