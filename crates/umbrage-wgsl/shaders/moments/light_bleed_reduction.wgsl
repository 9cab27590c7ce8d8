// Light that leaks, cut off (Lauritzen 2007).

import constants::UMBRAGE_MOMENTS_LIGHT_BLEED_REDUCTION;

/// Visibility without its lowest part, and the rest stretched.
fn umbrage_without_bleed(visibility: f32) -> f32 {
    let rest = max(1.0 - UMBRAGE_MOMENTS_LIGHT_BLEED_REDUCTION, 1.1920929e-7);
    return clamp((visibility - UMBRAGE_MOMENTS_LIGHT_BLEED_REDUCTION) / rest, 0.0, 1.0);
}
