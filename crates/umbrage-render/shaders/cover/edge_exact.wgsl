// Edges where they are, whatever the distance: as a ray a pixel sees them. It needs `material.wgsl`.

/// The base colour of a place where the vertices have a colour, linear RGB; and 1 where the surface covers at least half of it, or 0.
fn cut_colour(uv: vec2f, colour: vec4f) -> vec4f {
    let texel = material.base_colour * textureSampleLevel(base_texture, base_sampler, uv, 0.0) * colour;
    return vec4f(texel.rgb, select(0.0, 1.0, coverage(texel.a) >= 0.5));
}
