// Four comparisons around the receiver, weighted bilinearly by the sampler.

fn umbrage_filter(view_index: u32, texel: vec2f, reference: f32, gradient: vec2f, pixel: vec2f) -> f32 {
    let uv = umbrage_uv(view_index, texel);
    let layer = umbrage_frame.views[view_index].layer;
    return textureSampleCompareLevel(umbrage_map, umbrage_compare, uv, layer, reference);
}
