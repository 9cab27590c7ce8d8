// A ray to each of some points of a disc, which the light is seen as: its shadows are soft (Heckbert and Herf 1997, by rays). The
// points lie along a spiral, which each pixel turns by another angle.

import constants::{UMBRAGE_POINTS, UMBRAGE_TAPS};
import package::exact::trace::{UmbrageTrace, umbrage_trace};
import package::light::{UMBRAGE_FARTHEST_LIGHT, umbrage_direction_to_light, umbrage_near_along, umbrage_light_point};
import package::receiver::lookup::UmbrageReceiver;
import package::sampling::noise::umbrage_noise;
import package::sampling::points_rotated::umbrage_point;

/// What lies between a receiver and a light.
fn umbrage_rays(light: u32, receiver: UmbrageReceiver) -> UmbrageTrace {
    let noise = umbrage_noise(receiver);
    let to_middle = umbrage_direction_to_light(light, receiver.position);
    let side = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), abs(to_middle.x) > 0.5);
    let right = normalize(cross(side, to_middle));
    let up = cross(to_middle, right);
    var points = UMBRAGE_POINTS;
    var all = UmbrageTrace(0.0, false);
    for (var i = 0u; i < UMBRAGE_TAPS; i++) {
        let point = umbrage_point(points[i], i, noise);
        let way = umbrage_light_point(light, receiver.position, right * point.x + up * point.y);
        let lamp = min(length(way), UMBRAGE_FARTHEST_LIGHT);
        let toward = normalize(way);
        let one = umbrage_trace(receiver.position, toward, lamp, lamp - umbrage_near_along(light, toward));
        all.share += one.share / f32(UMBRAGE_TAPS);
        all.passed_bent = all.passed_bent || one.passed_bent;
    }
    return all;
}
