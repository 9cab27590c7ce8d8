// What the maps say of a receiver.

import chosen::umbrage_blend;
import package::receiver::lookup::UmbrageReceiver;
import package::receiver::no_view::UMBRAGE_NO_VIEW;
import package::receiver::read::umbrage_read;
import package::receiver::view::umbrage_lookup_of;

/// How much of a light the maps say to reach a receiver. Receivers outside every map are lit.
fn umbrage_by_maps(light: u32, receiver: UmbrageReceiver) -> f32 {
    let lookup = umbrage_lookup_of(light, receiver.position, receiver.normal);
    var visible = 1.0;
    if lookup.view_index != UMBRAGE_NO_VIEW {
        let own = umbrage_read(lookup, receiver);
        visible = umbrage_blend(lookup, own, receiver);
    }
    return visible;
}
