// The sky where visibility is shown: lit.

@vertex
fn sky(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn sky_visibility() -> @location(0) vec4f {
    return vec4f(1.0);
}
