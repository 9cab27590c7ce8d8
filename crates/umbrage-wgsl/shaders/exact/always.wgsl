// Every receiver is traced, as far from the eye as there are shadows.

import chosen::umbrage_traced;
import package::exact::turned_away::UMBRAGE_TURNED_AWAY;
import package::frame::umbrage_frame;
import package::receiver::fade::umbrage_faded;
import package::receiver::lookup::UmbrageReceiver;

/// How much of a light reaches a receiver that faces it.
fn umbrage_reaching(light: u32, receiver: UmbrageReceiver) -> f32 {
    if receiver.depth > umbrage_frame.shadow_end {
        return 1.0;
    }
    return umbrage_faded(umbrage_traced(light, receiver), light, receiver.depth);
}
