//! `docs/filters.md`: what every filter is good for, costs and gets wrong, from three experiments of `umbrage report`.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::Context as _;
use serde_json::Value;

use crate::claims;
use crate::command::{machine, write_document};
use crate::reports::Reports;

const STILL: &str = "filters";
const PRESETS: &str = "presets";
const MOVING: &str = "filters-shimmer";

/// What the numbers come to, in words; they are read again when the numbers change.
const FOUND: &str = include_str!("filters/found.md");

/// The experiment's plots, in order: the file of each in `docs/pictures`, and what it shows.
const PLOTS: [(&str, &str); 4] = [
    ("filters-pixel-time.svg", "Error against each pixel's mean, by the time of a frame."),
    ("filters-pixel-memory.svg", "The same by memory."),
    ("filters-sun-time.svg", "Error against a sun of 5°, by the time of a frame."),
    ("filters-sun-memory.svg", "The same by memory."),
];

/// The plots of the presets.
const PRESET_PLOTS: [(&str, &str); 4] = [
    ("presets-pixel-time.svg", "Presets: error against each pixel's mean, by the time of a frame."),
    ("presets-sun-time.svg", "Presets: error against our sun, by the time of a frame."),
    ("presets-pixel-memory.svg", "Presets: error against each pixel's mean, by memory."),
    ("presets-sun-memory.svg", "Presets: error against our sun, by memory."),
];

/// The contact sheet, as `umbrage report` calls it.
const SHEET: &str = "filters-knights.png";

/// Runs the experiments, unless `pages` is a folder that has their reports already, and writes the document.
pub fn write(adapter: Option<&str>, pages: Option<&Path>) -> anyhow::Result<()> {
    let experiments = [STILL, PRESETS, MOVING];
    let reports = Reports::of(&experiments, adapter, pages)?;
    let [still, presets, moving] = experiments.map(|name| reports.results(name));
    let mut text = document(&still?, &presets?, &moving?)
        .context("a key is missing in the results of the experiments")?;
    text += "\n## Claims\n";
    for name in experiments {
        text += &claims::said(name, &reports)?;
    }
    reports.copy_plots(STILL, PLOTS.map(|(file, _)| file))?;
    reports.copy_plots(PRESETS, PRESET_PLOTS.map(|(file, _)| file))?;
    reports.copy_picture(SHEET, "filters.png")?;
    write_document("docs/filters.md", &text)
}

fn document(still: &Value, presets: &Value, moving: &Value) -> Option<String> {
    let rows = still["rows"].as_array()?;
    let first = rows.first()?;
    let adapter = first["machine"]["adapter"].as_str()?;
    let (width, height) = (&first["measurement"]["width"], &first["measurement"]["height"]);
    let mut text = format!(
        "# What each filter is good for\n\n\
         Written by `cargo xtask filters`; do not edit. `umbrage report experiments/{STILL}.toml -o DIR` makes the page with all pictures.\n\n\
         Machine: {}.\nAdapter: {adapter}.\nCommit: {}.\nPictures of {width} x {height} pixels, four maps of 1024².\n",
        machine(),
        first["machine"]["commit"].as_str()?,
    );
    if adapter.contains("software") {
        text += "This adapter is software on a shared machine: times say which variant is dearer where they are far apart, and no more.\n";
    }
    let _ = write!(
        text,
        "\n{}\n\n![A part of the world knights, once for each variant.](pictures/filters.png)\n",
        FOUND.trim()
    );
    text += "\n## What is best for its price\n\nMeans over the worlds. Grey joins what nothing else beats in both.\n";
    for (file, says) in PLOTS {
        let _ = write!(text, "\n![{says}](pictures/{file})\n");
    }
    text += "\n## World by world\n\n\
             Root mean square errors of visibility, 0 to 1: against the mean over each pixel, a sun of 0.53°, and one of 5°. \
             Light in umbrae, false shadow and false light are per cent. \
             Times are milliseconds, medians with the 5th and 95th percentile in brackets.\n";
    text += &world_by_world(still)?;
    text += "\n## Presets, and the defaults of engines\n\n";
    for (file, says) in PRESET_PLOTS {
        let _ = write!(text, "![{says}](pictures/{file})\n\n");
    }
    text += "\
Engines' maps have up to four times the texels, and most of their shadows end at 100 to 250 m. \
             They are judged so far, which is fewer pixels: rows with different pixels do not compare.\n";
    text += &world_by_world(presets)?;
    text += &trembling(moving)?;
    Some(text)
}

/// A table for each world.
fn world_by_world(results: &Value) -> Option<String> {
    let mut text = String::new();
    for world in results["experiment"]["worlds"].as_array()? {
        let _ = write!(text, "\n### {}\n\n", world.as_str()?);
        text += "| variant | pixel | sun | wide sun | umbrae, sun | umbrae, wide sun | false shadow | false light | filter | shading | frame | MiB | pixels |\n\
                 |---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
        for row in results["rows"].as_array()?.iter().filter(|row| row["run"]["world"] == *world) {
            text += &line(row)?;
        }
    }
    Some(text)
}

