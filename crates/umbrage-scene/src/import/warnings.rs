//! What the importer left out, in one line a kind, however often it happened.

use crate::error::one_line;

/// Kinds of things left out, with the first that was and how many there were.
#[derive(Debug, Default)]
pub(super) struct Warnings(Vec<Warning>);

#[derive(Debug)]
struct Warning {
    what: &'static str,
    first: String,
    count: usize,
}

impl Warnings {
    /// Notes that `what` happened to `subject`.
    pub fn note(&mut self, what: &'static str, subject: &str) {
        match self.0.iter_mut().find(|warning| warning.what == what) {
            Some(warning) => warning.count += 1,
            None => self.0.push(Warning { what, first: subject.to_owned(), count: 1 }),
        }
    }

    /// One line each, in the order in which they first happened.
    pub fn into_lines(self) -> Vec<String> {
        self.0
            .into_iter()
            .map(|Warning { what, first, count }| match count {
                1 => one_line(format!("{what}: {first}")),
                _ => format!("{} and {} more", one_line(format!("{what}: {first}")), count - 1),
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_of_a_kind_are_one_line() {
        let mut warnings = Warnings::default();
        for name in ["a", "b", "c"] {
            warnings.note("points are left out", name);
        }
        warnings.note("animations are ignored", "walk");
        assert_eq!(
            warnings.into_lines(),
            ["points are left out: a and 2 more", "animations are ignored: walk"]
        );
    }
}
