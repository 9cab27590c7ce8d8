// Receivers are traced of which the map is not sure (Hertel, Hormann and Westermann 2009): those around which its texels
// disagree, and those that no map serves.

import chosen::{umbrage_sure, umbrage_traced};
import package::exact::decided::UMBRAGE_UNDECIDED;
import package::exact::turned_away::UMBRAGE_TURNED_AWAY;
import package::frame::umbrage_frame;
import package::receiver::fade::umbrage_faded;
import package::receiver::lookup::UmbrageReceiver;
import package::receiver::no_view::UMBRAGE_NO_VIEW;
import package::receiver::view::umbrage_lookup_of;

/// How much of a light reaches a receiver that faces it.
fn umbrage_reaching(light: u32, receiver: UmbrageReceiver) -> f32 {
    if receiver.depth > umbrage_frame.shadow_end {
        return 1.0;
    }
    let lookup = umbrage_lookup_of(light, receiver.position, receiver.normal);
    var visible = UMBRAGE_UNDECIDED;
    if lookup.view_index != UMBRAGE_NO_VIEW {
        visible = umbrage_sure(lookup, receiver);
    }
    if visible == UMBRAGE_UNDECIDED {
        visible = umbrage_traced(light, receiver);
    }
    return umbrage_faded(visible, light, receiver.depth);
}
