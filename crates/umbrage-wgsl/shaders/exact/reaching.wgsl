// How much of a light reaches a receiver where some receivers are traced.

import chosen::{umbrage_known, umbrage_traced};
import package::exact::not_known::UMBRAGE_UNDECIDED;
import package::receiver::fade::umbrage_faded;
import package::receiver::lookup::UmbrageReceiver;

/// Surfaces are dark whose normal has no larger cosine to the direction of a light. Where rays decide, a normal that is known no
/// better than this does not.
const UMBRAGE_TURNED_AWAY: f32 = -5e-4;

/// How much of a light reaches a receiver that faces it, by rays.
fn umbrage_reaching_by_rays(light: u32, receiver: UmbrageReceiver) -> f32 {
    return umbrage_faded(umbrage_traced(light, receiver), light, receiver.depth);
}

/// How much of a light reaches a receiver that faces it.
fn umbrage_reaching(light: u32, receiver: UmbrageReceiver) -> f32 {
    let known = umbrage_known(light, receiver);
    if known != UMBRAGE_UNDECIDED {
        return known;
    }
    return umbrage_reaching_by_rays(light, receiver);
}
