// One view a receiver: splits meet in a line.

import package::receiver::lookup::{UmbrageLookup, UmbrageReceiver};

fn umbrage_blend(view_index: u32, light: u32, lookup: UmbrageLookup, own: f32, receiver: UmbrageReceiver) -> f32 {
    return own;
}
