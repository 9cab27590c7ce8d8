// Moments over a box of a given radius, from a summed-area table.

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let radius = vec2f(umbrage_radius(lookup.texel_metres.x), umbrage_radius(lookup.texel_metres.y));
    let depth = umbrage_linear_depth(lookup.view_index, lookup.texel, lookup.reference);
    let min_standard_deviation = UMBRAGE_MIN_STANDARD_DEVIATION / umbrage_frame.views[lookup.view_index].depth_metres;
    return umbrage_moments_visibility(umbrage_moments_over(lookup, radius), depth, min_standard_deviation);
}
