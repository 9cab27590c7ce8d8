//! How far the reading of a file is, told to whoever waits for it.

use std::fmt::{self, Debug, Display, Formatter};

/// A step says what is being read of a file, and how far that is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// What is being read, in the plural: "pictures".
    pub what: &'static str,
    /// How many of them are read.
    pub done: usize,
    /// How many of them there are.
    pub of: usize,
}

impl Display for Step {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} of {}", self.what, (self.done + 1).min(self.of), self.of)
    }
}

/// Who is told of steps.
#[derive(Clone, Copy)]
pub(super) struct Progress<'a>(pub &'a dyn Fn(Step));

impl Progress<'_> {
    /// Tells that `done` of so many things of a kind are read, and that the next one is begun.
    pub fn step(&self, what: &'static str, done: usize, of: usize) {
        self.0(Step { what, done, of });
    }
}

impl Debug for Progress<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("Progress")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_count_from_one_for_people() {
        let lines = std::cell::RefCell::new(Vec::new());
        let tell = |step: Step| lines.borrow_mut().push(step.to_string());
        let progress = Progress(&tell);
        for done in 0..=2 {
            progress.step("pictures", done, 2);
        }
        assert_eq!(lines.into_inner(), ["pictures 1 of 2", "pictures 2 of 2", "pictures 2 of 2"]);
    }
}
