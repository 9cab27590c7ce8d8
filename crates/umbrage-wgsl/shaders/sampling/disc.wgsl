// The mean of comparisons at points on a disc around the receiver.

import constants::{UMBRAGE_EARLY_OUT, UMBRAGE_POINTS, UMBRAGE_TAPS};
import chosen::{umbrage_point, umbrage_tap};
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::noise::umbrage_noise;
import package::sampling::radius::umbrage_radius;
import package::sampling::reach_disc::umbrage_offset_reach;

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let radius = vec2f(umbrage_radius(lookup.texel_metres.x), umbrage_radius(lookup.texel_metres.y));
    let noise = umbrage_noise(receiver);
    if UMBRAGE_EARLY_OUT {
        // Where the rim agrees with itself, what is within is taken to agree as well.
        var rim = 0.0;
        for (var i = 0u; i < 4u; i++) {
            let angle = 1.5707963 * (f32(i) + 0.5);
            rim += umbrage_tap(lookup, vec2f(cos(angle), sin(angle)) * radius);
        }
        if rim == 0.0 || rim == 4.0 {
            return rim * 0.25;
        }
    }
    var points = UMBRAGE_POINTS;
    var sum = 0.0;
    for (var i = 0u; i < UMBRAGE_TAPS; i++) {
        sum += umbrage_tap(lookup, umbrage_point(points[i], i, noise) * radius);
    }
    return sum / f32(UMBRAGE_TAPS);
}
