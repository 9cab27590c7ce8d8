// Moment shadow maps: four powers of depth (Peters & Klein 2015, Peters et al. 2017), and the three depths that explain them with
// the most light. Depths are linear, 0 near the light and 1 far; the powers are of depths −1…1.
// `crates/umbrage-core/src/moments/msm.rs` derives the steps.

import constants::{UMBRAGE_MOMENTS_BIAS, UMBRAGE_MOMENTS_CENTRE};
import package::moments::light_bleed_reduction::umbrage_without_bleed;
import package::moments::mean::{umbrage_moments_add, umbrage_moments_none};

const UMBRAGE_ROOT_OF_3: f32 = 1.7320508;

/// Three depths that have the moments of a texel.
struct UmbrageDeltas {
    /// Mean of depths −1…1.
    mean: f32,
    /// Root of the mean square about it.
    deviation: f32,
    /// Where they are, from the mean, in deviations. The first is the receiver's.
    places: vec3f,
    /// What share of the texel each has. They add to 1.
    shares: vec3f,
}

/// What one depth is stored as: its powers, mixed so that each channel fills 0…1.
fn umbrage_moments_of(depth: f32, slope: vec2f) -> vec4f {
    let z = 2.0 * clamp(depth, 0.0, 1.0) - 1.0;
    let square = z * z;
    let cube = square * z;
    return vec4f(
        1.5 * z - 2.0 * cube + 0.5,
        4.0 * (square - square * square),
        UMBRAGE_ROOT_OF_3 * (0.5 * z - 2.0 / 9.0 * cube) + 0.5,
        0.5 * (square + square * square),
    );
}

/// The means of z, z², z³ and z⁴, with the bias.
fn umbrage_powers(moments: vec4f) -> vec4f {
    let stored = clamp(moments, vec4f(0.0), vec4f(1.0));
    let x = stored.x - 0.5;
    let z = stored.z - 0.5;
    let powers = vec4f(
        UMBRAGE_ROOT_OF_3 * z - x / 3.0,
        stored.w + 0.125 * stored.y,
        0.75 * (UMBRAGE_ROOT_OF_3 * z - x),
        stored.w - 0.125 * stored.y,
    );
    let centre = vec4f(0.0, UMBRAGE_MOMENTS_CENTRE, 0.0, UMBRAGE_MOMENTS_CENTRE);
    return powers + (centre - powers) * UMBRAGE_MOMENTS_BIAS;
}

/// a / b, bounded where b is next to nothing.
fn umbrage_bounded_ratio(a: f32, b: f32) -> f32 {
    let size = max(abs(b), 1e-20);
    return clamp(a / select(size, -size, b < 0.0), -1e6, 1e6);
}

fn umbrage_deltas(moments: vec4f, depth: f32) -> UmbrageDeltas {
    let b = umbrage_powers(moments);
    // What the bias alone comes to. Less is rounding, as is a bias of less than a rounding step.
    let bias = max(UMBRAGE_MOMENTS_BIAS, 1.1920929e-7);
    let variance = max(b.y - b.x * b.x, bias * UMBRAGE_MOMENTS_CENTRE);
    let covariance = b.z - b.x * b.y;
    let least_residue = bias * (UMBRAGE_MOMENTS_CENTRE - UMBRAGE_MOMENTS_CENTRE * UMBRAGE_MOMENTS_CENTRE);
    let residue = max(b.w - b.y * b.y - covariance * covariance / variance, least_residue);

    let deviation = sqrt(variance);
    // No two depths are more than 2 apart.
    let steepest = 2.0 / deviation;
    let skewness = clamp((covariance / variance - 2.0 * b.x) / deviation, -steepest, steepest);
    let rho = residue / (variance * variance);

    // K(receiver, u) as a u² + b u + c, made so small that no square overflows.
    let receiver = (2.0 * clamp(depth, 0.0, 1.0) - 1.0 - b.x) / deviation;
    let at_receiver = receiver * receiver - skewness * receiver - 1.0;
    let scale = 1.0 / (rho + abs(at_receiver));
    let a = at_receiver * scale;
    let rest = rho * scale;
    let linear = rest * receiver - a * skewness;
    let constant = rest - a;
    let root = sqrt(max(linear * linear - 4.0 * a * constant, 0.0));
    let half = -0.5 * (linear + select(root, -root, linear < 0.0));
    let places = vec3f(receiver, umbrage_bounded_ratio(half, a), umbrage_bounded_ratio(constant, half));

    let residues = places * places - skewness * places - 1.0;
    let shares = 1.0 / (1.0 + places * places + residues * residues / rho);
    return UmbrageDeltas(b.x, deviation, places, shares / (shares.x + shares.y + shares.z));
}

/// The shares of those before the receiver; 0 for the others.
fn umbrage_shares_before(deltas: UmbrageDeltas) -> vec3f {
    return select(vec3f(0.0), deltas.shares, deltas.places < vec3f(deltas.places.x));
}

/// How much light reaches a receiver, from 0 to 1. It asks for no least deviation.
fn umbrage_moments_visibility(moments: vec4f, depth: f32, min_standard_deviation: f32) -> f32 {
    let before = umbrage_shares_before(umbrage_deltas(moments, depth));
    return umbrage_without_bleed(1.0 - (before.x + before.y + before.z));
}
