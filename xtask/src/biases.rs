//! `docs/biases.md`: each kind of bias at the strength that serves it best; and `docs/pictures/bias-roc.svg`. Both from
//! `umbrage report experiments/bias-roc.toml`.
//!
//! A kind is a variant that sweeps its strength. The middle value is what theory asks, and strengths are told in it.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::Context as _;
use serde_json::Value;

use crate::command::write_document;
use crate::reports::Reports;

const EXPERIMENT: &str = "bias-roc";

/// Between which false light false shadow is averaged: from the minimum that any setting has to what is too much.
const FALSE_LIGHT: [f64; 2] = [0.0005, 0.0025];

/// One strength of a kind, the mean of all pictures; shares of the judged pixels.
#[derive(Clone, Copy, Debug)]
struct Setting {
    strength: f64,
    false_shadow: f64,
    false_light: f64,
    acne: f64,
}

struct Kind {
    name: String,
    settings: Vec<Setting>,
}

/// Runs the experiment, unless `pages` is a folder that has its report already, and writes the document and the picture.
pub fn write(adapter: Option<&str>, pages: Option<&Path>) -> anyhow::Result<()> {
    let reports = Reports::of(&[EXPERIMENT], adapter, pages)?;
    reports.copy_plots(EXPERIMENT, ["bias-roc.svg"])?;
    let page =
        page(&reports.results(EXPERIMENT)?).context("a key is missing in the results of the experiment")?;
    write_document("docs/biases.md", &page)
}

fn page(results: &Value) -> Option<String> {
    let rows = results["rows"].as_array()?;
    let kinds = kinds(rows)?;
    let first = &rows.first()?["measurement"];
    let mut text = format!(
        "# Every kind of bias\n\n\
         Written by `cargo xtask biases`; do not edit. `umbrage report experiments/{EXPERIMENT}.toml -o DIR` makes the page.\n\n\
         Adapter: {}.\nCommit: {}.\nPictures of {} x {} pixels of `{}`, the means over its cameras; one comparison a pixel.\n\n\
         Strengths are in what theory asks. The area is the geometric mean of false shadow over false light from {:.2} to \
         {:.2} %: at each, the minimum of the kind's settings that let in no more, and that of no bias where none does.\n",
        first["adapter"].as_str()?,
        rows.first()?["machine"]["commit"].as_str()?,
        first["width"],
        first["height"],
        first["world"].as_str()?,
        100.0 * FALSE_LIGHT[0],
        100.0 * FALSE_LIGHT[1],
    );
    let reaches = |kind: &&Kind| kind.settings.iter().any(|of| of.false_shadow < 1e-5);
    let names: Vec<&str> = kinds.iter().filter(reaches).map(|kind| kind.name.as_str()).collect();
    let unbiased = kinds.iter().flat_map(|kind| &kind.settings).map(|of| of.false_shadow).fold(0.0, f64::max);
    let names = if names.is_empty() { "none".to_owned() } else { names.join("; ") };
    writeln!(text, "Kinds that bring false shadow below 0.001 %: {names}.\n").ok()?;
    text += "| kind | acne below 0.01 % from | minimum of false shadow | at | false light there | acne there | area |\n|---|---|---|---|---|---|---|\n";
    for Kind { name, settings } in &kinds {
        let best = settings.iter().min_by(|a, b| a.false_shadow.total_cmp(&b.false_shadow))?;
        let clean = settings.iter().find(|of| of.acne < 1e-4);
        let clean = clean.map_or_else(|| "none".to_owned(), |of| of.strength.to_string());
        let percent = |share: f64| format!("{:.3} %", 100.0 * share);
        writeln!(
            text,
            "| {name} | {clean} | {} | {} | {} | {} | {} |",
            percent(best.false_shadow),
            best.strength,
            percent(best.false_light),
            percent(best.acne),
            percent(area(settings, unbiased)),
        )
        .ok()?;
    }
    Some(text)
}

