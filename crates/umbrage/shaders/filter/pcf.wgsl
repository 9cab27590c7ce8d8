// The mean of UMBRAGE_PCF_SIZE² bilinear lookups, one texel apart (percentage-closer filtering, Reeves et al. 1987).

fn umbrage_filter(view_index: u32, texel: vec2f, reference: f32, gradient: vec2f, pixel: vec2f) -> f32 {
    const REACH: i32 = UMBRAGE_PCF_SIZE / 2;
    let layer = umbrage_frame.views[view_index].layer;
    var sum = 0.0;
    for (var y = -REACH; y <= REACH; y++) {
        for (var x = -REACH; x <= REACH; x++) {
            let uv = umbrage_uv(view_index, texel + vec2f(f32(x), f32(y)));
            sum += textureSampleCompareLevel(umbrage_map, umbrage_compare, uv, layer, reference);
        }
    }
    return sum / f32(UMBRAGE_PCF_SIZE * UMBRAGE_PCF_SIZE);
}
