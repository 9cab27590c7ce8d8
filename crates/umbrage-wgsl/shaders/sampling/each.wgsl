// A kernel of bilinear lookups, one texel apart, in which each texel is compared with a depth of its own: that of a plane
// at its centre. The sampler knows one depth for four texels, so each is asked for by itself. Lookups side by side share
// texels: (UMBRAGE_KERNEL_SIZE + 1)² comparisons make them all. `umbrage_kernel` comes from a file of `kernel/`.

import constants::UMBRAGE_KERNEL_SIZE;
import chosen::{UMBRAGE_KERNEL_SUM, umbrage_kernel};
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::lit::umbrage_lit;
import package::sampling::reach_fixed::umbrage_offset_reach;

/// What texel `i` of a row weighs, for a place that lies `share` of a texel beyond texel 0.
fn umbrage_weight(i: i32, share: f32) -> f32 {
    return mix(umbrage_kernel(i), umbrage_kernel(i - 1), share);
}

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    const REACH: i32 = UMBRAGE_KERNEL_SIZE / 2;
    let first = floor(lookup.texel - 0.5) + 0.5;
    let share = lookup.texel - first;
    var sum = 0.0;
    for (var y = -REACH; y <= REACH + 1; y++) {
        let row = umbrage_weight(y, share.y);
        for (var x = -REACH; x <= REACH + 1; x++) {
            let centre = first + vec2f(f32(x), f32(y));
            sum += row * umbrage_weight(x, share.x) * umbrage_lit(lookup, centre);
        }
    }
    return sum / (UMBRAGE_KERNEL_SUM * UMBRAGE_KERNEL_SUM);
}
