// Four comparisons around the receiver, weighted bilinearly by the sampler.

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    return umbrage_tap(lookup, vec2f(0.0));
}
