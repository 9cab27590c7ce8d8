//! Settings as a preset and what differs from it, and back.

use std::collections::BTreeMap;

use toml::{Table, Value};
use umbrage::{PRESETS, Settings, schema};
use umbrage_lab::settings::{WrongSettings, asked, from_key, from_words, overlay};

use super::read::one_line;
use crate::edit;

/// More settings than this are left out: each that is wrong costs a try of all the others.
const MOST: usize = 64;

/// The words that name settings.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Words {
    /// The preset; the default one where absent.
    pub preset: Option<String>,
    /// What goes over it, each as `key=value`.
    pub sets: Vec<String>,
}

impl Words {
    /// Returns the fewest words that name these settings.
    pub fn of(settings: &Settings) -> Self {
        let wanted = edit::short_table(settings).unwrap_or_default();
        let from = |name: &str, from: &Settings| {
            let sets = differences(edit::short_table(from).ok()?, &wanted)?;
            Some(Self { preset: Some(name.to_owned()), sets })
        };
        let all = PRESETS.iter().filter_map(|preset| from(preset.name, &(preset.settings)()));
        all.min_by_key(|words| words.sets.len()).unwrap_or_default()
    }

    /// Reads the settings, and says which words were left out. `side` stands before the words' keys in messages.
    pub fn settings(self, side: &str, messages: &mut Vec<String>) -> Settings {
        let mut say = |words: &str, why: &str| {
            messages.push(one_line(&format!("`{side}{words}` is left out: {why}")));
        };
        let mut preset = self.preset.unwrap_or_else(|| "default".to_owned());
        if let Err(why) = asked(&preset, &[""; 0]) {
            say(&format!("preset={preset}"), &why.to_string());
            preset = "default".to_owned();
        }
        let mut sets = self.sets;
        if sets.len() > MOST {
            say("set", &format!("a link has at most {MOST} settings, and this one has {}", sets.len()));
            sets.truncate(MOST);
        }
        sets.retain(|set| match check_key(set) {
            Ok(()) => true,
            Err(why) => {
                say(&format!("set={set}"), &why);
                false
            }
        });
        loop {
            match asked(&preset, &sets) {
                Ok(settings) => return settings,
                Err(_) if sets.is_empty() => return Settings::default(),
                Err(why) => {
                    let set = sets.remove(at_fault(&preset, &sets, &why));
                    say(&format!("set={set}"), &why.to_string());
                }
            }
        }
    }
}

/// Whether there is such a setting, or says what was wanted.
fn check_key(set: &str) -> Result<(), String> {
    let Some((key, _)) = set.split_once('=') else {
        return Err("wanted a setting and its value, as splits=3".to_owned());
    };
    let key = key.trim();
    let is_known =
        |name: &str| name == key || name.strip_prefix(key).is_some_and(|rest| rest.starts_with('.'));
    if schema::renamed(key).is_some() || schema::keys().any(|known| is_known(known.name)) {
        return Ok(());
    }
    Err(format!("this version has no setting `{key}`; the panel of settings shows all that it has"))
}

/// The number of the words that are wrong: those that the reason names, or else the last without which the others hold.
fn at_fault(preset: &str, sets: &[String], why: &WrongSettings) -> usize {
    let wrong = why.key();
    let is_named = |set: &String| {
        let key = set.split('=').next().unwrap_or_default().trim();
        let is_within =
            |outer: &str, inner: &str| inner.strip_prefix(outer).is_some_and(|rest| rest.starts_with('.'));
        !wrong.is_empty() && (key == wrong || is_within(key, wrong) || is_within(wrong, key))
    };
    let holds_without = |i: &usize| {
        let others: Vec<&String> =
            sets.iter().enumerate().filter(|(j, _)| j != i).map(|(_, set)| set).collect();
        asked(preset, &others).is_ok()
    };
    let last = sets.len() - 1;
    sets.iter().rposition(is_named).or_else(|| (0..=last).rev().find(holds_without)).unwrap_or(last)
}

/// What must be laid over `from` to get `wanted`; `None` where something of it cannot be taken away.
fn differences(mut from: Table, wanted: &Table) -> Option<Vec<String>> {
    let mut sets = Vec::new();
    for kind in ["filter.kind", "shade.kind"] {
        let value = edit::value(wanted, kind)?;
        if edit::value(&from, kind) != Some(value) {
            sets.push(words(kind, value));
            overlay(&mut from, from_key(kind, value.clone()).ok()?);
            // What a kind has by default comes from settings, and has their long numbers.
            edit::shorten(&mut from);
        }
    }
    let (have, want) = (leaves(&from), leaves(wanted));
    if have.keys().any(|key| !want.contains_key(key)) {
        return None;
    }
    sets.extend(
        want.iter()
            .filter(|(key, value)| have.get(*key) != Some(*value))
            .map(|(key, value)| words(key, value)),
    );
    Some(sets)
}

/// A table's values by their keys, levels parted by dots.
fn leaves(table: &Table) -> BTreeMap<String, &Value> {
    let mut leaves = BTreeMap::new();
    for (key, value) in table {
        match value {
            Value::Table(inner) => {
                let below = self::leaves(inner).into_iter();
                leaves.extend(below.map(|(rest, value)| (format!("{key}.{rest}"), value)));
            }
            value => drop(leaves.insert(key.clone(), value)),
        }
    }
    leaves
}

/// `key=value`, with a text as it is where it is read as one.
fn words(key: &str, value: &Value) -> String {
    let bare = value.as_str().map(|text| format!("{key}={text}"));
    let is_read = |bare: &String| from_words(bare).ok() == from_key(key, value.clone()).ok();
    bare.filter(is_read).unwrap_or_else(|| format!("{key}={}", value.to_string().replace(", ", ",")))
}
