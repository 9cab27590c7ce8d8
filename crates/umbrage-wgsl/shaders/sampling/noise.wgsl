// The source of the noise that turns or picks a filter's points: screen position, world position, or none.

import constants::UMBRAGE_NOISE;
import package::receiver::lookup::UmbrageReceiver;
import package::sampling::gradient_noise::umbrage_gradient_noise;
import package::sampling::pcg::umbrage_pcg;

/// A number for every pixel.
const UMBRAGE_NOISE_SCREEN: u32 = 0u;
/// A number for every millimetre of the world (opengl-tutorial 16).
const UMBRAGE_NOISE_WORLD: u32 = 1u;
/// The same number everywhere.
const UMBRAGE_NOISE_NONE: u32 = 2u;

/// The noise at a receiver, from 0 to 1.
fn umbrage_noise(receiver: UmbrageReceiver) -> f32 {
    if UMBRAGE_NOISE == UMBRAGE_NOISE_SCREEN {
        return umbrage_gradient_noise(receiver.pixel);
    }
    if UMBRAGE_NOISE == UMBRAGE_NOISE_WORLD {
        let place = vec3u(vec3i(floor(receiver.position * 1000.0)));
        return f32(umbrage_pcg(place.x + umbrage_pcg(place.y + umbrage_pcg(place.z))) >> 8u) / 16777216.0;
    }
    return 0.0;
}
