// Percentage-closer soft shadows (Fernando 2005): how far the blockers are on average says how wide the penumbra is, and so
// wide is the disc of comparisons. Widths are in metres, so they are the same in every split and for every light.

import constants::{UMBRAGE_BLOCKERS, UMBRAGE_POINTS, UMBRAGE_SEARCH, UMBRAGE_TAPS};
import chosen::umbrage_tap;
import package::linear_depth::umbrage_linear_depth;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::compare_depth::umbrage_compare_depth;
import package::sampling::noise::umbrage_noise;
import package::sampling::penumbra::umbrage_penumbra_texels;
import package::sampling::points_rotated::umbrage_point;
import package::sampling::reach_fixed::umbrage_offset_reach;
import package::storage::map::umbrage_inside;
import package::storage::stored_depth::umbrage_stored_depth;

/// The mean depth of what is before the receiver within a disc, and how many of the points found something.
fn umbrage_blockers(lookup: UmbrageLookup, radius: vec2f, noise: f32) -> vec2f {
    var points = UMBRAGE_SEARCH;
    var sum = 0.0;
    var count = 0.0;
    for (var i = 0u; i < UMBRAGE_BLOCKERS; i++) {
        let place = lookup.texel + umbrage_point(points[i], i, noise) * radius;
        let centre = umbrage_inside(lookup.view_index, floor(place) + 0.5);
        let stored = umbrage_stored_depth(lookup.view_index, centre);
        if stored > umbrage_compare_depth(lookup, centre) {
            sum += umbrage_linear_depth(lookup.view_index, centre, stored);
            count += 1.0;
        }
    }
    return vec2f(sum / max(count, 1.0), count);
}

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let noise = umbrage_noise(receiver);
    let depth = umbrage_linear_depth(lookup.view_index, lookup.texel, lookup.compare_depth);
    // Whatever shadows it lies between the near plane and the receiver, and is seen through this disc.
    let blockers = umbrage_blockers(lookup, umbrage_penumbra_texels(lookup, depth, 0.0), noise);
    if blockers.y == 0.0 {
        return 1.0;
    }
    let radius = umbrage_penumbra_texels(lookup, depth, blockers.x);
    var points = UMBRAGE_POINTS;
    var sum = 0.0;
    for (var i = 0u; i < UMBRAGE_TAPS; i++) {
        sum += umbrage_tap(lookup, umbrage_point(points[i], i, noise) * radius);
    }
    return sum / f32(UMBRAGE_TAPS);
}
