//! An experiment's results as one HTML file that needs nothing else: no network, no script, no other file.
//!
//! The same experiment and rows give the same bytes: there are no dates in it, and rows are put in the experiment's order.

pub mod verdict;

mod claims;
mod escape;
mod machines;
mod pictures;
mod plot;
mod table;

use crate::tabulate::groups;
use crate::{Experiment, LabError, Row, Way};

use escape::escaped;

/// What the page looks like.
const STYLE: &str = include_str!("page/style.css");

/// Forbids the browser to fetch anything, whatever titles and names may hold.
const POLICY: &str = "default-src 'none'; img-src data:; style-src 'unsafe-inline'";

/// The page. `name` is what the experiment is called on the command line: the page says how it is made again.
///
/// # Errors
/// When a plot cannot be drawn.
pub fn html(experiment: &Experiment, name: &str, rows: &[Row]) -> Result<String, LabError> {
    let groups = groups(experiment, rows);
    let title = escaped(&experiment.title);
    let body = [
        head(experiment, rows),
        claims::section(experiment, &groups),
        plot::section(experiment, &groups)?,
        table::section(experiment, &groups),
        pictures::section(experiment, &groups),
        machines::section(rows),
        machines::settings(experiment, &groups),
        machines::again(experiment, name),
    ]
    .concat();
    Ok(format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n{body}</main>\n</body>\n</html>\n"
    ))
}

/// What it is, where it comes from, and what its source found.
fn head(experiment: &Experiment, rows: &[Row]) -> String {
    let paragraphs: String = experiment
        .reported
        .replace("\r\n", "\n")
        .split("\n\n")
        .map(str::trim)
        .filter(|paragraph| !paragraph.is_empty())
        .map(|paragraph| format!("<p>{}</p>\n", escaped(paragraph)))
        .collect();
    let reported = if paragraphs.is_empty() {
        String::new()
    } else {
        format!("<section id=\"reported\">\n<h2>What the source reported</h2>\n{paragraphs}</section>\n")
    };
    format!(
        "<header>\n<h1>{}</h1>\n<p class=\"source\">{}</p>\n<p class=\"meta\">{}</p>\n</header>\n{reported}",
        escaped(&experiment.title),
        escaped(&experiment.source),
        size(experiment, rows),
    )
}

/// How much was measured.
fn size(experiment: &Experiment, rows: &[Row]) -> String {
    let [width, height] = experiment.size;
    let count = |count: usize, one: &str| format!("{count} {one}{}", if count == 1 { "" } else { "s" });
    let values = |way: &Way| way.sweep.as_ref().map_or(1, |sweep| sweep.values.len());
    let ways = match experiment.ways.iter().map(values).sum::<usize>() {
        all if all == experiment.ways.len() => count(all, "way"),
        all => format!("{all} ways and values"),
    };
    let mut factors = vec![
        count(experiment.worlds.len(), "world"),
        count(experiment.cameras.len(), "camera"),
        ways,
        count(experiment.repeats as usize, "repeat"),
    ];
    if !experiment.motions.is_empty() {
        factors.push(count(experiment.motions.len(), "path"));
    }
    let frames = match experiment.frames {
        0 => "nothing timed".to_owned(),
        frames => count(frames as usize, "timed frame"),
    };
    format!(
        "{} cells: {} · pictures of {width} × {height} pixels · {frames} · seed {}",
        rows.len(),
        factors.join(" × "),
        experiment.seed,
    )
}
