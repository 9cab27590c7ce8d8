// The most light that a mean and a mean square allow: Chebyshev's inequality, one-sided (Donnelly & Lauritzen 2006).
// Places are depths, or exponentials that grow with depth.

/// The largest share of a distribution that can lie at `place` or beyond it.
fn umbrage_largest_share_beyond(moments: vec2f, place: f32, min_standard_deviation: f32) -> f32 {
    // The smallest positive number keeps 0 / 0 away.
    let least = max(min_standard_deviation * min_standard_deviation, 1.1754944e-38);
    let variance = max(moments.y - moments.x * moments.x, least);
    let behind = max(place - moments.x, 0.0);
    return variance / (variance + behind * behind);
}
