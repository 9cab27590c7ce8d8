// One comparison with the texel that holds the receiver.

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    return umbrage_lit(lookup, floor(lookup.texel) + 0.5);
}
