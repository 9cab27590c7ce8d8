//! Plots: which there are, and what stands around each of them.

mod axis;
mod draw;
mod labels;
mod mark;
mod series;

use crate::figures::Figure;
use crate::page::escape::escaped;
use crate::tabulate::Group;
use crate::{Experiment, LabError, Plot};

use mark::Mark;
use series::{Chart, chart};

/// The section; empty where no plot is wanted.
pub(super) fn section(experiment: &Experiment, groups: &[Group]) -> Result<String, LabError> {
    if experiment.plots.is_empty() {
        return Ok(String::new());
    }
    let mut figures = String::new();
    for plot in &experiment.plots {
        if !plot.by_world {
            let all: Vec<&Group> = groups.iter().collect();
            figures += &figure(experiment, plot, &all, None)?;
            continue;
        }
        for groups in groups.chunk_by(|a, b| a.world == b.world) {
            let world = groups.first().map(|group| group.world);
            figures += &figure(experiment, plot, &groups.iter().collect::<Vec<_>>(), world)?;
        }
    }
    Ok(format!(
        "<section id=\"plots\">\n<h2>Plots</h2>\n<p class=\"meta\">Means over cameras{}. Bars: 95&#8239;% intervals \
         over repeats; of times, the 5th to 95th percentile of the frames.</p>\n\
         <div class=\"plots\">\n{figures}</div>\n</section>\n",
        if experiment.plots.iter().all(|plot| plot.by_world) {
            ""
        } else {
            ", and over worlds where none is named"
        },
    ))
}

/// One plot with its title and legend.
fn figure(
    experiment: &Experiment,
    plot: &Plot,
    groups: &[&Group],
    world: Option<&str>,
) -> Result<String, LabError> {
    let across = if plot.x == "sweep" { None } else { Some(&plot.x) };
    for key in across.into_iter().chain([&plot.y]) {
        if Figure::named(key).is_none() {
            return Ok(format!("<p class=\"none\">No figure is called {}.</p>\n", escaped(key)));
        }
    }
    let chart = chart(experiment, plot, groups);
    let title = title(plot, &chart, world);
    if chart.series.is_empty() {
        return Ok(format!(
            "<figure><figcaption><b>{}</b> <span class=\"none\">nothing to plot</span></figcaption></figure>\n",
            escaped(&title)
        ));
    }
    let svg = draw::svg(&chart)?;
    let svg = svg.replacen("<svg ", &format!("<svg role=\"img\" aria-label=\"{}\" ", escaped(&title)), 1);
    Ok(format!(
        "<figure>\n<figcaption><b>{}</b></figcaption>\n{svg}<p class=\"legend\">{}</p>\n</figure>\n",
        escaped(&title),
        legend(&chart),
    ))
}

fn title(plot: &Plot, chart: &Chart, world: Option<&str>) -> String {
    let label = |key: &str| Figure::named(key).map(|figure| figure.label);
    let across = label(&plot.x).unwrap_or(&chart.x_heading);
    let up = label(&plot.y).unwrap_or(&chart.y_heading);
    let world = world.map(|world| format!(", {world}")).unwrap_or_default();
    format!("{up} against {across}{world}")
}

fn legend(chart: &Chart) -> String {
    let ways = chart.series.iter().map(|series| {
        let mark = Mark::of(series.way);
        let mark = if series.is_level() {
            format!("<i style=\"border-top:2px dashed {}\"></i>", mark.css())
        } else {
            mark.html()
        };
        format!("<span>{mark}{}</span>", escaped(&series.name))
    });
    let front = (chart.front.len() > 1)
        .then(|| "<span><i style=\"border-top:3px solid #999\"></i>Pareto front</span>".to_owned());
    ways.chain(front).collect::<Vec<_>>().join(" ")
}
