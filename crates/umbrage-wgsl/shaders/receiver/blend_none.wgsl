// One view a receiver: splits meet in a line.

import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};

fn umbrage_blend(lookup: UmbrageLookup, own: f32, receiver: UmbrageReceiver) -> f32 {
    return own;
}
