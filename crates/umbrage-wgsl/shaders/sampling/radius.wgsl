// The radius of a filter, in metres or in texels.

import constants::{UMBRAGE_RADIUS_IN_METRES, UMBRAGE_RADIUS_METRES, UMBRAGE_RADIUS_TEXELS};

/// The filter's radius, texels, where a texel is so many metres. In metres it is the same in every split, up to a number of
/// texels.
fn umbrage_radius(texel_metres: f32) -> f32 {
    if UMBRAGE_RADIUS_IN_METRES {
        return max(min(UMBRAGE_RADIUS_METRES / max(texel_metres, 1.1754944e-38), UMBRAGE_RADIUS_TEXELS), 0.5);
    }
    return max(UMBRAGE_RADIUS_TEXELS, 0.5);
}
