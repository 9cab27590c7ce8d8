// A comparison is bilinear: the sampler's, with one depth for four texels.

/// How much a place beside the receiver leaves it lit; `offset` is in texels.
fn umbrage_tap(lookup: UmbrageLookup, offset: vec2f) -> f32 {
    let uv = umbrage_uv(lookup.view_index, lookup.texel + offset);
    let layer = umbrage_frame.views[lookup.view_index].layer;
    return textureSampleCompareLevel(umbrage_map, umbrage_compare, uv, layer, lookup.reference);
}
