// Every receiver is traced that a light shines on, as far from the eye as there are shadows.

import package::exact::not_known::UMBRAGE_UNDECIDED;
import package::frame::umbrage_frame;
import package::light::umbrage_shines_on;
import package::receiver::lookup::UmbrageReceiver;

/// How much of a light reaches a receiver that faces it, where that is known without a ray; otherwise UMBRAGE_UNDECIDED.
fn umbrage_known(light: u32, receiver: UmbrageReceiver) -> f32 {
    let is_asked = receiver.depth <= umbrage_frame.shadow_end && umbrage_shines_on(light, receiver.position);
    return select(1.0, UMBRAGE_UNDECIDED, is_asked);
}
