//! Settings of every form, and settings as tables.

use toml::{Table, Value};
use umbrage_core::schema::{Values, key};
use umbrage_core::{Contact, Filter, PRESETS, Settings, Shade};

/// The names of the kinds of a table.
pub fn kinds(table: &str) -> impl Iterator<Item = &'static str> {
    let Some(Values::Choice(choices)) = key(&format!("{table}.kind")).map(|key| key.values) else {
        panic!("`{table}.kind` is a choice")
    };
    choices.iter().map(|choice| choice.name)
}

/// Every preset, and every kind of filter and shade with the numbers to start from, and contact shadows.
pub fn samples() -> Vec<(String, Settings)> {
    let mut all: Vec<_> =
        PRESETS.iter().map(|preset| (preset.name.to_owned(), (preset.settings)())).collect();
    for kind in kinds("filter") {
        let filter = Filter::of_kind(kind).expect("every choice is a filter");
        all.push((format!("filter {kind}"), Settings { filter, ..Settings::default() }));
    }
    for kind in kinds("shade") {
        let shade = Shade::of_kind(kind).expect("every choice is a shade");
        all.push((format!("shade {kind}"), Settings { shade, ..Settings::default() }));
    }
    let contact = Some(Contact::default());
    all.push(("contact".to_owned(), Settings { contact, ..Settings::default() }));
    all
}

pub fn table(settings: &Settings) -> Table {
    Table::try_from(settings).expect("settings are a table")
}

pub fn settings(table: &Table) -> Result<Settings, toml::de::Error> {
    table.clone().try_into()
}

/// The table with one value more, or another one.
pub fn with(table: &Table, name: &str, value: Value) -> Table {
    let mut all = table.clone();
    match name.split_once('.') {
        None => {
            all.insert(name.to_owned(), value);
        }
        Some((first, rest)) => {
            let inner = all.get(first).and_then(Value::as_table).cloned().unwrap_or_default();
            all.insert(first.to_owned(), Value::Table(with(&inner, rest, value)));
        }
    }
    all
}

/// What the table holds, with dotted names.
pub fn leaves(table: &Table) -> Vec<(String, Value)> {
    let mut all = Vec::new();
    for (name, value) in table {
        match value {
            Value::Table(inner) => {
                all.extend(leaves(inner).into_iter().map(|(rest, value)| (format!("{name}.{rest}"), value)));
            }
            _ => all.push((name.clone(), value.clone())),
        }
    }
    all
}
