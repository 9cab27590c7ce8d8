//! How to rotate a map about its light, so that its texels are the smallest.
//!
//! The coarser side of a texel decides how far a lookup must stand off and how ragged an edge is, so the longer side of
//! the rectangle is what counts. The rectangle of the smallest area (Freeman & Shapira 1975, Toussaint 1983) is often
//! long and thin: measured over all worlds, its errors are 7 to 19 % larger. Space: x and y of light space.

use glam::DVec2;

/// How a map is rotated about its light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rotation {
    /// As the light's axes lie.
    None,
    /// So that its texels are the smallest.
    SmallestTexels,
    /// The same, by a whole number of [`STEP_OF_SAMPLES`]: the number stays while the points turn a little.
    Steps,
}

/// How many steps there are in a right angle for [`Rotation::Steps`]: the longer side of a rectangle grows by at most itself a
/// radian, so half a step costs 5 %.
pub(crate) const STEPS_OF_SAMPLES: u32 = 16;
/// The angle of such a step.
const STEP_OF_SAMPLES: f64 = std::f64::consts::FRAC_PI_2 / STEPS_OF_SAMPLES as f64;

/// The unit direction of a number of such steps. Past a right angle the same rectangles come again.
pub(crate) fn direction_of_steps(steps: u32) -> DVec2 {
    DVec2::from_angle(f64::from(steps % STEPS_OF_SAMPLES) * STEP_OF_SAMPLES)
}

/// The number of steps whose direction is nearest to a unit direction.
pub(crate) fn steps_of_direction(right: DVec2) -> u32 {
    (right.to_angle() / STEP_OF_SAMPLES).round().rem_euclid(f64::from(STEPS_OF_SAMPLES)) as u32
}

impl Rotation {
    /// The unit direction that becomes right on a map around these points.
    pub fn right(self, points: &[DVec2]) -> DVec2 {
        match self {
            Self::None => DVec2::X,
            Self::SmallestTexels => smallest_texels(points),
            Self::Steps => smallest_of_steps(points),
        }
    }
}

/// Rotations tried to either side. Past 45° the same rectangles come again.
const STEPS: usize = 45;
/// The angle between two rotations. The longer side grows by at most itself a radian, so half a step costs less than 1 %.
const STEP: f64 = std::f64::consts::FRAC_PI_4 / STEPS as f64;
/// A rotation must win by this share: where two are as good, rounding must not choose another one every frame.
const WIN: f64 = 1e-3;

/// The unit direction along which a rectangle around `points` has its sides, chosen so that the longer one is short.
/// Small rotations go first; there is none where there is nothing to win.
fn smallest_texels(points: &[DVec2]) -> DVec2 {
    let step = DVec2::from_angle(STEP);
    let (mut best, mut min_length) = (DVec2::X, longer_side(points, DVec2::X));
    let mut rotation = DVec2::X;
    for _ in 0..STEPS {
        rotation = step.rotate(rotation);
        for side in [rotation, DVec2::new(rotation.x, -rotation.y)] {
            let length = longer_side(points, side);
            if length < min_length * (1.0 - WIN) {
                (best, min_length) = (side, length);
            }
        }
    }
    best
}

/// The direction of a whole number of steps with the smallest texels; the fewest steps where several are as good.
fn smallest_of_steps(points: &[DVec2]) -> DVec2 {
    let (mut best, mut min_length) = (DVec2::X, longer_side(points, DVec2::X));
    for side in (1..STEPS_OF_SAMPLES).map(direction_of_steps) {
        let length = longer_side(points, side);
        if length < min_length * (1.0 - WIN) {
            (best, min_length) = (side, length);
        }
    }
    best
}

/// The longer side of the rectangle around points whose sides lie along `side`.
fn longer_side(points: &[DVec2], side: DVec2) -> f64 {
    let (min, max) = points.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(min, max), p| {
        let rotated = DVec2::new(p.dot(side), p.dot(side.perp()));
        (min.min(rotated), max.max(rotated))
    });
    (max - min).max_element()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn rotated_by(degrees: f64, points: &[(f64, f64)]) -> Vec<DVec2> {
        let rotation = DVec2::from_angle(degrees.to_radians());
        points.iter().map(|&(x, y)| rotation.rotate(DVec2::new(x, y))).collect()
    }

    #[test]
    fn a_rotated_square_is_found() {
        let square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
        for degrees in [-30.0, 0.0, 17.0, 45.0] {
            let points = rotated_by(degrees, &square);
            let length = longer_side(&points, smallest_texels(&points));
            assert!((length - 10.0).abs() < 1e-9, "{degrees}°: {length}");
        }
    }

    #[test]
    fn a_line_lies_along_the_diagonal() {
        let points = rotated_by(20.0, &[(0.0, 0.0), (100.0, 0.0)]);
        let length = longer_side(&points, smallest_texels(&points));
        assert!((length - 100.0 * std::f64::consts::FRAC_1_SQRT_2).abs() < 1e-9, "{length}");
    }

    #[test]
    fn no_points_and_one_point_are_not_rotated() {
        assert_eq!(smallest_texels(&[]), DVec2::X);
        assert_eq!(smallest_texels(&[DVec2::new(3.0, -4.0)]), DVec2::X);
    }

    #[test]
    fn a_rotation_that_is_no_better_is_not_taken() {
        // A box seen along its axis is as good a square 30° to the left as 30° to the right.
        let hexagon: Vec<DVec2> =
            (0..6).map(|i| DVec2::from_angle(f64::from(i).to_radians() * 60.0)).collect();
        let side = smallest_texels(&hexagon);
        let shaken: Vec<DVec2> = hexagon.iter().map(|p| *p * (1.0 + 1e-9 * p.y)).collect();
        assert_eq!(smallest_texels(&shaken), side);
    }

    proptest! {
        #[test]
        fn none_of_180_rotations_is_better_by_a_hundredth(
            points in proptest::collection::vec((-9.0f64..9.0, -5.0f64..5.0).prop_map(DVec2::from), 2..40),
        ) {
            let found = longer_side(&points, smallest_texels(&points));
            for half_degrees in 0..180 {
                let rotation = DVec2::from_angle((0.5 * f64::from(half_degrees)).to_radians());
                let length = longer_side(&points, rotation);
                prop_assert!(found <= 1.01 * length, "{found}, but {length} at {half_degrees} half degrees");
            }
        }
    }
}
