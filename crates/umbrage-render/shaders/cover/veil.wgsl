// The fragment shader of surfaces that are blended over what lies behind them. It needs `material.wgsl`, `coloured.wgsl` and
// `shown`.

@fragment
fn shade(receiver: Receiver, @location(3) colour: vec4f, samples: Samples) -> @location(0) vec4f {
    asked_from_eye = place_of(receiver.from_eye, samples);
    let base = base_colour(receiver.uv) * colour;
    return vec4f(shown(base.rgb, receiver, geometric_normal(receiver.from_eye)).rgb, coverage(base.a));
}
