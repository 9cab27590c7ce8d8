//! `docs/error.md`: how wrong the default is, from every camera of every world, and the curve that λ was chosen by; all from
//! `umbrage report`.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use anyhow::Context as _;
use serde_json::Value;

use crate::command::write_document;
use crate::reports::Reports;

const EXPERIMENT: &str = "default";

/// The experiment whose first plot is shown beside the decision.
const CURVE: &str = "lambda-sweep";

/// Runs both experiments, and writes the document and the picture.
pub fn write(adapter: Option<&str>) -> anyhow::Result<()> {
    let reports = Reports::of(&[CURVE, EXPERIMENT], adapter, None)?;
    reports.copy_plots(CURVE, ["lambda.svg"])?;
    let page =
        page(&reports.results(EXPERIMENT)?).context("a key is missing in the results of the experiment")?;
    write_document("docs/error.md", &page)
}

fn page(results: &Value) -> Option<String> {
    let rows = results["rows"].as_array()?;
    let first = &rows.first()?["measurement"];
    let mut text = format!(
        "# How wrong the default is\n\n\
         Written by `cargo xtask error`; do not edit. `umbrage report experiments/{EXPERIMENT}.toml -o DIR` makes the page with pictures.\n\n\
         Adapter: {}.\nCommit: {}.\nPictures of {} x {} pixels, four maps of 16 MiB.\n\
         Shares are of the pixels whose surface faces the sun, however aslant. Visibility is off by the mean error, 0 to 1, which also counts shades that stay on the right side of one half. Edges are displaced by so many pixels in the mean.\n\n\
         | world | camera | mis-shadowed | mean error | false shadow | false light | acne | edges |\n|---|---|---|---|---|---|---|---|\n",
        first["adapter"].as_str()?,
        rows.first()?["machine"]["commit"].as_str()?,
        first["width"],
        first["height"],
    );
    for row in rows.iter().filter(|row| row["variant"] == "default") {
        let measurement = &row["measurement"];
        let error = &measurement["error"];
        let percent = |value: &Value| {
            value.as_f64().map_or_else(|| "none".to_owned(), |share| format!("{:.3} %", 100.0 * share))
        };
        let edges = error["edge_displacement_px"]
            .as_f64()
            .map_or_else(|| "none".to_owned(), |px| format!("{px:.3} px"));
        writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {edges} |",
            measurement["world"].as_str()?,
            measurement["camera"].as_str()?,
            percent(&error["mis_shadowed"]),
            error["mae"].as_f64().map_or_else(|| "none".to_owned(), |mae| format!("{mae:.4}")),
            percent(&error["false_shadow"]),
            percent(&error["false_light"]),
            percent(&error["causes"]["acne"]),
        )
        .ok()?;
    }
    text += "\n## Each choice undone\n\nMeans over all worlds and all cameras but those that look into the sun; in brackets the worst of them.\n\n\
             | variant | mis-shadowed | mean error | false shadow | false light | acne |\n|---|---|---|---|---|---|\n";
    for (variant, measurements) in by_variant(rows)? {
        let figure = |pointer: &str| -> Option<String> {
            let shares =
                measurements.iter().map(|m| m.pointer(pointer)?.as_f64()).collect::<Option<Vec<f64>>>()?;
            let mean = shares.iter().sum::<f64>() / shares.len() as f64;
            let worst = shares.iter().copied().fold(0.0, f64::max);
            Some(match pointer {
                "/error/mae" => format!("{mean:.4} ({worst:.4})"),
                _ => format!("{:.3} % ({:.3} %)", 100.0 * mean, 100.0 * worst),
            })
        };
        let figures = ["mis_shadowed", "mae", "false_shadow", "false_light", "causes/acne"];
        let cells =
            figures.map(|key| figure(&format!("/error/{key}"))).into_iter().collect::<Option<Vec<_>>>()?;
        writeln!(text, "| {variant} | {} |", cells.join(" | ")).ok()?;
    }
    Some(text)
}

/// The measurements of each variant, in the experiment's order, without those that look into the sun.
fn by_variant(rows: &[Value]) -> Option<Vec<(&str, Vec<&Value>)>> {
    let mut order = Vec::new();
    let mut variants: BTreeMap<&str, Vec<&Value>> = BTreeMap::new();
    for row in rows.iter().filter(|row| row["measurement"]["camera"] != "dueling") {
        let variant = row["variant"].as_str()?;
        if !variants.contains_key(variant) {
            order.push(variant);
        }
        variants.entry(variant).or_default().push(&row["measurement"]);
    }
    order.into_iter().map(|variant| Some((variant, variants.remove(variant)?))).collect()
}
