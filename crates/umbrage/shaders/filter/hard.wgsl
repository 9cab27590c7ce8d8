// One comparison with the texel that holds the receiver.

fn umbrage_filter(view_index: u32, texel: vec2f, reference: f32, gradient: vec2f, pixel: vec2f) -> f32 {
    return umbrage_lit(view_index, floor(texel) + 0.5, texel, reference, gradient);
}
