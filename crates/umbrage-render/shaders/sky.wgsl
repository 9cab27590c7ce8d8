// The sky behind the scene. It needs `scene.wgsl`, `sky_light.wgsl` or `environment.wgsl`, and `tone.wgsl`.

struct Sky {
    @builtin(position) clip: vec4f,
    @location(0) ndc: vec2f,
}

/// A triangle over the whole picture, at the far plane of reversed depth.
@vertex
fn sky(@builtin(vertex_index) index: u32) -> Sky {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0;
    return Sky(vec4f(corner, 0.0, 1.0), corner);
}

@fragment
fn sky_shade(sky: Sky) -> @location(0) vec4f {
    let near = scene.world_from_clip * vec4f(sky.ndc, 1.0, 1.0);
    let far = scene.world_from_clip * vec4f(sky.ndc, 0.0, 1.0);
    let direction = normalize(far.xyz / far.w - near.xyz / near.w);
    return vec4f(tone_mapped(sky_seen(direction)), 1.0);
}
