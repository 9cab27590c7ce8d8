// Every receiver is traced, as far from the eye as there are shadows.

import package::exact::not_known::UMBRAGE_UNDECIDED;
import package::frame::umbrage_frame;
import package::receiver::lookup::UmbrageReceiver;

/// How much of a light reaches a receiver that faces it, where that is known without a ray; otherwise UMBRAGE_UNDECIDED.
fn umbrage_known(light: u32, receiver: UmbrageReceiver) -> f32 {
    return select(UMBRAGE_UNDECIDED, 1.0, receiver.depth > umbrage_frame.shadow_end);
}
