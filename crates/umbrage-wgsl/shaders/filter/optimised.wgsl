// A bell of bilinear lookups in as few of them as can be: 4, 9 or 16, each between texels, where the sampler's own weights
// do the rest (Castaño, The Witness, 2013). The same as the bell of `sampling/kernel_bell.wgsl`, which is the oracle.

import constants::UMBRAGE_KERNEL_SIZE;
import chosen::umbrage_tap;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::reach_fixed::umbrage_offset_reach;

/// Weights of the lookups of a row, and where they are, in texels from the place's texel; for a place that lies `s` beyond it.
fn umbrage_row(s: f32) -> mat2x4f {
    if UMBRAGE_KERNEL_SIZE == 3 {
        let w = vec2f(3.0 - 2.0 * s, 1.0 + 2.0 * s);
        return mat2x4f(vec4f(w, 0.0, 0.0), vec4f((2.0 - s) / w.x - 1.0, s / w.y + 1.0, 0.0, 0.0));
    }
    if UMBRAGE_KERNEL_SIZE == 5 {
        let w = vec3f(4.0 - 3.0 * s, 7.0, 1.0 + 3.0 * s);
        let o = vec3f((3.0 - 2.0 * s) / w.x - 2.0, (3.0 + s) / w.y, s / w.z + 2.0);
        return mat2x4f(vec4f(w, 0.0), vec4f(o, 0.0));
    }
    let w = vec4f(6.0 - 5.0 * s, 28.0 - 11.0 * s, 17.0 + 11.0 * s, 1.0 + 5.0 * s);
    let o = vec4f((5.0 - 4.0 * s) / w.x - 3.0, (16.0 - 4.0 * s) / w.y - 1.0, (5.0 + 7.0 * s) / w.z + 1.0, s / w.w + 3.0);
    return mat2x4f(w, o);
}

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    const LOOKUPS: i32 = (UMBRAGE_KERNEL_SIZE + 1) / 2;
    let base = floor(lookup.texel + 0.5);
    let share = lookup.texel + 0.5 - base;
    let columns = umbrage_row(share.x);
    let rows = umbrage_row(share.y);
    var sum = 0.0;
    var weights = 0.0;
    for (var y = 0; y < LOOKUPS; y++) {
        for (var x = 0; x < LOOKUPS; x++) {
            let place = base - 0.5 + vec2f(columns[1][x], rows[1][y]);
            let weight = columns[0][x] * rows[0][y];
            sum += weight * umbrage_tap(lookup, place - lookup.texel);
            weights += weight;
        }
    }
    return sum / weights;
}
