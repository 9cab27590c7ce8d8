// The fragment shader of depth passes, for surfaces that are cut out where they cover nothing. It needs `material.wgsl`,
// `coloured.wgsl` and `edge_exact.wgsl`.

@fragment
fn cut_depth(receiver: Receiver, @location(3) colour: vec4f) {
    if edge_coverage(cut_colour(receiver.uv).a * colour.a) <= 0.0 {
        discard;
    }
}
