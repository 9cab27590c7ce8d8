// The fragment shader of surfaces that are cut out where they cover nothing. It needs `material.wgsl`, `coloured.wgsl`, `shown`,
// and a file `edge_*.wgsl`.

@fragment
fn shade(receiver: Receiver, @location(3) colour: vec4f, samples: Samples) -> @location(0) vec4f {
    asked_from_eye = place_of(receiver.from_eye, samples);
    let facing = geometric_normal(receiver.from_eye);
    let cut = cut_colour(receiver.uv, colour);
    let seen = shown(cut.rgb, receiver, facing);
    if cut.a <= 0.0 {
        discard;
    }
    return vec4f(seen.rgb, cut.a);
}
