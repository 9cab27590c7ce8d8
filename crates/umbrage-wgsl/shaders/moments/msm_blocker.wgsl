// What lies before a receiver, from moments of depth (Peters et al. 2017).

import constants::UMBRAGE_MOMENTS_LEAST_SHARE;
import package::moments::msm::{umbrage_deltas, umbrage_shares_before};

/// What share of the depths lies before a receiver, and their mean. A share of 0, and the receiver's depth, where less
/// than UMBRAGE_MOMENTS_LEAST_SHARE does.
fn umbrage_moments_blocker(moments: vec4f, depth: f32) -> vec2f {
    let z = clamp(depth, 0.0, 1.0);
    let deltas = umbrage_deltas(moments, z);
    let before = umbrage_shares_before(deltas);
    let share = before.x + before.y + before.z;
    if share <= UMBRAGE_MOMENTS_LEAST_SHARE {
        return vec2f(0.0, z);
    }
    let place = dot(before, deltas.places) / share;
    return vec2f(share, clamp(0.5 + 0.5 * (deltas.mean + deltas.deviation * place), 0.0, z));
}
