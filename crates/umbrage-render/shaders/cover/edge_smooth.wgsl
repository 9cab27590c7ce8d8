// Edges of masks as pixels of several samples have them: alpha says how many are covered, over one pixel. It needs
// `material.wgsl`.

/// The base colour, linear RGBA.
fn cut_colour(uv: vec2f) -> vec4f {
    return base_colour(uv);
}

/// The share of a pixel that the surface covers.
fn edge_coverage(alpha: f32) -> f32 {
    return clamp((alpha - material.cutoff) / max(fwidth(alpha), 1e-3) + 0.5, 0.0, 1.0);
}
