//! The room that something takes that moves: a box that grows at once and by steps, and shrinks late. So plans that hold it
//! stay the same from frame to frame, and with them what is kept of them.

use umbrage::Aabb;

/// A reach grows beyond what left it by this share of that one's size.
const STEP: f32 = 0.25;

/// After so many moves a reach shrinks to what these took, if that is less than half of it.
const MOVES: u64 = 64;

/// The room that one thing takes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    pub aabb: Aabb,
    /// What was taken since a move, and the number of that.
    recent: Aabb,
    since: u64,
}

impl Reach {
    /// The reach of what stands in a box and has not moved.
    pub fn of(aabb: Aabb) -> Self {
        Self { aabb, recent: aabb, since: 0 }
    }

    /// Takes note of a move into a box. The first is as good as a place to start from, and so is one that is far from all that
    /// came before.
    pub fn move_to(&mut self, aabb: Aabb, moves: u64) {
        let is_far = !touch(&self.aabb, &aabb);
        if self.since == 0 || is_far || aabb.is_empty() {
            *self = Self { aabb, recent: aabb, since: moves };
            return;
        }
        self.recent = self.recent.union(aabb);
        if !holds(&self.aabb, &aabb) {
            let step = STEP * (aabb.max - aabb.min);
            let grown = Aabb {
                min: glam::Vec3::select(aabb.min.cmplt(self.aabb.min), aabb.min - step, self.aabb.min),
                max: glam::Vec3::select(aabb.max.cmpgt(self.aabb.max), aabb.max + step, self.aabb.max),
            };
            self.aabb = grown;
        }
        if moves - self.since >= MOVES {
            if 2.0 * size(&self.recent) < size(&self.aabb) {
                self.aabb = self.recent;
            }
            (self.recent, self.since) = (aabb, moves);
        }
    }
}

fn touch(a: &Aabb, b: &Aabb) -> bool {
    a.min.cmple(b.max).all() && b.min.cmple(a.max).all()
}

fn holds(outer: &Aabb, inner: &Aabb) -> bool {
    outer.min.cmple(inner.min).all() && outer.max.cmpge(inner.max).all()
}

/// The sum of the sides.
fn size(aabb: &Aabb) -> f32 {
    (aabb.max - aabb.min).element_sum()
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    fn at(x: f32) -> Aabb {
        Aabb { min: Vec3::new(x, 0.0, 0.0), max: Vec3::new(x + 1.0, 1.0, 1.0) }
    }

    #[test]
    fn what_goes_to_and_fro_has_one_reach_after_a_while() {
        let mut reach = Reach::of(at(0.0));
        let mut changes = Vec::new();
        for moves in 1..400 {
            let before = reach.aabb;
            let place = at((moves as f32 * 0.1).sin());
            reach.move_to(place, moves);
            assert!(holds(&reach.aabb, &place), "{moves}");
            if reach.aabb != before {
                changes.push(moves);
            }
        }
        assert!(changes.len() < 20 && changes.last() < Some(&100), "{changes:?}");
    }

    #[test]
    fn what_walks_is_not_followed_by_all_of_its_way() {
        let mut reach = Reach::of(at(0.0));
        let mut changes = 0;
        for moves in 1..1000 {
            let before = reach.aabb;
            reach.move_to(at(0.05 * moves as f32), moves);
            changes += usize::from(reach.aabb != before);
            assert!(size(&reach.aabb) < 20.0, "{moves}: {:?}", reach.aabb);
        }
        assert!(changes < 400, "{changes}");
    }

    #[test]
    fn a_jump_starts_anew_and_so_does_the_first_move() {
        let mut reach = Reach::of(at(0.0));
        reach.move_to(at(0.5), 1);
        assert_eq!(reach.aabb, at(0.5));
        reach.move_to(at(50.0), 2);
        assert_eq!(reach.aabb, at(50.0));
        reach.move_to(Aabb::EMPTY, 3);
        assert!(reach.aabb.is_empty());
        reach.move_to(at(50.0), 4);
        assert_eq!(reach.aabb, at(50.0));
    }
}
