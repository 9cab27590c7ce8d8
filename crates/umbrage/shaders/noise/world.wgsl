// A number for every millimetre of the world (opengl-tutorial 16).

/// From 0 to 1.
fn umbrage_noise(receiver: UmbrageReceiver) -> f32 {
    let place = vec3u(vec3i(floor(receiver.position * 1000.0)));
    return f32(umbrage_pcg(place.x + umbrage_pcg(place.y + umbrage_pcg(place.z))) >> 8u) / 16777216.0;
}
