// A number for every pixel: interleaved gradient noise (Jimenez, SIGGRAPH 2014).

/// From 0 to 1, and even over any few neighbours.
fn umbrage_gradient_noise(pixel: vec2f) -> f32 {
    return fract(52.9829189 * fract(dot(pixel, vec2f(0.06711056, 0.00583715))));
}
