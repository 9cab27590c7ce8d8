//! `docs/error.md`: how wrong the default is, from every camera of every world, and the curve that λ was chosen by; all from
//! `umbrage report`.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use anyhow::Context as _;
use serde_json::Value;

use crate::command::{root, umbrage};

const EXPERIMENT: &str = "experiments/default.toml";
const FOLDER: &str = "target/report";

/// The experiment whose first plot is shown beside the decision.
const CURVE: &str = "lambda-sweep";

pub fn write(adapter: Option<&str>) -> anyhow::Result<()> {
    let report = |experiment: &str| {
        let mut args = vec!["report", experiment, "-o", FOLDER];
        args.extend(adapter.iter().flat_map(|adapter| ["--adapter", adapter]));
        umbrage(&args)
    };
    report(&format!("experiments/{CURVE}.toml"))?;
    let page_of_curve = std::fs::read_to_string(root().join(FOLDER).join(format!("{CURVE}.html")))?;
    let plot = plots(&page_of_curve).next().with_context(|| format!("the page of {CURVE} has no plot"))?;
    std::fs::write(root().join("docs/pictures/lambda.svg"), plot)?;
    report(EXPERIMENT)?;
    let text = std::fs::read_to_string(root().join(FOLDER).join("default.json"))?;
    let results: Value = serde_json::from_str(&text)?;
    let page = page(&results).context("a key is missing in the results of the experiment")?;
    let path = root().join("docs/error.md");
    let draft = path.with_extension("md.new");
    std::fs::write(&draft, page)?;
    std::fs::rename(draft, path)?;
    Ok(())
}

/// The plots of a page, each as a file of its own, on white.
pub fn plots(page: &str) -> impl Iterator<Item = String> {
    // Marks of legends are drawings too, without a role.
    const START: &str = "<svg role=\"img\"";
    page.split(START).skip(1).filter_map(|rest| {
        let (head, body) = rest.split_once("</svg>")?.0.split_once('>')?;
        Some(format!("{START}{head}><rect width=\"100%\" height=\"100%\" fill=\"white\"/>{body}</svg>\n"))
    })
}

fn page(results: &Value) -> Option<String> {
    let rows = results["rows"].as_array()?;
    let first = &rows.first()?["measurement"];
    let mut text = format!(
        "# How wrong the default is\n\n\
         Written by `cargo xtask error`; do not edit. `umbrage report {EXPERIMENT} -o DIR` makes the page with pictures.\n\n\
         Adapter: {}.\nCommit: {}.\nPictures of {} x {} pixels, four maps of 1024².\n\
         Shares are of the pixels whose surface faces the sun. Edges are displaced by so many pixels in the mean.\n\n\
         | world | camera | mis-shadowed | false shadow | false light | acne | edges |\n|---|---|---|---|---|---|---|\n",
        first["adapter"].as_str()?,
        rows.first()?["machine"]["commit"].as_str()?,
        first["width"],
        first["height"],
    );
    for row in rows.iter().filter(|row| row["way"] == "default") {
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
            "| {} | {} | {} | {} | {} | {} | {edges} |",
            measurement["world"].as_str()?,
            measurement["camera"].as_str()?,
            percent(&error["mis_shadowed"]),
            percent(&error["false_shadow"]),
            percent(&error["false_light"]),
            percent(&error["causes"]["acne"]),
        )
        .ok()?;
    }
    text += "\n## Each choice undone\n\nMeans over all worlds and all cameras but those that look into the sun; in brackets the worst of them.\n\n\
             | way | mis-shadowed | false shadow | false light | acne |\n|---|---|---|---|---|\n";
    for (way, measurements) in by_way(rows)? {
        let figure = |pointer: &str| -> Option<String> {
            let shares =
                measurements.iter().map(|m| m.pointer(pointer)?.as_f64()).collect::<Option<Vec<f64>>>()?;
            let mean = shares.iter().sum::<f64>() / shares.len() as f64;
            let worst = shares.iter().copied().fold(0.0, f64::max);
            Some(format!("{:.3} % ({:.3} %)", 100.0 * mean, 100.0 * worst))
        };
        let figures = ["mis_shadowed", "false_shadow", "false_light", "causes/acne"];
        let cells =
            figures.map(|key| figure(&format!("/error/{key}"))).into_iter().collect::<Option<Vec<_>>>()?;
        writeln!(text, "| {way} | {} |", cells.join(" | ")).ok()?;
    }
    Some(text)
}

/// The measurements of each way, in the experiment's order, without those that look into the sun.
fn by_way(rows: &[Value]) -> Option<Vec<(&str, Vec<&Value>)>> {
    let mut order = Vec::new();
    let mut ways: BTreeMap<&str, Vec<&Value>> = BTreeMap::new();
    for row in rows.iter().filter(|row| row["measurement"]["camera"] != "dueling") {
        let way = row["way"].as_str()?;
        if !ways.contains_key(way) {
            order.push(way);
        }
        ways.entry(way).or_default().push(&row["measurement"]);
    }
    order.into_iter().map(|way| Some((way, ways.remove(way)?))).collect()
}

#[cfg(test)]
mod tests {
    use super::plots;

    #[test]
    fn the_plots_of_a_page_are_those_with_a_role_and_not_the_marks_of_legends() {
        let page = "<figure><svg role=\"img\" width=\"9\"><g/></svg><p><svg><i/></svg></p></figure><svg role=\"img\">2</svg>";
        let plots: Vec<String> = plots(page).collect();
        assert_eq!(plots.len(), 2);
        let white = "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>";
        assert_eq!(plots[0], format!("<svg role=\"img\" width=\"9\">{white}<g/></svg>\n"));
    }
}
