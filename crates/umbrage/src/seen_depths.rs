//! Between which view depths splits are placed, from what was seen in the frames before: the range grows at once, and shrinks late
//! and by steps, as sides of maps do, so that splits stay where they are. This file knows no GPU.

use std::ops::Range;

/// How many steps there are between a depth and its double.
const STEPS_AN_OCTAVE: f32 = 8.0;
/// For so many frames the range is too wide before it shrinks: half a second.
const LATE: u32 = 30;

/// A range in steps: it begins no later and ends no earlier than what was seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Steps {
    near: i32,
    far: i32,
}

/// The range that splits are placed in.
#[derive(Debug, Default)]
pub(crate) struct SeenDepths {
    taken: Option<Steps>,
    /// For so many frames less was seen than is taken, and this is all that was.
    late: Option<(u32, Steps)>,
}

impl Steps {
    fn of([near, far]: [f32; 2]) -> Self {
        let steps = |depth: f32| depth.log2() * STEPS_AN_OCTAVE;
        Self { near: steps(near).floor() as i32, far: steps(far).ceil() as i32 }
    }

    fn around(self, other: Self) -> Self {
        Self { near: self.near.min(other.near), far: self.far.max(other.far) }
    }

    /// Whether another range is so much narrower that it is that of another place.
    fn is_other_place(self, seen: Self) -> bool {
        let octave = STEPS_AN_OCTAVE as i32;
        seen.near > self.near + octave || seen.far < self.far - octave
    }
}

impl SeenDepths {
    /// Takes note of a frame's least and greatest view depth, metres; none where nothing was seen.
    pub fn note(&mut self, seen: Option<[f32; 2]>) {
        let Some(seen) = seen.map(Steps::of) else { return };
        let before = self.taken.unwrap_or(seen);
        let around = before.around(seen);
        if before.is_other_place(seen) {
            (self.taken, self.late) = (Some(seen), None);
        } else if around == seen || around != before {
            (self.taken, self.late) = (Some(around), None);
        } else {
            let (frames, least) =
                self.late.map_or((1, seen), |(frames, least)| (frames + 1, least.around(seen)));
            let is_due = frames >= LATE;
            self.taken = Some(if is_due { least } else { before });
            self.late = (!is_due).then_some((frames, least));
        }
    }

    /// The range, metres; `None` where nothing is known.
    pub fn range(&self) -> Option<Range<f32>> {
        let depth = |steps: i32| (steps as f32 / STEPS_AN_OCTAVE).exp2();
        self.taken.map(|Steps { near, far }| depth(near)..depth(far))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(frames: &[([f32; 2], u32)]) -> Option<Range<f32>> {
        let mut depths = SeenDepths::default();
        for (seen, count) in frames {
            (0..*count).for_each(|_| depths.note(Some(*seen)));
        }
        depths.range()
    }

    #[test]
    fn a_range_grows_at_once_and_shrinks_after_half_a_second() {
        assert_eq!(after(&[]), None);
        assert_eq!(after(&[([4.0, 64.0], 1)]), Some(4.0..64.0));
        assert_eq!(after(&[([4.0, 64.0], 9), ([2.0, 128.0], 1)]), Some(2.0..128.0));
        assert_eq!(after(&[([2.0, 128.0], 9), ([3.0, 100.0], 29)]), Some(2.0..128.0));
        let shrunk = after(&[([2.0, 128.0], 9), ([4.0, 64.0], 30)]);
        assert_eq!(shrunk, Some(4.0..64.0));
    }

    #[test]
    fn another_place_is_taken_at_once_and_nothing_changes_nothing() {
        assert_eq!(after(&[([1.0, 512.0], 9), ([1.0, 16.0], 1)]), Some(1.0..16.0));
        let mut depths = SeenDepths::default();
        depths.note(Some([2.0, 8.0]));
        depths.note(None);
        assert_eq!(depths.range(), Some(2.0..8.0));
    }
}
