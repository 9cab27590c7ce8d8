// Exponential variance shadow maps of both exponentials. The darker of the two counts.

import constants::{UMBRAGE_MOMENTS_EXPONENT, UMBRAGE_MOMENTS_NEGATIVE_EXPONENT};
import package::moments::evsm::{umbrage_largest_share_behind, umbrage_warp};
import package::moments::light_bleed_reduction::umbrage_without_bleed;
import package::moments::mean::{umbrage_moments_add, umbrage_moments_none};

/// What one depth is stored as.
fn umbrage_moments_of(depth: f32, slope: vec2f) -> vec4f {
    let positive = umbrage_warp(UMBRAGE_MOMENTS_EXPONENT, depth);
    let negative = umbrage_warp(-UMBRAGE_MOMENTS_NEGATIVE_EXPONENT, depth);
    return vec4f(positive, positive * positive, negative, negative * negative);
}

/// How much light reaches a receiver, from 0 to 1. No deviation of depth is taken to be less than `min_standard_deviation`.
fn umbrage_moments_visibility(moments: vec4f, depth: f32, min_standard_deviation: f32) -> f32 {
    let positive = umbrage_largest_share_behind(UMBRAGE_MOMENTS_EXPONENT, moments.xy, depth, min_standard_deviation);
    let negative = umbrage_largest_share_behind(-UMBRAGE_MOMENTS_NEGATIVE_EXPONENT, moments.zw, depth, min_standard_deviation);
    return umbrage_without_bleed(min(positive, negative));
}
