// The same of surfaces that are cut out where they cover nothing. It needs `place.wgsl`, `material.wgsl` and `coloured.wgsl`.

@fragment
fn cut_place(receiver: Receiver, @location(3) colour: vec4f) -> @location(0) vec4u {
    let seen = place_of(receiver);
    if coverage(exact_alpha(receiver.uv) * colour.a) < 0.5 {
        discard;
    }
    return seen;
}
