//! Which settings are there, what may each of them be, and what does it do? One table: range checks, help texts and
//! panels are made from it, so a setting that is added here appears in all of them.
//!
//! A name is the one of a settings file, with its levels parted by dots. Where a number has another range under another
//! `filter.kind`, it has a row for each. A row stands in the file of what it describes; this file puts the table together.
//!
//! The table does not say: defaults, which are [`Settings::default`]'s, and what excludes what, which
//! [`Settings::validate`] knows.

pub(crate) mod check;
pub(crate) mod cost;
pub(crate) mod group;
pub(crate) mod key;
pub(crate) mod kind;
mod renamed;
pub(crate) mod values;

use self::kind::Kind;
use crate::settings::{Settings, bias, exact, maps, shade, splits};
use crate::{contact, filter, light_box};

pub use cost::Cost;
pub use group::Group;
pub use key::{Absent, Key};
pub use renamed::renamed;
pub use values::{Choice, Values};

/// The whole table, group after group. A name with several ranges comes several times, each for other kinds.
pub fn keys() -> impl Iterator<Item = &'static Key> {
    let before =
        [splits::KEYS, maps::KEYS, light_box::KEYS, &[exact::EXACT, filter::KIND]].into_iter().flatten();
    let between = [bias::KEYS, contact::KEYS, &[shade::KIND]].into_iter().flatten();
    before.chain(keys_of_kinds(filter::KINDS)).chain(between).chain(keys_of_kinds(shade::KINDS))
}

/// The rows of all kinds of a table, each once.
fn keys_of_kinds(kinds: &'static [&'static Kind]) -> impl Iterator<Item = &'static Key> {
    kinds.iter().enumerate().flat_map(move |(i, kind)| {
        kind.keys.iter().filter(move |key| !kinds[..i].iter().any(|before| before.keys.contains(key)))
    })
}

/// The row of this name; the first, where several kinds have rows of their own.
pub fn key(name: &str) -> Option<&'static Key> {
    keys().find(|key| key.name == name)
}

/// The rows of what these settings hold or may be given, each name once.
pub fn keys_of(settings: &Settings) -> impl Iterator<Item = &'static Key> {
    let before = [splits::KEYS, maps::KEYS].into_iter().flatten();
    let light_box = keys_of_table(light_box::KEYS, settings.light_box.is_some());
    let between = [&[exact::EXACT, filter::KIND], settings.filter.keys(), bias::KEYS].into_iter().flatten();
    let contact = keys_of_table(contact::KEYS, settings.contact.is_some());
    let shade = [&[shade::KIND], settings.shade.keys()].into_iter().flatten();
    before.chain(light_box).chain(between).chain(contact).chain(shade)
}

/// The rows of a table that may be left out: what it holds only where it is there.
fn keys_of_table(keys: &'static [Key], is_there: bool) -> impl Iterator<Item = &'static Key> {
    keys.iter().filter(move |key| is_there || key.values == Values::Table)
}

impl Key {
    /// The kinds of its table under which the row holds: of `filter.kind` or `shade.kind`. Empty where its table has no
    /// kinds, or it is their row.
    pub fn kinds(&self) -> Vec<&'static str> {
        let kinds = match self.group {
            Group::Filter => filter::KINDS,
            Group::Shade => shade::KINDS,
            Group::Splits | Group::Maps | Group::Bias | Group::Contact => &[],
        };
        kinds.iter().filter(|kind| kind.keys.contains(self)).map(|kind| kind.choice.name).collect()
    }

    /// Whether the row holds under a kind of its table.
    pub fn is_of(&self, kind: &str) -> bool {
        let kinds = self.kinds();
        kinds.is_empty() || kinds.contains(&kind)
    }
}
