//! Where and how the figures were made, and how to make them again.

use std::collections::{BTreeMap, BTreeSet};

use maud::{Markup, html};
use serde::Serialize;

use super::escape::Text;
use super::table::{Field, Group, Kind, Part, Table};
use crate::{Experiment, Machine, Row, tabulate};

/// Parts of the names of adapters that draw on the processor.
const SOFTWARE: [&str; 5] = ["software", "llvmpipe", "lavapipe", "swiftshader", "basic render driver"];

/// The machines that the rows were measured on, each with the number of its runs.
fn machines(rows: &[Row]) -> BTreeMap<&Machine, usize> {
    let mut counts = BTreeMap::new();
    for row in rows {
        *counts.entry(&row.outcome.machine).or_default() += 1;
    }
    counts
}

/// The table of machines.
pub(super) fn table(rows: &[Row]) -> Table {
    let heads = vec![
        Field::plain(Kind::Words, "adapter, backend, driver"),
        Field::plain(Kind::Words, "times by"),
        Field::plain(Kind::Words, "system"),
        Field::plain(Kind::Number, "threads"),
        Field::plain(Kind::Words, "commit"),
        Field::plain(Kind::Number, "runs"),
    ];
    let rows = machines(rows).into_iter().map(|(machine, runs)| line(machine, runs)).collect();
    Table { heads, groups: vec![Group { title: None, rows }] }
}

fn line(machine: &Machine, runs: usize) -> Vec<Field> {
    let Machine { adapter, timestamps, system, cores, commit } = machine;
    let clock = if *timestamps { "timestamps of the device" } else { "the wall clock" };
    vec![
        Field::plain(Kind::Name, adapter),
        Field::plain(Kind::Words, clock),
        Field::plain(Kind::Words, system),
        Field::plain(Kind::Number, cores.to_string()),
        Field::new(Kind::Words, vec![Part::Code(commit.clone())]),
        Field::plain(Kind::Number, runs.to_string()),
    ]
}

/// The section of the page.
pub(super) fn section(rows: &[Row], table: &Table) -> Markup {
    let machines = machines(rows);
    let programs: BTreeSet<&str> = rows.iter().map(|row| row.run.program.as_str()).collect();
    html! {
        section id="machines" { "\n"
            h2 { "Made with" } "\n"
            (table.html())
            @if machines.keys().any(|machine| is_software(machine)) {
                p {
                    "A software adapter drew this: its milliseconds compare with each other on this page, and with \
                     nothing else."
                } "\n"
            }
            @if machines.len() > 1 {
                p { "The runs come from more than one machine: their milliseconds do not compare." } "\n"
            }
            p.meta {
                "Hash of the program: "
                @for (i, program) in programs.iter().enumerate() {
                    @if i > 0 { ", " }
                    code { (Text(program)) }
                }
                @if programs.is_empty() { code {} }
            } "\n"
        }
    }
}

fn is_software(machine: &Machine) -> bool {
    let adapter = machine.adapter.to_lowercase();
    SOFTWARE.iter().any(|name| adapter.contains(name))
}

/// The settings of each variant in full, folded.
pub(super) fn settings(experiment: &Experiment, groups: &[tabulate::Group]) -> Markup {
    let variants: Vec<(&str, String)> = experiment
        .variants
        .iter()
        .enumerate()
        .filter_map(|(index, variant)| {
            let row = groups.iter().find(|group| group.variant == index)?.rows.first()?;
            let sweep = variant.sweep.as_ref().map(|sweep| {
                let values: Vec<String> = sweep.values.iter().map(toml::Value::to_string).collect();
                format!("# {} is {} in turn\n", sweep.key, values.join(", "))
            });
            let text = format!("{}{}", sweep.unwrap_or_default(), in_toml(&row.run.settings));
            Some((variant.name.as_str(), text))
        })
        .collect();
    html! {
        @if !variants.is_empty() {
            section id="settings" { "\n"
                h2 { "Settings of each variant" } "\n"
                @for (name, text) in &variants { (details(name, text)) "\n" }
            }
        }
    }
}

/// How to make the page again.
pub(super) fn again(experiment: &Experiment, name: &str) -> Markup {
    html! {
        section id="again" { "\n"
            h2 { "Run it again" } "\n"
            p {
                code { "umbrage report " (Text(name)) " -o DIR" }
                " measures what it has not measured yet, and writes this page."
            } "\n"
            (details("The experiment", &in_toml(experiment))) "\n"
        }
    }
}

fn details(summary: &str, text: &str) -> Markup {
    html! { details { summary { (Text(summary)) } pre { (Text(text)) } } }
}

/// A value as TOML; where it has no such form, what is in the way.
fn in_toml(value: &impl Serialize) -> String {
    toml::to_string(value).unwrap_or_else(|error| format!("# cannot be written as TOML: {error}\n"))
}