/// A variant's figures in one world.
fn line(row: &Value) -> Option<String> {
    let measurement = &row["measurement"];
    let number = |pointer: &str| measurement.pointer(pointer).and_then(Value::as_f64);
    let error =
        |pointer: &str| number(pointer).map_or_else(|| "none".to_owned(), |value| format!("{value:.4}"));
    let percent = |pointer: &str| {
        number(pointer).map_or_else(|| "none".to_owned(), |share| format!("{:.2}", 100.0 * share))
    };
    let time = |stage: &str| {
        let [median, p5, p95] =
            ["median", "p5", "p95"].map(|key| number(&format!("/milliseconds/{stage}/{key}")));
        // What is not there takes no time, give or take a tick of the clock.
        Some(match (median?.max(0.0), p5?.max(0.0), p95?.max(0.0)) {
            (_, _, p95) if p95 < 0.05 => "0".to_owned(),
            (median, p5, p95) => format!("{median:.0} ({p5:.0} to {p95:.0})"),
        })
    };
    let cells = [
        row["variant"].as_str()?.to_owned(),
        error("/sub_pixel/rmse"),
        error("/sun/rmse"),
        error("/wide_sun/rmse"),
        percent("/sun/umbra_light"),
        percent("/wide_sun/umbra_light"),
        percent("/error/false_shadow"),
        percent("/error/false_light"),
        time("filter")?,
        time("shade")?,
        time("frame")?,
        format!("{:.0}", number("/bytes")? / f64::from(1 << 20)),
        measurement["truth"]["pixels"].to_string(),
    ];
    Some(format!("| {} |\n", cells.join(" | ")))
}

/// How much each filter trembles along each path: the maximum over all worlds.
fn trembling(moving: &Value) -> Option<String> {
    const PATHS: [&str; 4] = ["translate", "yaw", "walk", "fast"];
    let rows = moving["rows"].as_array()?;
    let first = &rows.first()?["measurement"]["flicker"];
    let mut text = format!(
        "\n## What trembles as the camera moves\n\n\
         `experiments/{MOVING}.toml`: {} frames of each path, under the stable fit where nothing else is said. \
         Flips are changes between lit and shadowed while one map serves the place, per cent of the points a frame; \
         shimmer is how much visibility between the two trembles, in thousandths, changes of maps included. Each is the maximum over all worlds.\n\n\
         | variant | flips: sideways | turning | walking | fast | shimmer: sideways | turning | walking | fast |\n\
         |---|---|---|---|---|---|---|---|---|\n",
        first["frames"],
    );
    for variant in moving["experiment"]["variants"].as_array()? {
        let max = |path: &str, key: &str| {
            let of_path =
                rows.iter().filter(|row| row["variant"] == variant["name"] && row["run"]["motion"] == path);
            of_path
                .map(|row| row["measurement"]["flicker"][key].as_f64())
                .try_fold(0f64, |max, value| Some(max.max(value?)))
        };
        let mut cells = vec![variant["name"].as_str()?.to_owned()];
        for (key, scale) in [("flip_rate_within_maps", 100.0), ("shimmer", 1000.0)] {
            for path in PATHS {
                cells.push(format!("{:.3}", scale * max(path, key)?));
            }
        }
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    Some(text)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn still() -> Value {
        let spread = json!({ "median": 30.4, "p5": 20.0, "p95": 41.0 });
        let deviation = json!({ "rmse": 0.0625, "umbra_light": 0.015 });
        let row = json!({
            "variant": "hard", "run": { "world": "a" }, "machine": { "adapter": "software", "commit": "c0ffee" },
            "measurement": {
                "width": 64, "height": 36, "bytes": 16 << 20, "truth": { "pixels": 99 },
                "sub_pixel": deviation, "sun": deviation, "wide_sun": null,
                "error": { "false_shadow": 0.01, "false_light": 0.02 },
                "milliseconds": { "filter": { "median": -0.0, "p5": 0.0, "p95": 0.0 }, "shade": spread, "frame": spread },
            },
        });
        json!({ "experiment": { "worlds": ["a"] }, "rows": [row] })
    }

    fn moving() -> Value {
        let row = |motion: &str, world: &str, rate: f64| {
            let flicker = json!({ "frames": 16, "flip_rate_within_maps": rate, "shimmer": 0.001 });
            json!({ "variant": "hard", "run": { "world": world, "motion": motion }, "measurement": { "flicker": flicker } })
        };
        let rows =
            ["translate", "yaw", "walk", "fast"].map(|path| [row(path, "a", 0.0), row(path, "b", 0.02)]);
        json!({ "experiment": { "variants": [{ "name": "hard" }] }, "rows": rows.concat() })
    }

    #[test]
    fn a_variant_has_a_line_in_each_world_and_one_of_its_worst_trembling() {
        let text = document(&still(), &still(), &moving()).expect("a document");
        for line in [
            "| hard | 0.0625 | 0.0625 | none | 1.50 | none | 1.00 | 2.00 | 0 | 30 (20 to 41) | 30 (20 to 41) | 16 | 99 |",
            "| hard | 2.000 | 2.000 | 2.000 | 2.000 | 1.000 | 1.000 | 1.000 | 1.000 |",
            "Commit: c0ffee.",
        ] {
            assert!(text.contains(line), "no {line} in {text}");
        }
    }

    #[test]
    fn a_result_without_times_is_no_document() {
        let mut still = still();
        still["rows"][0]["measurement"]["milliseconds"] = Value::Null;
        assert_eq!(document(&still, &still, &moving()), None);
    }
}
