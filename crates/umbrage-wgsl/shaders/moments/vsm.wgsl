// Variance shadow maps: depth and its square (Donnelly & Lauritzen 2006). Depths are linear, 0 near the light and 1 far.

import package::moments::chebyshev::umbrage_largest_share_beyond;
import package::moments::light_bleed_reduction::umbrage_without_bleed;
import package::moments::mean::{umbrage_moments_add, umbrage_moments_none};

/// What one depth is stored as. `slope` is how much depth grows from a texel to the next, to the right and downward.
fn umbrage_moments_of(depth: f32, slope: vec2f) -> vec4f {
    let z = clamp(depth, 0.0, 1.0);
    // A step larger than the range is a silhouette's, and no depths in 0…1 have a mean square above their mean.
    let within = clamp(slope, vec2f(-1.0), vec2f(1.0));
    return vec4f(z, min(z * z + 0.25 * dot(within, within), z), 0.0, 0.0);
}

/// How much light reaches a receiver, from 0 to 1. No deviation of depth is taken to be less than `min_standard_deviation`.
fn umbrage_moments_visibility(moments: vec4f, depth: f32, min_standard_deviation: f32) -> f32 {
    let z = clamp(depth, 0.0, 1.0);
    return umbrage_without_bleed(umbrage_largest_share_beyond(moments.xy, z, min_standard_deviation));
}
