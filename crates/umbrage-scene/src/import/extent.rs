//! Boxes in f64, and which of many boxes are the scene and which are strays.
//!
//! Space: world space, metres.

use glam::{DMat4, DVec3};

use crate::Aabb;

/// A box farther from the others than so many of their diagonals is a stray: from where all of the others fill a picture,
/// it is a speck, and from where it is seen as well, they are.
const STRAY_DIAGONALS: f64 = 8.0;

/// An axis-aligned box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    pub min: DVec3,
    pub max: DVec3,
}

impl Extent {
    pub const EMPTY: Self = Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    pub fn of(bounds: Aabb) -> Self {
        Self { min: bounds.min.as_dvec3(), max: bounds.max.as_dvec3() }
    }

    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The box with so much room around it.
    pub fn widened(self, by: f64) -> Self {
        Self { min: self.min - by, max: self.max + by }
    }

    pub fn centre(&self) -> DVec3 {
        self.min * 0.5 + self.max * 0.5
    }

    /// Half the diagonal.
    pub fn radius(&self) -> f64 {
        (self.max * 0.5 - self.min * 0.5).length()
    }

    /// The farthest that a coordinate is from 0.
    pub fn reach(&self) -> f64 {
        self.min.abs().max(self.max.abs()).max_element()
    }

    /// The distance between two boxes; 0 where they touch.
    fn distance(&self, other: &Self) -> f64 {
        (self.min - other.max).max(other.min - self.max).max(DVec3::ZERO).length()
    }

    /// The box around this box after an affine transform, as [`Aabb::transformed`].
    pub fn transformed(&self, matrix: &DMat4) -> Self {
        let mut min = matrix.w_axis.truncate();
        let mut max = min;
        for (axis, low, high) in [
            (matrix.x_axis, self.min.x, self.max.x),
            (matrix.y_axis, self.min.y, self.max.y),
            (matrix.z_axis, self.min.z, self.max.z),
        ] {
            let (a, b) = (axis.truncate() * low, axis.truncate() * high);
            min += a.min(b);
            max += a.max(b);
        }
        Self { min, max }
    }
}

/// The box around everything.
pub(super) fn around(boxes: &[Extent]) -> Extent {
    boxes.iter().fold(Extent::EMPTY, |sum, &other| sum.union(other))
}

/// The box around everything but strays. More than half of the boxes, the nearest to the middle of them all, are the scene
/// without question; the others join it from the nearest on, until one lies more than [`STRAY_DIAGONALS`] away.
pub(super) fn around_most(boxes: &[Extent]) -> Extent {
    let Some(start) = middle(boxes) else {
        return Extent::EMPTY;
    };
    let mut order: Vec<(f64, usize)> = boxes.iter().map(|other| start.distance(other)).zip(0..).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    // More than half, except of two.
    let core = if boxes.len() == 2 { 1 } else { boxes.len() / 2 + 1 };
    let mut sum = Extent::EMPTY;
    for (rank, (_, i)) in order.into_iter().enumerate() {
        let next = boxes[i];
        if rank >= core && sum.distance(&next) > STRAY_DIAGONALS * 2.0 * sum.radius() {
            break;
        }
        sum = sum.union(next);
    }
    sum
}

/// The box whose middle is nearest to the median of all; of two, the larger.
fn middle(boxes: &[Extent]) -> Option<Extent> {
    if let [a, b] = boxes {
        return Some(if b.radius() > a.radius() { *b } else { *a });
    }
    let mut median = DVec3::ZERO;
    for axis in 0..3 {
        let mut along: Vec<f64> = boxes.iter().map(|one| one.centre()[axis]).collect();
        if along.is_empty() {
            return None;
        }
        let half = along.len() / 2;
        median[axis] = *along.select_nth_unstable_by(half, f64::total_cmp).1;
    }
    let far = |one: &Extent| one.centre().distance_squared(median);
    boxes.iter().min_by(|a, b| far(a).total_cmp(&far(b))).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube(x: f64, half: f64) -> Extent {
        let centre = DVec3::X * x;
        Extent { min: centre - half, max: centre + half }
    }

    #[test]
    fn a_stray_is_left_out_and_neighbours_are_not() {
        let town: Vec<Extent> = (0..9).map(|i| cube(f64::from(i) * 20.0, 5.0)).collect();
        assert_eq!(around_most(&town), around(&town));
        for stray in [cube(9000.0, 1.0), cube(-9000.0, 400.0)] {
            assert_eq!(around_most(&[&town[..], &[stray]].concat()), around(&town), "{stray:?}");
        }
        let farm = cube(1000.0, 5.0);
        assert_eq!(around_most(&[&town[..], &[farm]].concat()).max.x, 1005.0, "within eight diagonals");
    }

    #[test]
    fn a_ground_and_one_stray_are_told_apart_by_size() {
        let (ground, stray) = (cube(0.0, 20.0), cube(9000.0, 1.0));
        for boxes in [[ground, stray], [stray, ground]] {
            assert_eq!(around_most(&boxes), ground);
        }
    }

    #[test]
    fn two_villages_alike_are_both_the_scene() {
        let village = |x: f64| [cube(x, 5.0), cube(x + 20.0, 5.0), cube(x + 40.0, 5.0)];
        let boxes = [village(0.0), village(1200.0)].concat();
        assert_eq!(around_most(&boxes), around(&boxes));
    }

    #[test]
    fn what_holds_everything_is_no_stray() {
        let boxes = [cube(0.0, 1.0), cube(3.0, 1.0), cube(-4.0, 1.0), cube(0.0, 5000.0)];
        assert_eq!(around_most(&boxes), cube(0.0, 5000.0));
        assert_eq!(around_most(&[]), Extent::EMPTY);
    }
}