/// What sweeps, in the experiment's order.
fn kinds(rows: &[Value]) -> Option<Vec<Kind>> {
    let swept = |row: &Value| row["swept"].as_f64();
    let mut kinds: Vec<Kind> = Vec::new();
    for row in rows.iter().filter(|row| swept(row).is_some()) {
        let name = row["variant"].as_str()?;
        if kinds.iter().any(|kind| kind.name == name) {
            continue;
        }
        let own: Vec<&Value> = rows.iter().filter(|row| row["variant"] == name).collect();
        let mut values: Vec<f64> = own.iter().filter_map(|row| swept(row)).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        let theory = values.get(values.len() / 2)?;
        let setting = |value: &f64| {
            let rows: Vec<&&Value> = own.iter().filter(|row| swept(row) == Some(*value)).collect();
            let mean = |key: &str| {
                let shares = rows.iter().map(|row| row["measurement"]["error"].pointer(key)?.as_f64());
                Some(shares.sum::<Option<f64>>()? / rows.len() as f64)
            };
            Some(Setting {
                // Values are written with four digits.
                strength: (value / theory * 1e3).round() / 1e3,
                false_shadow: mean("/false_shadow")?,
                false_light: mean("/false_light")?,
                acne: mean("/causes/acne")?,
            })
        };
        let settings = values.iter().map(setting).collect::<Option<Vec<_>>>()?;
        kinds.push(Kind { name: name.to_owned(), settings });
    }
    Some(kinds)
}

/// The geometric mean of the minimum of false shadow over the range of [`FALSE_LIGHT`]; `unbiased` where no setting lets in so
/// little.
fn area(settings: &[Setting], unbiased: f64) -> f64 {
    let [start, end] = FALSE_LIGHT;
    let mut stairs: Vec<&Setting> = settings.iter().collect();
    stairs.sort_by(|a, b| a.false_light.total_cmp(&b.false_light));
    let (mut sum, mut from, mut min) = (0.0, start, unbiased);
    for Setting { false_light, false_shadow, .. } in stairs {
        let to = false_light.clamp(start, end);
        sum += min.ln() * (to - from);
        (from, min) = (to, min.min(*false_shadow));
    }
    ((sum + min.ln() * (end - from)) / (end - start)).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setting(false_light: f64, false_shadow: f64) -> Setting {
        Setting { strength: 1.0, false_shadow, false_light, acne: 0.0 }
    }

    #[test]
    fn the_area_is_that_below_the_stairs() {
        // Half of the range at 0.4, and half at 0.1; what lets in more than the range counts for nothing.
        let settings = [setting(0.0002, 0.4), setting(0.0015, 0.1), setting(0.01, 0.001)];
        assert!((area(&settings, 0.5) - 0.2).abs() < 1e-12, "{}", area(&settings, 0.5));
        // Half of it at what no bias has.
        assert!((area(&settings[1..], 0.9) - 0.3).abs() < 1e-12, "{}", area(&settings[1..], 0.9));
    }

    #[test]
    fn strengths_are_told_in_the_middle_value_and_shares_are_means() {
        let row = |value: f64, false_shadow: f64| {
            let error = serde_json::json!({
                "false_shadow": false_shadow, "false_light": 0.0, "causes": { "acne": 0.0 }
            });
            serde_json::json!({ "variant": "slope", "swept": value, "measurement": { "error": error } })
        };
        let rows = [row(0.0, 0.5), row(0.7, 0.1), row(1.4, 0.0), row(0.7, 0.3)];
        let kinds = kinds(&rows).unwrap_or_default();
        let found: Vec<(f64, f64)> =
            kinds[0].settings.iter().map(|of| (of.strength, of.false_shadow)).collect();
        assert_eq!((kinds.len(), found), (1, vec![(0.0, 0.5), (1.0, 0.2), (2.0, 0.0)]));
    }
}
