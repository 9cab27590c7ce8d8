// A radius in texels.

/// The filter's radius, texels, where a texel is so many metres.
fn umbrage_radius(texel_metres: f32) -> f32 {
    return max(UMBRAGE_RADIUS_TEXELS, 0.5);
}
