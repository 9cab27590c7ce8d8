// Exponential variance shadow maps of the positive exponential alone.

import constants::UMBRAGE_MOMENTS_EXPONENT;
import package::moments::evsm::{umbrage_largest_share_behind, umbrage_warp};
import package::moments::light_bleed_reduction::umbrage_without_bleed;
import package::moments::mean::{umbrage_moments_add, umbrage_moments_none};

/// What one depth is stored as.
fn umbrage_moments_of(depth: f32, slope: vec2f) -> vec4f {
    let warped = umbrage_warp(UMBRAGE_MOMENTS_EXPONENT, depth);
    return vec4f(warped, warped * warped, 0.0, 0.0);
}

/// How much light reaches a receiver, from 0 to 1. No deviation of depth is taken to be less than `min_standard_deviation`.
fn umbrage_moments_visibility(moments: vec4f, depth: f32, min_standard_deviation: f32) -> f32 {
    return umbrage_without_bleed(umbrage_largest_share_behind(UMBRAGE_MOMENTS_EXPONENT, moments.xy, depth, min_standard_deviation));
}
