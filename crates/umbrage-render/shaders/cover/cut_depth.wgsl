// The fragment shader of depth passes, for surfaces that are cut out where they cover nothing. It needs `material.wgsl` and
// `coloured.wgsl`.

@fragment
fn cut_depth(receiver: Receiver, @location(3) colour: vec4f) {
    if coverage(exact_alpha(receiver.uv) * colour.a) < 0.5 {
        discard;
    }
}
