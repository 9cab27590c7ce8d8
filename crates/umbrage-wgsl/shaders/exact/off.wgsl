// No receiver is traced.

import package::receiver::by_maps::umbrage_by_maps;
import package::receiver::lookup::UmbrageReceiver;

/// Surfaces are dark whose normal has no larger cosine to the direction of a light.
const UMBRAGE_TURNED_AWAY: f32 = 0.0;

/// How much of a light reaches a receiver that faces it.
fn umbrage_reaching(light: u32, receiver: UmbrageReceiver) -> f32 {
    return umbrage_by_maps(light, receiver);
}
