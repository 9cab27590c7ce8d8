// Moments that are added as they are.

/// The sum of nothing, to begin a mean with.
fn umbrage_moments_none() -> vec4f {
    return vec4f(0.0);
}

/// A sum with one more summand. Weights are not negative; those of a mean add to 1.
fn umbrage_moments_add(sum: vec4f, moments: vec4f, weight: f32) -> vec4f {
    return sum + moments * weight;
}
