// The offset along the normal covers the same texels everywhere.

import constants::UMBRAGE_OFFSET_REACH;

/// How far the offset along the normal must reach, texels, where the longer side of a texel is so many metres.
fn umbrage_offset_reach(texel_metres: f32) -> f32 {
    return UMBRAGE_OFFSET_REACH;
}
