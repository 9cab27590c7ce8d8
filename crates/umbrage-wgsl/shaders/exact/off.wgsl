// No receiver is traced.

import package::receiver::by_maps::umbrage_by_maps;
import package::receiver::lookup::UmbrageReceiver;

/// How much of a light reaches a receiver that faces it.
fn umbrage_reaching(light: u32, receiver: UmbrageReceiver) -> f32 {
    return umbrage_by_maps(light, receiver);
}
