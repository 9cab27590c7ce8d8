// The mean of moments over a box, from a summed-area table of whole numbers. Sums wrap around, and differences of them come
// out right all the same, since no box holds more than UMBRAGE_SUM_SCALE allows (Peters et al. 2017).

import constants::UMBRAGE_SUM_SCALE;
import package::receiver::lookup::UmbrageLookup;
import package::storage::map::umbrage_tile_size;
import package::storage::sums::umbrage_sum;

/// The mean over a box around the lookup with half sides `radius`, texels. Texels that it cuts count in part.
fn umbrage_moments_over(lookup: UmbrageLookup, radius: vec2f) -> vec4f {
    let tile_size = umbrage_tile_size(lookup.view_index);
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
