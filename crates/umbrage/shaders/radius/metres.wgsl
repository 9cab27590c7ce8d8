// A radius in metres, the same in every split.

/// The filter's radius, texels, where a texel is so many metres.
fn umbrage_radius(texel_metres: f32) -> f32 {
    return max(min(UMBRAGE_RADIUS_METRES / max(texel_metres, 1.1754944e-38), UMBRAGE_RADIUS_TEXELS), 0.5);
}
