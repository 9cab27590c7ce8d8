// Every texel is compared with the receiver's own depth.

fn umbrage_gradient(view_index: u32, world_normal: vec3f, cosine: f32) -> vec2f {
    return vec2f(0.0);
}
