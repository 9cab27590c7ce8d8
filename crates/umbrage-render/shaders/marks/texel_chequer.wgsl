// Surfaces with the texels of the first light's maps as a chequer. It needs `scene.wgsl`, `receiver.wgsl`, umbrage's receiver
// text, `split_colour.wgsl` and `footprint.wgsl`.

/// A chequer of the map's texels, dark and light. Where texels are about as small as pixels it fades to its mean: what
/// remains would only be a moiré.
fn texel_chequer(texel: vec2f, footprint: mat2x2f) -> f32 {
    let texels_a_pixel = abs(footprint[0]) + abs(footprint[1]);
    let cell = (i32(floor(texel.x)) + i32(floor(texel.y))) & 1;
    let clear = 1.0 - smoothstep(0.25, 1.0, max(texels_a_pixel.x, texels_a_pixel.y));
    return mix(0.5, f32(cell), clear);
}

fn painted(base: vec3f, receiver: Receiver, facing: vec3f) -> vec3f {
    let world = scene.eye + receiver.from_eye;
    let view = umbrage_view_of(0u, world, facing);
    if view == UMBRAGE_NO_VIEW {
        return base;
    }
    // Where the receiver is, not where it looks: a bias may look beside.
    let clip = umbrage_clip_from_local(view) * vec4f(umbrage_local(view, world), 1.0);
    let texel = (clip.xy / clip.w * vec2f(0.5, -0.5) + 0.5) * umbrage_frame.views[view].tile.z;
    let tint = split_colour(view - umbrage_frame.lights[0].first_view);
    return mix(mix(base, tint, 0.35) * 0.35, mix(base, vec3f(0.9), 0.6), texel_chequer(texel, footprint_of(view, receiver, facing)));
}
