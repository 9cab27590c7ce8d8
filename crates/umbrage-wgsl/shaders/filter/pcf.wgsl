// The mean of UMBRAGE_KERNEL_SIZE² bilinear lookups, one texel apart (percentage-closer filtering, Reeves et al. 1987).

import constants::UMBRAGE_KERNEL_SIZE;
import chosen::umbrage_tap;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::reach_fixed::umbrage_offset_reach;

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    const REACH: i32 = UMBRAGE_KERNEL_SIZE / 2;
    var sum = 0.0;
    for (var y = -REACH; y <= REACH; y++) {
        for (var x = -REACH; x <= REACH; x++) {
            sum += umbrage_tap(lookup, vec2f(f32(x), f32(y)));
        }
    }
    return sum / f32(UMBRAGE_KERNEL_SIZE * UMBRAGE_KERNEL_SIZE);
}
