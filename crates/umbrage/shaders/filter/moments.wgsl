// Moments of depth, blurred before they are read, turned into visibility. `umbrage_moments_at` comes from a file of
// `sample/`, `umbrage_moments_visibility` from one of `moments/`.

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let depth = umbrage_linear_depth(lookup.view_index, lookup.texel, lookup.reference);
    let min_standard_deviation = UMBRAGE_MIN_STANDARD_DEVIATION / umbrage_frame.views[lookup.view_index].depth_metres;
    return umbrage_moments_visibility(umbrage_moments_at(lookup, receiver), depth, min_standard_deviation);
}
