// Whether a light without size is seen: where the texels around the receiver agree.

import package::exact::decided::umbrage_decided;
import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};

/// 1 where the map is sure that a receiver is lit, 0 where it is sure that it is not, and otherwise UMBRAGE_UNDECIDED.
fn umbrage_sure(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    return umbrage_decided(lookup);
}
