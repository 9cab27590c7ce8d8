// Edges of masks as pixels of several samples have them. Near by that is an edge of one pixel across the picture's own alpha;
// where the picture is smaller than its texels, its levels hold the share that is covered. It needs `material.wgsl`.

/// The base colour of a place where the vertices have a colour, linear RGB; and the share of the pixel that the surface covers.
fn cut_colour(uv: vec2f, colour: vec4f) -> vec4f {
    let texel = textureSample(base_texture, base_sampler, uv);
    let alpha = exact_alpha(uv) * colour.a;
    let sharp = clamp((alpha - material.cutoff) / max(fwidth(alpha), 1e-3) + 0.5, 0.0, 1.0);
    let far = select(0.0, texel.a, material.base_colour.a * colour.a >= material.cutoff);
    let texels = vec2f(textureDimensions(base_texture));
    let step = max(length(dpdx(uv) * texels), length(dpdy(uv) * texels));
    let level = clamp(log2(max(step, 1e-6)), 0.0, 1.0);
    return vec4f(material.base_colour.rgb * texel.rgb * colour.rgb, mix(sharp, far, level));
}
