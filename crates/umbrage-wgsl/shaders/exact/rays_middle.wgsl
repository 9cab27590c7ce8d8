// One ray, to the middle of the light: its shadows are hard.

import package::exact::trace::{UmbrageTrace, umbrage_trace};
import package::light::{UMBRAGE_FARTHEST_LIGHT, umbrage_direction_to_light, umbrage_distance_to_light, umbrage_near_along};
import package::receiver::lookup::UmbrageReceiver;

/// What lies between a receiver and a light.
fn umbrage_rays(light: u32, receiver: UmbrageReceiver) -> UmbrageTrace {
    let lamp = umbrage_distance_to_light(light, receiver.position, UMBRAGE_FARTHEST_LIGHT);
    let to_light = umbrage_direction_to_light(light, receiver.position);
    return umbrage_trace(receiver.position, to_light, lamp, lamp - umbrage_near_along(light, to_light));
}
