//! Trapezoidal shadow maps: the nearest part of the view gets four fifths of the map.
//!
//! Martin & Tan, *Anti-aliasing and Continuity with Trapezoidal Shadow Maps*, EGSR 2004. Paper → here: λ → `length`,
//! δ' → the height of the focus on the map, ξ → [`LINE`], η → the distance. The trapezoid's centre line is the line of
//! sight, and its top line lies on the nearest receivers. The paper leaves the focus to its user. Here it is the depth before
//! which four fifths of an ideal map lie, a logarithmic one: so a shallow slice is warped little, and a deep one much.

use super::frame::WarpFrame;

/// Where on the map the focus comes to lie: −1 is its far end and 1 the near one, so four fifths lie before it.
const LINE: f64 = -0.6;
/// A focus at four fifths of the map is there already; beyond it there is nothing to warp.
const FARTHEST_FOCUS: f64 = 0.79;
/// Nearer foci would leave the rest of the map next to nothing.
const NEAREST_FOCUS: f64 = 0.01;

/// How far behind the nearest receivers the line at infinity lies.
pub(super) fn distance(frame: &WarpFrame<'_>) -> Option<f64> {
    let depths = frame.receiver_depths();
    let share = 0.5 - 0.5 * LINE;
    let focus = frame.height_at(depths.start * (depths.end / depths.start).powf(share))? / frame.length;
    Some(trapezoid(frame.length, frame.length * focus.clamp(NEAREST_FOCUS, FARTHEST_FOCUS)))
}

/// η of the paper, for a map of `length` with the focus at `focus` from the top line, below four fifths of the length.
fn trapezoid(length: f64, focus: f64) -> f64 {
    length * focus * (1.0 + LINE) / (length * (1.0 - LINE) - 2.0 * focus)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_at_infinity_is_that_of_v8() {
        for (focus, distance) in [
            (0.1, 0.028571),
            (0.2, 0.066667),
            (0.3, 0.12),
            (0.4, 0.2),
            (0.52, 0.371429),
            (0.6, 0.6),
            (0.7, 1.4),
            (0.79, 15.8),
        ] {
            let got = trapezoid(1.0, focus);
            assert!((got - distance).abs() < 1e-6, "{focus}: {got}, not {distance}");
            // The warped map runs from the top line to the base line; the focus comes to lie at four fifths.
            let warped = |y: f64| y / (1.0 + y / got);
            let share = warped(focus) / warped(1.0);
            assert!((1.0 - 2.0 * share - LINE).abs() < 1e-9, "{focus}: the focus is at {share}");
        }
    }
}
