//! The convex outline of everything that a map must hold, seen from the light.
//!
//! It grows a batch at a time: most boxes lie within the outline of those before them, and are told apart before any
//! corner of theirs is sorted. Space: x and y of light space.

use glam::DVec2;

use crate::hull::convex_hull;

/// Points gathered before the outline is drawn anew: sorting them costs about what testing against the outline saves.
const BATCH: usize = 64;

/// A convex polygon, counter-clockwise, that grows. Keeps its room when cleared.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outline {
    ring: Vec<DVec2>,
    /// Not yet in the ring.
    fresh: Vec<DVec2>,
}

impl Outline {
    /// Forgets all points, and keeps the room that they had.
    pub fn clear(&mut self) {
        self.ring.clear();
        self.fresh.clear();
    }

    /// Whether the rectangle `centre` ± `half` lies in what was drawn so far.
    pub fn holds(&self, centre: DVec2, half: DVec2) -> bool {
        self.ring.len() >= 3
            && edges(&self.ring).all(|(a, b)| {
                let inward = (b - a).perp();
                inward.dot(centre - a) >= inward.abs().dot(half)
            })
    }

    /// Adds a point, which the outline then holds.
    pub fn add(&mut self, point: DVec2) {
        self.fresh.push(point);
        if self.fresh.len() >= BATCH.max(self.ring.len()) {
            self.draw();
        }
    }

    /// The polygon around all points; fewer than three corners where they are on a line.
    pub fn corners(&mut self) -> &[DVec2] {
        if !self.fresh.is_empty() {
            self.draw();
        }
        &self.ring
    }

    fn draw(&mut self) {
        self.fresh.extend_from_slice(&self.ring);
        self.ring.resize(2 * self.fresh.len(), DVec2::ZERO);
        let len = convex_hull(&mut self.fresh, &mut self.ring);
        self.ring.truncate(len);
        self.fresh.clear();
    }
}

/// The sides of a closed polygon.
fn edges(ring: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
    ring.iter().copied().zip(ring.iter().copied().cycle().skip(1))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn outline_of(points: &[DVec2]) -> Outline {
        let mut outline = Outline::default();
        points.iter().for_each(|point| outline.add(*point));
        outline.draw();
        outline
    }

    #[test]
    fn a_square_with_a_crowd_inside_has_four_corners() {
        let crowd = (0..400).map(|i| DVec2::new((i % 20) as f64, (i / 20) as f64)).collect::<Vec<_>>();
        let mut outline = outline_of(&crowd);
        let square = [(0.0, 0.0), (19.0, 0.0), (19.0, 19.0), (0.0, 19.0)].map(|(x, y)| DVec2::new(x, y));
        assert_eq!(outline.corners(), square);
        assert!(outline.holds(DVec2::splat(9.5), DVec2::splat(9.5)), "the square itself");
        assert!(!outline.holds(DVec2::splat(9.5), DVec2::new(9.6, 1.0)), "a wider one");
    }

    #[test]
    fn no_points_one_point_and_a_line_are_outlines_that_hold_nothing() {
        let line = (0..100).map(|i| DVec2::splat(f64::from(i))).collect::<Vec<_>>();
        for points in [&line[..0], &line[..1], &line[..]] {
            let mut outline = outline_of(points);
            let ends = [points.first(), points.last()].map(Option::<&DVec2>::copied);
            assert!(ends.into_iter().flatten().all(|end| outline.corners().contains(&end)), "{outline:?}");
            assert!(outline.corners().len() <= 2, "{outline:?}");
            assert!(!outline.holds(DVec2::splat(0.5), DVec2::ZERO), "{outline:?}");
        }
    }

    proptest! {
        #[test]
        fn every_point_lies_within_and_every_corner_is_a_point(
            points in proptest::collection::vec((-9.0f64..9.0, -9.0f64..9.0).prop_map(DVec2::from), 3..300),
        ) {
            let outline = outline_of(&points);
            prop_assert!(outline.ring.iter().all(|corner| points.contains(corner)), "{outline:?}");
            for (a, b) in edges(&outline.ring) {
                let outermost = points.iter().map(|p| (b - a).perp_dot(*p - a)).fold(f64::INFINITY, f64::min);
                prop_assert!(outermost > -1e-9, "{outermost} outside of {a}, {b}");
            }
        }
    }
}
