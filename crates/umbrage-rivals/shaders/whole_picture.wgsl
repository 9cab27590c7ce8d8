// One triangle that covers the picture.

struct Covering {
    @builtin(position) clip: vec4f,
    /// −1 to 1, y up.
    @location(0) point: vec2f,
}

@vertex
fn whole_picture(@builtin(vertex_index) vertex: u32) -> Covering {
    let point = vec2f(f32(vertex & 1u), f32(vertex >> 1u)) * 4.0 - 1.0;
    return Covering(vec4f(point, 0.0, 1.0), point);
}
