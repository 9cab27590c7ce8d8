//! The history holds the settings that there were, so that changes are undone and redone.

use umbrage::Settings;

/// Of more steps back the oldest are forgotten.
const MOST: usize = 200;

/// The settings of both sides.
pub type Sides = [Settings; 2];

/// The history is what can be undone and redone. A slider that is dragged is one step, however often its value changes.
#[derive(Clone, Debug, Default)]
pub struct History {
    past: Vec<Sides>,
    future: Vec<Sides>,
    /// Whether changes still belong to the last step.
    is_open: bool,
}

impl History {
    /// Remembers the settings before a change.
    pub fn record(&mut self, before: Sides) {
        if !self.is_open {
            self.past.push(before);
            let too_many = self.past.len().saturating_sub(MOST);
            self.past.drain(..too_many);
        }
        self.future.clear();
        self.is_open = true;
    }

    /// Ends the step: the next change is another one.
    pub fn close_step(&mut self) {
        self.is_open = false;
    }

    /// Goes a step back from the settings that there are now; `None` where there is none.
    pub fn undo(&mut self, now: Sides) -> Option<Sides> {
        let before = self.past.pop()?;
        self.future.push(now);
        self.is_open = false;
        Some(before)
    }

    /// Goes a step forth again; `None` where nothing was undone.
    pub fn redo(&mut self, now: Sides) -> Option<Sides> {
        let after = self.future.pop()?;
        self.past.push(now);
        self.is_open = false;
        Some(after)
    }

    /// Returns whether there is something to undo.
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Returns whether there is something to redo.
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(splits: u32) -> Sides {
        [0, 1].map(|_| Settings { splits, ..Settings::default() })
    }

    #[test]
    fn steps_go_back_and_forth_and_a_drag_is_one_of_them() {
        let mut history = History::default();
        assert_eq!(history.undo(of(4)), None);
        history.record(of(4));
        history.close_step();
        // A drag from 3 over 5 to 7.
        history.record(of(3));
        history.record(of(5));
        history.close_step();
        assert_eq!(history.undo(of(7)), Some(of(3)));
        assert_eq!(history.undo(of(3)), Some(of(4)));
        assert!(!history.can_undo() && history.can_redo());
        assert_eq!(history.redo(of(4)), Some(of(3)));
        // Another change forgets what was undone.
        history.record(of(3));
        assert!(!history.can_redo());
    }

    #[test]
    fn the_oldest_steps_are_forgotten() {
        let mut history = History::default();
        for _ in 0..MOST + 50 {
            history.record(of(4));
            history.close_step();
        }
        assert_eq!(history.past.len(), MOST);
    }
}
