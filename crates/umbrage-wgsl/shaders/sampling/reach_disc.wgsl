// The offset along the normal covers the disc.

import constants::UMBRAGE_FARTHEST;
import package::sampling::radius::umbrage_radius;

/// How far the offset along the normal must reach, texels, where the longer side of a texel is so many metres.
fn umbrage_offset_reach(texel_metres: f32) -> f32 {
    return umbrage_radius(texel_metres) * UMBRAGE_FARTHEST + 1.0;
}
