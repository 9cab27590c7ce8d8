// Moments of depth, blurred before they are read, turned into visibility.

import constants::UMBRAGE_MIN_STANDARD_DEVIATION;
import chosen::{umbrage_moments_at, umbrage_moments_visibility};
import package::frame::umbrage_frame;
import package::linear_depth::umbrage_linear_depth;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::reach_fixed::umbrage_offset_reach;

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let depth = umbrage_linear_depth(lookup.view_index, lookup.texel, lookup.compare_depth);
    let min_standard_deviation = UMBRAGE_MIN_STANDARD_DEVIATION / umbrage_frame.views[lookup.view_index].depth_metres;
    return umbrage_moments_visibility(umbrage_moments_at(lookup, receiver), depth, min_standard_deviation);
}
