// One comparison with the texel that holds the receiver.

fn umbrage_filter(view_index: u32, texel: vec2f, reference: f32, pixel: vec2f) -> f32 {
    // The texel's centre: samplers round coordinates to fewer bits than f32 has.
    let uv = umbrage_uv(view_index, floor(texel) + 0.5);
    let layer = umbrage_frame.views[view_index].layer;
    return textureSampleCompareLevel(umbrage_map, umbrage_compare, uv, layer, reference);
}
