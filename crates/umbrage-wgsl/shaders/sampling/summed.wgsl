// Moments over a box of a given radius, from a summed-area table.

import constants::UMBRAGE_MIN_STANDARD_DEVIATION;
import chosen::umbrage_moments_visibility;
import package::frame::umbrage_frame;
import package::linear_depth::umbrage_linear_depth;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::box::umbrage_moments_over;
import package::sampling::radius::umbrage_radius;
import package::sampling::reach_fixed::umbrage_offset_reach;

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let radius = vec2f(umbrage_radius(lookup.texel_metres.x), umbrage_radius(lookup.texel_metres.y));
    let depth = umbrage_linear_depth(lookup.view_index, lookup.texel, lookup.compare_depth);
    let min_standard_deviation = UMBRAGE_MIN_STANDARD_DEVIATION / umbrage_frame.views[lookup.view_index].depth_metres;
    return umbrage_moments_visibility(umbrage_moments_over(lookup, radius), depth, min_standard_deviation);
}
