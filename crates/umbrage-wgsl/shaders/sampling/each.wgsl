// A kernel of bilinear lookups, one texel apart, in which each texel is compared with a depth of its own: that of a plane
// at its centre. The sampler knows one depth for four texels, so each is asked for by itself. Lookups side by side share
// texels: (UMBRAGE_KERNEL_SIZE + 1)² comparisons make them all.

import constants::UMBRAGE_KERNEL_SIZE;
import chosen::UMBRAGE_KERNEL_SUM;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::lit_compared::umbrage_lit;
import package::sampling::reach_fixed::umbrage_offset_reach;
import package::sampling::weight::umbrage_weight;

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
