// Casters that do not cover all of their place: where that is, their base colour's alpha says. It needs `caster.wgsl`,
// `material.wgsl`.

struct CutCaster {
    @builtin(position) clip: vec4f,
    @location(0) uv: vec2f,
    /// The alpha of the vertices' colours.
    @location(1) alpha: f32,
    /// Tells triangles apart.
    @location(2) @interpolate(flat, first) id: u32,
}

@vertex
fn cut_caster(
    @location(0) position: vec3f,
    @location(2) uv: vec2f,
    @location(3) instance: u32,
    @location(4) colour: vec4f,
    @builtin(vertex_index) vertex: u32,
) -> CutCaster {
    return CutCaster(caster_position(position, instance), uv, colour.a, vertex ^ (instance * 2654435761u));
}

/// Where a mask leaves its place open, nothing is drawn.
@fragment
fn cut_out(caster: CutCaster) {
    umbrage_caster_fragment(caster.clip);
    if coverage(exact_alpha(caster.uv) * caster.alpha) < 0.5 {
        discard;
    }
}

/// Glass is drawn into as many texels as it covers.
@fragment
fn dither(caster: CutCaster) {
    umbrage_caster_fragment(caster.clip);
    if !umbrage_caster_covers(caster.clip, caster.id, coverage(exact_alpha(caster.uv) * caster.alpha)) {
        discard;
    }
}
