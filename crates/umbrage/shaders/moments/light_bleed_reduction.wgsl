// Light that leaks, cut off (Lauritzen 2007).

/// Visibility without its lowest part, and the rest stretched.
fn umbrage_without_bleed(visibility: f32) -> f32 {
    return clamp((visibility - UMBRAGE_MOMENTS_LIGHT_BLEED_REDUCTION) / max(1.0 - UMBRAGE_MOMENTS_LIGHT_BLEED_REDUCTION, 1.1920929e-7), 0.0, 1.0);
}
