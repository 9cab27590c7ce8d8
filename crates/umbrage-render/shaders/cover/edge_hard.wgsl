// Edges as a pixel of one sample has them: its mip level covers as much as the picture does. It needs `material.wgsl`.

/// The base colour, linear RGBA.
fn cut_colour(uv: vec2f) -> vec4f {
    return base_colour(uv);
}

/// 1 where the surface covers at least half of its place, 0 elsewhere.
fn edge_coverage(alpha: f32) -> f32 {
    return select(0.0, 1.0, coverage(alpha) >= 0.5);
}
