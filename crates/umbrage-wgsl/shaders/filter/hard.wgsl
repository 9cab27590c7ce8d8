// One comparison with the texel that holds the receiver.

import chosen::umbrage_lit;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::reach_fixed::umbrage_offset_reach;

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    return umbrage_lit(lookup, floor(lookup.texel) + 0.5);
}
