//! Where in an experiment's file a key stands, so that every refusal can name its line.

use std::fmt::Display;
use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::Experiment;
use crate::LabError;
use crate::settings::{fault, one_line};
use umbrage_interchange::line_of;

/// An experiment's file, parsed as TOML.
pub struct Source<'a> {
    path: &'a Path,
    text: &'a str,
    root: Spanned<DeTable<'a>>,
}

/// Keys of before, by what they are in (nothing is the file itself), and what each is called now.
const RENAMED: [(&str, &str, &str); 2] = [("", "ways", "variants"), ("claims", "way", "variant")];

/// A step down from a table or an array.
#[derive(Clone, Copy)]
pub enum Step<'a> {
    Key(&'a str),
    Item(usize),
}

impl<'a> Source<'a> {
    /// Parses the text of the file at `path`.
    pub fn new(path: &'a Path, text: &'a str) -> Result<Self, LabError> {
        let root = DeTable::parse(text).map_err(|why| {
            let line = line_of(text, why.span().map_or(0, |span| span.start));
            refused(path, line, key_on(text, line), why.message())
        })?;
        Ok(Self { path, text, root })
    }

    /// The experiment that it holds, of which only the shape is checked.
    pub fn experiment(&self) -> Result<Experiment, LabError> {
        self.check_names()?;
        toml::from_str(self.text).map_err(|why: toml::de::Error| {
            let line = line_of(self.text, why.span().map_or(0, |span| span.start));
            let (key, wrong) = fault(why);
            refused(self.path, line, key, wrong)
        })
    }

    /// Refuses keys of before, each with its name of today.
    fn check_names(&self) -> Result<(), LabError> {
        let root = self.root.get_ref();
        for (list, old, new) in RENAMED {
            let wrong = format!("`{old}` is now `{new}`");
            if list.is_empty() {
                if root.contains_key(old) {
                    return Err(self.refusal(&[Step::Key(old)], wrong));
                }
                continue;
            }
            let items = DeTable::get(root, list).and_then(|value| value.get_ref().as_array());
            let is_old = |item: &Spanned<DeValue<'_>>| {
                item.get_ref().as_table().is_some_and(|table| table.contains_key(old))
            };
            if let Some(i) = items.and_then(|items| items.iter().position(is_old)) {
                return Err(self.refusal(&[Step::Key(list), Step::Item(i), Step::Key(old)], wrong));
            }
        }
        Ok(())
    }

    /// Why the value at some place is refused. A key that is left out stands where its table begins.
    pub fn refusal(&self, at: &[Step<'_>], wrong: impl Display) -> LabError {
        let keys = at.iter().filter_map(|step| match step {
            Step::Key(key) => Some(*key),
            Step::Item(_) => None,
        });
        let key = keys.collect::<Vec<_>>().join(".");
        refused(self.path, line_of(self.text, self.start(at)), key, wrong)
    }

    /// The byte that the deepest step begins at which the file has.
    fn start(&self, at: &[Step<'_>]) -> usize {
        let root = self.root.get_ref();
        let (mut start, mut table, mut array) = (self.root.span().start, Some(root), None);
        for step in at {
            let value = match (step, table, array) {
                (Step::Key(key), Some(table), _) => {
                    let Some((key, value)) = DeTable::get_key_value(table, *key) else { break };
                    start = key.span().start;
                    value
                }
                (Step::Item(i), _, Some(array)) => {
                    let Some(value) = <[Spanned<DeValue<'_>>]>::get(array, *i) else { break };
                    start = value.span().start;
                    value
                }
                _ => break,
            };
            (table, array) = (value.get_ref().as_table(), value.get_ref().as_array().map(|array| &array[..]));
        }
        start
    }
}

fn refused(path: &Path, line: usize, key: String, wrong: impl Display) -> LabError {
    LabError::Experiment { line, key: one_line(key), wrong: one_line(wrong), path: path.to_owned() }
}

/// What stands for a key where the text is no TOML: the beginning of the last line, up to this one, that has any.
fn key_on(text: &str, line: usize) -> String {
    let lines: Vec<&str> = text.lines().take(line).collect();
    let last = lines.iter().rev().map(|line| line.trim()).find(|line| !line.is_empty()).unwrap_or_default();
    let key = last.split('=').next().unwrap_or_default().trim();
    key.chars().take(40).collect()
}
