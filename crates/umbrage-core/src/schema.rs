//! Which settings are there, what may each of them be, and what does it do? One table: range checks, help texts and
//! panels are made from it, so a setting that is added here appears in all of them.
//!
//! A name is the one of a settings file, with its levels parted by dots. Where a number has another range under another
//! `filter.kind`, it has a row for each.
//!
//! The table does not say: defaults, which are [`Settings::default`]'s, and what excludes what, which
//! [`Settings::validate`] knows.

pub(crate) mod bias;
pub(crate) mod contact;
pub(crate) mod filter;
mod group;
pub(crate) mod maps;
pub(crate) mod shade;
pub(crate) mod splits;
pub(crate) mod values;

pub use group::Group;
pub use values::{Choice, Values};

use crate::settings::Settings;

/// One setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// As in a settings file: `filter.prefilter.blur_texels`.
    pub name: &'static str,
    /// As short as a panel wants it: `blur`.
    pub label: &'static str,
    /// One to three sentences: what it does, and what more of it costs.
    pub help: &'static str,
    /// Paper and equation; empty where it is ours, or nobody's.
    pub source: &'static str,
    /// Of its numbers: `metres`, `texels`, `degrees`; empty where they have none.
    pub unit: &'static str,
    /// Beside which others it stands.
    pub group: Group,
    /// Of its table, under which kinds this row holds: `filter.kind` or `shade.kind`. Empty is under all of them.
    pub kinds: &'static [&'static str],
    /// What it may be.
    pub values: Values,
    /// The same in words and with the unit, as an error says it after "must be"; empty for a choice, whose names say it.
    pub wanted: &'static str,
    /// Where it may be left out: what that means.
    pub absent: Option<Absent>,
}

/// A setting that is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Absent {
    /// What stands in for it: "the camera's far".
    pub means: &'static str,
    /// From where to start once it is given, as it is written in TOML: `100.0`, `{}`.
    pub start: &'static str,
}

impl Key {
    /// A key of a group before anything is said of it: what its row leaves out is empty.
    const fn of(group: Group) -> Self {
        Self {
            name: "",
            label: "",
            help: "",
            source: "",
            unit: "",
            group,
            kinds: &[],
            values: Values::Switch,
            wanted: "",
            absent: None,
        }
    }

    /// The same for a switch.
    const fn switch(group: Group) -> Self {
        Self { wanted: "true or false", ..Self::of(group) }
    }

    /// Whether this row holds under a kind of its table.
    pub fn is_of(&self, kind: &str) -> bool {
        self.kinds.is_empty() || self.kinds.contains(&kind)
    }
}

/// The whole table, group after group. A name with several ranges comes several times, each for other kinds.
pub fn keys() -> impl Iterator<Item = &'static Key> {
    let groups = [splits::KEYS, maps::KEYS, filter::KEYS, filter::points::KEYS, filter::soft::KEYS];
    let more = [filter::moments::KEYS, bias::KEYS, contact::KEYS, shade::KEYS];
    groups.into_iter().chain(more).flatten()
}

/// The row of this name; the first, where several kinds have rows of their own.
pub fn key(name: &str) -> Option<&'static Key> {
    keys().find(|key| key.name == name)
}

/// The rows of what these settings hold or may be given, each name once.
pub fn keys_of(settings: &Settings) -> impl Iterator<Item = &'static Key> {
    let (filter, shade) = (settings.filter.kind(), settings.shade.kind());
    let has_contact = settings.contact.is_some();
    keys().filter(move |key| match key.group {
        Group::Splits | Group::Maps | Group::Bias => true,
        Group::Filter => key.is_of(filter),
        Group::Contact => has_contact || key.values == Values::Table,
        Group::Shade => key.is_of(shade),
    })
}
