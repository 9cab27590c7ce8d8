// Edges where they are, whatever the distance: for pictures that are compared with rays. It needs `material.wgsl`.

/// The base colour, linear RGBA, of the picture itself.
fn cut_colour(uv: vec2f) -> vec4f {
    return material.base_colour * textureSampleLevel(base_texture, base_sampler, uv, 0.0);
}

/// 1 where the surface covers at least half of its place, 0 elsewhere.
fn edge_coverage(alpha: f32) -> f32 {
    return select(0.0, 1.0, coverage(alpha) >= 0.5);
}
