// Receivers are traced of which the map is not sure (Hertel, Hormann and Westermann 2009): those around which its texels
// disagree. What lies outside every map is lit, as without rays.

import chosen::umbrage_sure;
import package::exact::not_known::UMBRAGE_UNDECIDED;
import package::frame::umbrage_frame;
import package::receiver::fade::umbrage_faded;
import package::receiver::lookup::UmbrageReceiver;
import package::receiver::no_view::UMBRAGE_NO_VIEW;
import package::receiver::view::umbrage_lookup_of;

/// How much of a light reaches a receiver that faces it, where that is known without a ray; otherwise UMBRAGE_UNDECIDED.
fn umbrage_known(light: u32, receiver: UmbrageReceiver) -> f32 {
    if receiver.depth > umbrage_frame.shadow_end {
        return 1.0;
    }
    let lookup = umbrage_lookup_of(light, receiver.position, receiver.normal);
    var sure = 1.0;
    if lookup.view_index != UMBRAGE_NO_VIEW {
        sure = umbrage_sure(lookup, receiver);
    }
    return select(umbrage_faded(sure, light, receiver.depth), UMBRAGE_UNDECIDED, sure == UMBRAGE_UNDECIDED);
}
