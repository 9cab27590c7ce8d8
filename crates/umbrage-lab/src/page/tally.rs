//! What the verdicts on one claim come to together, in words.

use super::verdict::{Check, Verdict};

/// How many checks of a claim came to which verdict.
#[derive(Clone, Copy, Default)]
pub(super) struct Tally {
    pub holds: usize,
    pub fails: usize,
    pub open: usize,
    /// Checks without any ratio: nothing was measured, or no pixel is judged.
    pub missing: usize,
}

/// Counts the verdicts of some checks.
pub(super) fn tally(checks: &[Check]) -> Tally {
    let mut tally = Tally::default();
    for check in checks {
        match check.verdict {
            Verdict::Holds => tally.holds += 1,
            Verdict::DoesNotHold => tally.fails += 1,
            Verdict::NotDecided if check.ratios.samples.is_empty() => tally.missing += 1,
            Verdict::NotDecided => tally.open += 1,
        }
    }
    tally
}

impl Verdict {
    /// Its class in the style sheet, and what the page says.
    pub(super) fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Holds => ("holds", "holds"),
            Self::DoesNotHold => ("fails", "does not hold"),
            Self::NotDecided => ("open", "not decided"),
        }
    }
}

impl Tally {
    pub fn holds_everywhere(self) -> bool {
        self.holds > 0 && self.fails == 0 && self.open == 0
    }

    /// The class in the style sheet, and the words.
    pub fn badge(self) -> (&'static str, &'static str) {
        match (self.holds, self.fails) {
            (_, 0) if self.holds_everywhere() => ("holds", "holds"),
            (0, 1..) => ("fails", "does not hold"),
            (1.., 1..) => ("fails", "holds in part"),
            (1.., 0) => ("open", "holds in part"),
            (0, 0) => ("open", "not decided"),
        }
    }

    /// The counts in a sentence.
    pub fn text(self) -> String {
        let Self { holds, fails, open, missing } = self;
        let all = holds + fails + open;
        let parts = [(holds, "holds"), (fails, "does not hold"), (open, "is not decided")];
        let parts: Vec<String> = parts
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, words)| format!("{words} in {count} of {all}"))
            .collect();
        let verdicts = if parts.is_empty() { String::new() } else { format!("It {}.", parts.join(", ")) };
        let without = if missing == 0 { String::new() } else { format!(" No ratio in {missing}.") };
        verdicts + &without
    }
}
