//! Plots: which there are, and what stands around each of them.

mod axis;
mod draw;
mod labels;
mod mark;
mod series;

use maud::{Markup, PreEscaped, html};

use super::escape::{Text, escaped};
use crate::figures::Figure;
use crate::tabulate::Group;
use crate::{Experiment, LabError, Plot};

use mark::Mark;
use series::{Chart, Shape, chart};

/// A plot as the page shows it.
pub(super) enum Drawing {
    /// A chart as SVG, and its legend.
    Drawn { title: String, svg: String, legend: Markup },
    /// There is nothing to plot.
    Empty { title: String },
    /// There is no such figure.
    Unknown { figure: String },
}

/// Every plot of an experiment, in its order: one for each world, or one over all worlds.
pub(super) fn drawings(experiment: &Experiment, groups: &[Group]) -> Result<Vec<Drawing>, LabError> {
    let mut drawings = Vec::new();
    for plot in &experiment.plots {
        if !plot.by_world {
            let all: Vec<&Group> = groups.iter().collect();
            drawings.push(drawing(experiment, plot, &all, None)?);
            continue;
        }
        for groups in groups.chunk_by(|a, b| a.world == b.world) {
            let world = groups.first().map(|group| group.world);
            drawings.push(drawing(experiment, plot, &groups.iter().collect::<Vec<_>>(), world)?);
        }
    }
    Ok(drawings)
}

fn drawing(
    experiment: &Experiment,
    plot: &Plot,
    groups: &[&Group],
    world: Option<&str>,
) -> Result<Drawing, LabError> {
    let across = if ["sweep", "world"].contains(&plot.x.as_str()) { None } else { Some(&plot.x) };
    if let Some(figure) = across.into_iter().chain([&plot.y]).find(|key| Figure::named(key).is_none()) {
        return Ok(Drawing::Unknown { figure: figure.clone() });
    }
    let is_shown =
        |group: &&&Group| experiment.variants.get(group.variant).is_some_and(|variant| plot.shows(variant));
    let groups: Vec<&Group> = groups.iter().filter(is_shown).copied().collect();
    let chart = chart(experiment, plot, &groups);
    let title = title(plot, &chart, world);
    if chart.series.is_empty() {
        return Ok(Drawing::Empty { title });
    }
    let svg = draw::svg(&chart)?;
    Ok(Drawing::Drawn { title, svg, legend: legend(&chart) })
}

fn title(plot: &Plot, chart: &Chart, world: Option<&str>) -> String {
    let label = |key: &str| Figure::named(key).map(|figure| figure.label);
    let across = label(&plot.x).unwrap_or(&chart.x_heading);
    let up = label(&plot.y).unwrap_or(&chart.y_heading);
    let world = world.map(|world| format!(", {world}")).unwrap_or_default();
    format!("{up} against {across}{world}")
}

/// The section; empty where no plot is wanted.
pub(super) fn section(experiment: &Experiment, drawings: &[Drawing]) -> Markup {
    if experiment.plots.is_empty() {
        return html! {};
    }
    let is_mean_of_worlds = experiment.plots.iter().any(|plot| !plot.by_world);
    html! {
        section id="plots" { "\n"
            h2 { "Plots" } "\n"
            p.meta {
                "Means over cameras" @if is_mean_of_worlds { ", and over worlds where none is named" }
                ". Whiskers: 95\u{202f}% intervals over repeats; of times, the 5th to 95th percentile of the frames."
            } "\n"
            div.plots { "\n" @for drawing in drawings { (figure(drawing)) "\n" } } "\n"
        }
    }
}

/// One plot with its title and legend.
fn figure(drawing: &Drawing) -> Markup {
    match drawing {
        Drawing::Unknown { figure } => html! { p.none { "No figure is called " (Text(figure)) "." } },
        Drawing::Empty { title } => html! {
            figure { figcaption { b { (Text(title)) } " " span.none { "nothing to plot" } } }
        },
        Drawing::Drawn { title, svg, legend } => html! {
            figure { "\n"
                figcaption { b { (Text(title)) } } "\n"
                (PreEscaped(named(svg, title)))
                p.legend { (legend) } "\n"
            }
        },
    }
}

/// A drawing that says to those who do not see it what it is.
fn named(svg: &str, title: &str) -> String {
    svg.replacen("<svg ", &format!("<svg role=\"img\" aria-label=\"{}\" ", escaped(title)), 1)
}

impl Drawing {
    /// The drawing as a file of its own, on white; `None` where nothing was drawn.
    pub fn file(&self) -> Option<String> {
        let Self::Drawn { title, svg, legend: _ } = self else { return None };
        let svg = named(svg.trim_end(), title);
        let (head, body) = svg.split_once('>')?;
        Some(format!("{head}><rect width=\"100%\" height=\"100%\" fill=\"white\"/>{body}\n"))
    }
}

fn legend(chart: &Chart) -> Markup {
    html! {
        // Bars have their names within the drawing.
        @let series = chart.series.iter().filter(|series| !matches!(series.shape, Shape::Bars(_)));
        @for (i, series) in series.enumerate() {
            @if i > 0 { " " }
            span {
                @if matches!(series.shape, Shape::Level(_)) {
                    i style={ "border-top:2px dashed " (Mark::of(series.variant).css()) } {}
                } @else {
                    (Mark::of(series.variant).html())
                }
                (Text(&series.name))
            }
        }
        @if chart.front.len() > 1 {
            " " span { i style="border-top:3px solid #999" {} "Pareto front" }
        }
    }
}
