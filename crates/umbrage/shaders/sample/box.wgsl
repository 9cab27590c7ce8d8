// The mean of moments over a box, from a summed-area table of whole numbers. Sums wrap around, and differences of them come
// out right all the same, since no box holds more than UMBRAGE_SUM_SCALE allows (Peters et al. 2017).

@group(0) @binding(3) var umbrage_sums: texture_2d_array<u32>;

/// The sum up to and with a texel of the tile, counted from its upper left corner; nothing before the tile.
fn umbrage_sum(lookup: UmbrageLookup, place: vec2i) -> vec4u {
    if any(place < vec2i(0)) {
        return vec4u(0u);
    }
    let view_index = lookup.view_index;
    let last = i32(umbrage_frame.views[view_index].tile_size) - 1;
    let origin = vec2i(umbrage_frame.views[view_index].tile_origin);
    return textureLoad(umbrage_sums, origin + min(place, vec2i(last)), umbrage_frame.views[view_index].layer, 0);
}

/// The mean over a box around the lookup with half sides `radius`, texels. Texels that it cuts count in part.
fn umbrage_moments_over(lookup: UmbrageLookup, radius: vec2f) -> vec4f {
    let tile_size = umbrage_frame.views[lookup.view_index].tile_size;
    let low = clamp(lookup.texel - radius, vec2f(0.0), vec2f(tile_size));
    let high = clamp(lookup.texel + radius, vec2f(0.0), vec2f(tile_size));
    // The box ends within these texels, and holds such a share of them.
    let first = vec2i(floor(low)) - 1;
    let last = vec2i(floor(high)) - 1;
    let before = fract(low);
    let within = fract(high);
    var sums: array<vec4u, 16>;
    for (var y = 0; y < 4; y++) {
        for (var x = 0; x < 4; x++) {
            let column = select(last.x + x - 2, first.x + x, x < 2);
            let row = select(last.y + y - 2, first.y + y, y < 2);
            sums[4 * y + x] = umbrage_sum(lookup, vec2i(column, row));
        }
    }
    // Edges lie within texels: each of the four is one of two, and weighs so much.
    let weights = mat4x2f(
        vec2f(1.0 - before.x, before.x), vec2f(1.0 - within.x, within.x),
        vec2f(1.0 - before.y, before.y), vec2f(1.0 - within.y, within.y));
    var sum = vec4f(0.0);
    for (var i = 0; i < 16; i++) {
        let left = i & 1;
        let right = (i >> 1u) & 1;
        let upper = (i >> 2u) & 1;
        let lower = i >> 3u;
        let inside = sums[4 * (2 + lower) + 2 + right] - sums[4 * (2 + lower) + left]
            - sums[4 * upper + 2 + right] + sums[4 * upper + left];
        sum += weights[0][left] * weights[1][right] * weights[2][upper] * weights[3][lower] * vec4f(inside);
    }
    let size = high - low;
    return sum / (UMBRAGE_SUM_SCALE * size.x * size.y);
}
