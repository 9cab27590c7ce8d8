//! What the importer left out, in one line a kind, however often it happened.

use crate::error::one_line;

/// How many things of a kind are named before the rest are counted.
const NAMED: usize = 8;

/// Kinds of things left out, with the first few that were and how many there were.
#[derive(Debug, Default)]
pub(super) struct Warnings(Vec<Warning>);

#[derive(Debug)]
struct Warning {
    what: &'static str,
    named: Vec<String>,
    count: usize,
}

impl Warnings {
    /// Notes that `what` happened to `subject`; once is enough.
    pub fn note(&mut self, what: &'static str, subject: &str) {
        let place = self.0.iter().position(|warning| warning.what == what).unwrap_or_else(|| {
            self.0.push(Warning { what, named: Vec::new(), count: 0 });
            self.0.len() - 1
        });
        let warning = &mut self.0[place];
        if warning.named.iter().any(|named| named == subject) {
            return;
        }
        warning.count += 1;
        if warning.named.len() < NAMED {
            warning.named.push(subject.to_owned());
        }
    }

    /// One line each, in the order in which they first happened.
    pub fn into_lines(self) -> Vec<String> {
        self.0
            .into_iter()
            .map(|Warning { what, named, count }| {
                let line = one_line(format!("{what}: {}", named.join(", ")));
                if count > named.len() { format!("{line} and {} more", count - named.len()) } else { line }
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
        for name in ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j"] {
            warnings.note("points are left out", name);
        }
        warnings.note("animations are ignored", "walk");
        assert_eq!(
            warnings.into_lines(),
            ["points are left out: a, b, c, d, e, f, g, h and 2 more", "animations are ignored: walk"]
        );
    }
}
