// Exponential shadow maps: the logarithm of the mean of e^(c z) (Annen et al. 2008, Salvi 2008). Depths are linear,
// 0 near the light and 1 far.

import constants::UMBRAGE_MOMENTS_EXPONENT;

/// What one depth is stored as.
fn umbrage_moments_of(depth: f32, slope: vec2f) -> vec4f {
    return vec4f(UMBRAGE_MOMENTS_EXPONENT * clamp(depth, 0.0, 1.0), 0.0, 0.0, 0.0);
}

/// The logarithm of nothing: its exponential is 0 beside any other.
fn umbrage_moments_none() -> vec4f {
    return vec4f(-1e30, 0.0, 0.0, 0.0);
}

/// log(e^a + w e^b), from the larger of the two, so that no exponential overflows. Weights of a mean add to 1.
fn umbrage_moments_add(sum: vec4f, moments: vec4f, weight: f32) -> vec4f {
    if weight < 1.1754944e-38 {
        return sum;
    }
    let summand = moments.x + log(weight);
    let low = min(sum.x, summand);
    let high = max(sum.x, summand);
    return vec4f(high + log(1.0 + exp(low - high)), 0.0, 0.0, 0.0);
}

/// How much light reaches a receiver, from 0 to 1. It asks for no least deviation.
fn umbrage_moments_visibility(moments: vec4f, depth: f32, min_standard_deviation: f32) -> f32 {
    return exp(min(moments.x - UMBRAGE_MOMENTS_EXPONENT * clamp(depth, 0.0, 1.0), 0.0));
}
