// Four comparisons around the receiver, weighted bilinearly by the sampler.

import chosen::umbrage_tap;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};
import package::sampling::reach_fixed::umbrage_offset_reach;

fn umbrage_filter(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    return umbrage_tap(lookup, vec2f(0.0));
}
