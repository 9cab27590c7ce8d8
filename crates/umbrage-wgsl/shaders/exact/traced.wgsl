// Rays from a receiver to a light, where rays know all casters.

import chosen::umbrage_rays;
import package::receiver::lookup::UmbrageReceiver;

/// How much of a light reaches a receiver.
fn umbrage_traced(light: u32, receiver: UmbrageReceiver) -> f32 {
    return umbrage_rays(light, receiver).share;
}
