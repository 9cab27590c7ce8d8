// The mean of UMBRAGE_PCF_SIZE² bilinear lookups, one texel apart, in which each texel is compared with a depth of its own:
// that of a plane at its centre. The sampler knows one depth for four texels, so each is asked for by itself. Lookups
// side by side share texels: (UMBRAGE_PCF_SIZE + 1)² comparisons make them all.

/// How many of the lookups in a row count texel `i` of it, for a place that lies `share` of a texel beyond texel 0.
fn umbrage_weight(i: i32, share: f32) -> f32 {
    const REACH: i32 = UMBRAGE_PCF_SIZE / 2;
    return select(1.0, 1.0 - share, i == -REACH) * select(1.0, share, i == REACH + 1);
}

fn umbrage_filter(view_index: u32, texel: vec2f, reference: f32, gradient: vec2f, pixel: vec2f) -> f32 {
    const REACH: i32 = UMBRAGE_PCF_SIZE / 2;
    let first = floor(texel - 0.5) + 0.5;
    let share = texel - first;
    var sum = 0.0;
    for (var y = -REACH; y <= REACH + 1; y++) {
        for (var x = -REACH; x <= REACH + 1; x++) {
            let centre = first + vec2f(f32(x), f32(y));
            let weight = umbrage_weight(x, share.x) * umbrage_weight(y, share.y);
            sum += weight * umbrage_lit(view_index, centre, texel, reference, gradient);
        }
    }
    return sum / f32(UMBRAGE_PCF_SIZE * UMBRAGE_PCF_SIZE);
}
