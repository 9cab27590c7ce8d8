// Every receiver is traced that a light may reach, as far from the eye as there are shadows.

import package::exact::not_known::UMBRAGE_UNDECIDED;
import package::frame::umbrage_frame;
import package::light::umbrage_is_sun;
import package::receiver::lookup::UmbrageReceiver;
import package::receiver::no_view::UMBRAGE_NO_VIEW;
import package::receiver::view::umbrage_lookup_of;

/// Whether a lamp may reach a receiver: its maps hold all that it shines on, within its cone and its range.
fn umbrage_may_reach(light: u32, receiver: UmbrageReceiver) -> bool {
    let lookup = umbrage_lookup_of(light, receiver.position, receiver.normal);
    return lookup.view_index != UMBRAGE_NO_VIEW && lookup.compare_depth >= 0.0;
}

/// How much of a light reaches a receiver that faces it, where that is known without a ray; otherwise UMBRAGE_UNDECIDED.
fn umbrage_known(light: u32, receiver: UmbrageReceiver) -> f32 {
    if receiver.depth > umbrage_frame.shadow_end {
        return 1.0;
    }
    if !umbrage_is_sun(light) && !umbrage_may_reach(light, receiver) {
        return 1.0;
    }
    return UMBRAGE_UNDECIDED;
}
