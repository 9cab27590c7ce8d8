// Exponentials of depth (Lauritzen & McCool 2008), each a variance shadow map. Depths are linear, 0 near the light and
// 1 far; the exponentials are of depths −1…1.

import package::moments::chebyshev::umbrage_largest_share_beyond;

/// e^(c z), or −e^(−c z) where the exponent is negative: both grow with depth.
fn umbrage_warp(exponent: f32, depth: f32) -> f32 {
    return sign(exponent) * exp(exponent * (2.0 * clamp(depth, 0.0, 1.0) - 1.0));
}

/// What one exponential allows at a receiver.
fn umbrage_largest_share_behind(exponent: f32, moments: vec2f, depth: f32, min_standard_deviation: f32) -> f32 {
    let place = umbrage_warp(exponent, depth);
    // The warp stretches a small step of depth by its derivative.
    return umbrage_largest_share_beyond(moments, place, 2.0 * exponent * min_standard_deviation * place);
}
