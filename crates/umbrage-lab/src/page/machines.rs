//! Where and how the figures were made, and how to make them again.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use crate::page::escape::escaped;
use crate::tabulate::Group;
use crate::{Experiment, Machine, Row};

/// Parts of the names of adapters that draw on the processor.
const SOFTWARE: [&str; 5] = ["software", "llvmpipe", "lavapipe", "swiftshader", "basic render driver"];

/// The machines of the rows.
pub(super) fn section(rows: &[Row]) -> String {
    let mut counts: BTreeMap<&Machine, usize> = BTreeMap::new();
    for row in rows {
        *counts.entry(&row.outcome.machine).or_default() += 1;
    }
    let lines: String = counts.iter().map(|(machine, cells)| line(machine, *cells)).collect();
    let mut notes = String::new();
    if counts.keys().any(|machine| is_software(machine)) {
        notes += "<p>A software adapter drew this: its milliseconds compare with each other on this page, and with \
                  nothing else.</p>\n";
    }
    if counts.len() > 1 {
        notes += "<p>The cells come from more than one machine: their milliseconds do not compare.</p>\n";
    }
    let programs: BTreeSet<&str> = rows.iter().map(|row| row.cell.program.as_str()).collect();
    let programs: Vec<String> = programs.into_iter().map(escaped).collect();
    format!(
        "<section id=\"machines\">\n<h2>Made with</h2>\n<div class=\"wide\"><table>\n\
         <thead><tr><th>adapter, backend, driver</th><th>times by</th><th>system</th><th class=\"number\">threads</th>\
         <th>commit</th><th class=\"number\">cells</th></tr></thead>\n<tbody>\n{lines}</tbody></table></div>\n{notes}\
         <p class=\"meta\">Hash of the program: <code>{}</code></p>\n</section>\n",
        programs.join("</code>, <code>"),
    )
}

fn line(machine: &Machine, cells: usize) -> String {
    let Machine { adapter, timestamps, system, cores, commit } = machine;
    format!(
        "<tr><th>{}</th><td>{}</td><td>{}</td><td class=\"number\">{cores}</td><td><code>{}</code></td>\
         <td class=\"number\">{cells}</td></tr>\n",
        escaped(adapter),
        if *timestamps { "timestamps of the device" } else { "the wall clock" },
        escaped(system),
        escaped(commit),
    )
}

fn is_software(machine: &Machine) -> bool {
    let adapter = machine.adapter.to_lowercase();
    SOFTWARE.iter().any(|name| adapter.contains(name))
}

/// The settings of each way in full, folded.
pub(super) fn settings(experiment: &Experiment, groups: &[Group]) -> String {
    let ways: String = experiment
        .ways
        .iter()
        .enumerate()
        .filter_map(|(index, way)| {
            let row = groups.iter().find(|group| group.way == index)?.rows.first()?;
            let sweep = way.sweep.as_ref().map(|sweep| {
                let values: Vec<String> = sweep.values.iter().map(toml::Value::to_string).collect();
                format!("# {} is {} in turn\n", sweep.key, values.join(", "))
            });
            let text = format!("{}{}", sweep.unwrap_or_default(), in_toml(&row.cell.settings));
            Some(details(&way.name, &text))
        })
        .collect();
    if ways.is_empty() {
        return String::new();
    }
    format!("<section id=\"settings\">\n<h2>Settings of each way</h2>\n{ways}</section>\n")
}

/// How to make the page again.
pub(super) fn again(experiment: &Experiment, name: &str) -> String {
    format!(
        "<section id=\"again\">\n<h2>Run it again</h2>\n<p><code>umbrage report {} -o DIR</code> measures what it has \
         not measured yet, and writes this page.</p>\n{}</section>\n",
        escaped(name),
        details("The experiment", &in_toml(experiment)),
    )
}

fn details(summary: &str, text: &str) -> String {
    format!("<details><summary>{}</summary><pre>{}</pre></details>\n", escaped(summary), escaped(text))
}

/// A value as TOML; where it has no such form, what is in the way.
fn in_toml(value: &impl Serialize) -> String {
    toml::to_string(value).unwrap_or_else(|error| format!("# cannot be written as TOML: {error}\n"))
}
