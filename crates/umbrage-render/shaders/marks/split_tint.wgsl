// Receivers with a tint of the view that serves them, for the first light. It needs `material.wgsl`, `surface.wgsl` and
// `split_colour.wgsl`.

fn tinted(base: vec3f, receiver: Receiver, facing: vec3f) -> vec3f {
    let view = umbrage_view_of(0u, scene.eye + receiver.from_eye, facing);
    if view == UMBRAGE_NO_VIEW {
        return base;
    }
    return mix(base, split_colour(view - umbrage_frame.lights[0].first_view), 0.6);
}

@fragment
fn shade(receiver: Receiver) -> @location(0) vec4f {
    let texture = textureSample(base_texture, base_sampler, receiver.uv);
    let facing = geometric_normal(receiver.from_eye);
    return seen_surface(tinted(base_colour.rgb * texture.rgb, receiver, facing), receiver, facing);
}
