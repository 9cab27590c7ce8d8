// Moment soft shadows (Peters et al. 2017): the moments of a box say how far its blockers are on average, and those of a
// box as wide as the penumbra how much of the light reaches the receiver.

import constants::UMBRAGE_MIN_STANDARD_DEVIATION;
import package::frame::umbrage_frame;
import package::linear_depth::umbrage_linear_depth;
import package::moments::msm::umbrage_moments_visibility;
import package::moments::msm_blocker::umbrage_moments_blocker;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::box::umbrage_moments_over;
import package::sampling::penumbra::umbrage_penumbra_texels;
import package::sampling::reach_fixed::umbrage_offset_reach;

/// Half a side of the square that has the area of the unit disc.
const UMBRAGE_SQUARE: f32 = 0.88622693;

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let depth = umbrage_linear_depth(lookup.view_index, lookup.texel, lookup.compare_depth);
    let min_standard_deviation = UMBRAGE_MIN_STANDARD_DEVIATION / umbrage_frame.views[lookup.view_index].depth_metres;
    let search = umbrage_penumbra_texels(lookup, depth, 0.0) * UMBRAGE_SQUARE;
    // Moments know how much lies before the receiver at least. Where that is nothing the blocker is at the receiver, and the
    // narrowest box decides: to take it for lit would light what many depths around it hide.
    let blockers = umbrage_moments_blocker(umbrage_moments_over(lookup, search), depth);
    let radius = max(umbrage_penumbra_texels(lookup, depth, blockers.y) * UMBRAGE_SQUARE, vec2f(0.5));
    return umbrage_moments_visibility(umbrage_moments_over(lookup, radius), depth, min_standard_deviation);
}
