// Receivers as they are. It needs `material.wgsl` and `surface.wgsl`.

@fragment
fn shade(receiver: Receiver) -> @location(0) vec4f {
    let texture = textureSample(base_texture, base_sampler, receiver.uv);
    return seen_surface(base_colour.rgb * texture.rgb, receiver, geometric_normal(receiver.from_eye));
}
