// The mean over what the pixel covers of the map, and over a texel: edges are as smooth as the picture's own, and no smoother.
// A texel-wide box makes of nearest comparisons what bilinear ones are.

import constants::{UMBRAGE_MAX_TEXELS, UMBRAGE_POINTS, UMBRAGE_TAPS};
import chosen::umbrage_tap;
import package::receiver::footprint::umbrage_footprint;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::reach_fixed::umbrage_offset_reach;

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let footprint = umbrage_footprint(lookup, receiver);
    var points = UMBRAGE_POINTS;
    var sum = 0.0;
    for (var i = 0u; i < UMBRAGE_TAPS; i++) {
        let offset = footprint * points[i].xy + points[i].zw;
        sum += umbrage_tap(lookup, clamp(offset, vec2f(-UMBRAGE_MAX_TEXELS), vec2f(UMBRAGE_MAX_TEXELS)));
    }
    return sum / f32(UMBRAGE_TAPS);
}
