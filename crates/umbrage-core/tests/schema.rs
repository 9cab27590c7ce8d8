//! Does the table say what settings are? It is held against what serde writes and reads, and against what is refused.
#![cfg(feature = "serde")]

#[path = "schema/choices.rs"]
mod choices;
#[path = "schema/costs.rs"]
mod costs;
#[path = "schema/docs.rs"]
mod docs;
#[path = "schema/ranges.rs"]
mod ranges;
#[path = "schema/samples.rs"]
mod samples;

use std::collections::BTreeSet;

use samples::{leaves, samples, settings, table, with};
use umbrage_core::schema::{Group, Values, key, keys, keys_of};

#[test]
fn whatever_is_written_has_a_row_and_what_has_a_row_is_written_or_may_be_absent() {
    for (name, sample) in samples() {
        let written: BTreeSet<String> = leaves(&table(&sample)).into_iter().map(|(key, _)| key).collect();
        let rows: Vec<_> = keys_of(&sample).collect();
        let names: BTreeSet<String> = rows.iter().map(|key| key.name.to_owned()).collect();
        assert_eq!(names.len(), rows.len(), "{name}: a name has one row");
        let lacking: Vec<_> = written.difference(&names).collect();
        assert!(lacking.is_empty(), "{name}: no row for {lacking:?}");
        for row in rows.iter().filter(|row| !written.contains(row.name)) {
            assert!(row.absent.is_some(), "{name}: `{}` is not written", row.name);
        }
    }
}

#[test]
fn what_may_be_absent_can_be_given_and_left_out_again() {
    for (name, sample) in samples() {
        for row in keys_of(&sample) {
            let Some(absent) = row.absent else { continue };
            assert!(!absent.means.is_empty());
            let start: toml::Table = toml::from_str(&format!("start = {}", absent.start)).unwrap();
            let given = settings(&with(&table(&sample), row.name, start["start"].clone())).unwrap();
            assert_eq!(given.validate(), Ok(()), "{name}: {} = {}", row.name, absent.start);
            assert!(keys_of(&given).any(|key| key == row));
        }
    }
}

#[test]
fn every_row_is_of_some_settings() {
    for row in keys() {
        assert!(samples().iter().any(|(_, sample)| keys_of(sample).any(|key| key == row)), "`{}`", row.name);
        assert_eq!(key(row.name).map(|key| key.name), Some(row.name));
        let kinds = key(&format!("{}.kind", row.name.split('.').next().unwrap_or_default()));
        for kind in row.kinds() {
            let Some(Values::Choice(choices)) = kinds.map(|key| key.values) else {
                panic!("`{}` is of kinds, and its table has none", row.name)
            };
            assert!(choices.iter().any(|choice| choice.name == kind), "`{}`: no kind {kind}", row.name);
        }
    }
    assert_eq!(key("no such key"), None);
}

#[test]
fn a_group_stands_together_in_the_order_of_groups() {
    let mut order: Vec<Group> = keys().map(|key| key.group).collect();
    order.dedup();
    assert_eq!(order, Group::ALL);
}

#[test]
fn everything_has_a_label_of_its_own_and_a_help_of_whole_sentences() {
    let sentence = |help: &str| help.ends_with('.') && !help.contains("  ");
    for row in keys() {
        assert!(!row.label.is_empty() && sentence(row.help), "`{}`: {}", row.name, row.help);
        assert_eq!(row.wanted().is_empty(), matches!(row.values, Values::Choice(_)), "`{}`", row.name);
        if let Values::Choice(choices) = row.values {
            for choice in choices {
                assert!(!choice.label.is_empty() && sentence(choice.help), "{}", choice.name);
            }
            let labels: BTreeSet<_> = choices.iter().map(|choice| choice.label).collect();
            assert_eq!(labels.len(), choices.len(), "`{}`: labels tell choices apart", row.name);
        }
    }
    for group in Group::ALL {
        assert!(!group.label().is_empty() && sentence(group.help()));
    }
    for (name, sample) in samples() {
        let labels: Vec<_> = keys_of(&sample).map(|key| (key.group.label(), key.label)).collect();
        for (i, label) in labels.iter().enumerate() {
            assert!(!labels[..i].contains(label), "{name}: two settings are called {label:?}");
        }
    }
}
