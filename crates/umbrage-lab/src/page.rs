//! An experiment's results as one HTML file that needs nothing else: no network, no script, no other file. Beside it, the
//! same verdicts as JSON, tables as Markdown and plots as SVG, for documents and other programs.
//!
//! The same experiment and rows give the same bytes: there are no dates in it, and rows are put in the experiment's order.

pub mod verdict;

mod claims;
mod escape;
mod machines;
mod pictures;
mod plot;
mod results;
mod table;
mod tally;

use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};
use serde_json::{Value, json};

use crate::tabulate::groups;
use crate::{Experiment, LabError, Row, Variant, files};

use escape::Text;

/// What the page looks like.
const STYLE: &str = include_str!("page/style.css");

/// Forbids the browser to fetch anything, whatever titles and names may hold.
const POLICY: &str = "default-src 'none'; img-src data:; style-src 'unsafe-inline'";

/// Everything that a report leaves: the page, and beside it the parts that documents are made of.
#[derive(Clone, Debug)]
pub struct Report {
    /// The page, as HTML.
    pub html: String,
    /// What was found of the source's claims: the experiment's `title` and `source`, and under `claims` each claim with its
    /// verdict, the name of its table in `tables`, and its checks.
    pub verdicts: Value,
    /// Every table of the page as Markdown, by its name: `figures`, `machines`, and `claim-1` and so on.
    pub tables: Vec<(String, String)>,
    /// Every plot of the page as SVG, in the page's order.
    pub plots: Vec<String>,
}

/// Makes the report of an experiment from its rows. `name` is what the experiment is called on the command line: the page
/// says how it is made again.
///
/// # Errors
/// When a plot cannot be drawn.
pub fn report(experiment: &Experiment, name: &str, rows: &[Row]) -> Result<Report, LabError> {
    let groups = groups(experiment, rows);
    let claims = claims::checked(experiment, &groups);
    let drawings = plot::drawings(experiment, &groups)?;
    let figures = results::table(experiment, &groups);
    let machines = machines::table(rows);
    let sections = [
        head(experiment, rows),
        claims::section(&claims),
        plot::section(experiment, &drawings),
        results::section(experiment, &figures),
        pictures::section(experiment, &groups),
        machines::section(rows, &machines),
        machines::settings(experiment, &groups),
        machines::again(experiment, name),
    ];
    let mut tables =
        vec![("figures".to_owned(), figures.markdown()), ("machines".to_owned(), machines.markdown())];
    tables.extend(claims.iter().enumerate().filter_map(|(i, claim)| {
        claim.table.as_ref().map(|table| (claims::table_name(i), table.markdown()))
    }));
    let Experiment { title, source, .. } = experiment;
    Ok(Report {
        html: html(title, &sections),
        verdicts: json!({ "title": title, "source": source, "claims": claims::json(&claims) }),
        tables,
        plots: drawings.iter().filter_map(plot::Drawing::file).collect(),
    })
}

impl Report {
    /// Writes the report into a folder: the page as `name.html`, and below `name/` the verdicts as `verdicts.json`, the
    /// tables as `tables/*.md` and the plots as `plots/1.svg` and so on.
    ///
    /// # Errors
    /// When a file or a folder cannot be written.
    pub fn write(&self, folder: &Path, name: &str) -> Result<(), LabError> {
        let Self { html, verdicts, tables, plots } = self;
        let beside = folder.join(name);
        let (tables_folder, plots_folder) = (beside.join("tables"), beside.join("plots"));
        files::make_folder(&tables_folder)?;
        files::make_folder(&plots_folder)?;
        files::write(&beside.join("verdicts.json"), format!("{verdicts:#}\n").as_bytes())?;
        for (table, markdown) in tables {
            files::write(&tables_folder.join(format!("{table}.md")), markdown.as_bytes())?;
        }
        for (i, svg) in plots.iter().enumerate() {
            files::write(&plots_folder.join(format!("{}.svg", i + 1)), svg.as_bytes())?;
        }
        files::write(&folder.join(format!("{name}.html")), html.as_bytes())
    }
}

fn html(title: &str, sections: &[Markup]) -> String {
    let page = html! {
        (DOCTYPE) "\n"
        html lang="en" { "\n"
            head { "\n"
                meta charset="utf-8"; "\n"
                meta http-equiv="Content-Security-Policy" content=(POLICY); "\n"
                meta name="viewport" content="width=device-width, initial-scale=1"; "\n"
                title { (Text(title)) } "\n"
                style { "\n" (PreEscaped(STYLE)) } "\n"
            } "\n"
            body { "\n" main { "\n" @for section in sections { (section) "\n" } } "\n" } "\n"
        } "\n"
    };
    page.into_string()
}

/// What it is, where it comes from, and what its source found.
fn head(experiment: &Experiment, rows: &[Row]) -> Markup {
    let reported = experiment.reported.replace("\r\n", "\n");
    let paragraphs: Vec<&str> =
        reported.split("\n\n").map(str::trim).filter(|paragraph| !paragraph.is_empty()).collect();
    html! {
        header { "\n"
            h1 { (Text(&experiment.title)) } "\n"
            p.source { (Text(&experiment.source)) } "\n"
            p.meta { (size(experiment, rows)) } "\n"
        } "\n"
        @if !paragraphs.is_empty() {
            section id="reported" { "\n"
                h2 { "What the source reported" } "\n"
                @for paragraph in &paragraphs { p { (Text(paragraph)) } "\n" }
            }
        }
    }
}

/// How much was measured.
fn size(experiment: &Experiment, rows: &[Row]) -> String {
    let [width, height] = experiment.size;
    let count = |count: usize, one: &str| format!("{count} {one}{}", if count == 1 { "" } else { "s" });
    let values = |variant: &Variant| variant.sweep.as_ref().map_or(1, |sweep| sweep.values.len());
    let variants = match experiment.variants.iter().map(values).sum::<usize>() {
        all if all == experiment.variants.len() => count(all, "variant"),
        all => format!("{all} variants and values"),
    };
    let mut factors = vec![
        count(experiment.worlds.len(), "world"),
        count(experiment.cameras.len(), "camera"),
        variants,
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
        "{} runs: {} · pictures of {width} × {height} pixels · {frames} · seed {}",
        rows.len(),
        factors.join(" × "),
        experiment.seed,
    )
}
