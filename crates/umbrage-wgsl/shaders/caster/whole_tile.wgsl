/// Corner `index` of a triangle that covers the whole viewport, at some depth of clip space.
fn umbrage_whole_tile(index: u32, depth: f32) -> vec4f {
    return vec4f(vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0, depth, 1.0);
}
