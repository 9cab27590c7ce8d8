//! The table: worlds and cameras one under the other, in each of them a row for each way and value.

use umbrage_judge::statistics::Interval;

use crate::Experiment;
use crate::figures::Figure;
use crate::page::escape::{escaped, minus};
use crate::tabulate::{Group, motion_text};

/// A column: a figure, or the key of one that there is not.
type Column<'a> = Result<&'static Figure, &'a str>;

/// The section.
pub(super) fn section(experiment: &Experiment, groups: &[Group]) -> String {
    let columns: Vec<Column> =
        experiment.columns.iter().map(|key| Figure::named(key).ok_or(key.as_str())).collect();
    let has_reported = experiment.ways.iter().any(|way| !way.reported.is_empty());
    let heads: String = columns.iter().map(head).collect();
    let reported = if has_reported { "<th>the source reported</th>" } else { "" };
    let bodies: String = groups
        .chunk_by(|a, b| a.stands_beside(b))
        .map(|beside| body(experiment, &columns, has_reported, beside))
        .collect();
    format!(
        "<section id=\"table\">\n<h2>Figures</h2>\n<p class=\"meta\">{}</p>\n<div class=\"wide\"><table>\n\
         <thead><tr><th>way</th>{heads}{reported}</tr></thead>\n{bodies}</table></div>\n</section>\n",
        note(experiment, &columns),
    )
}

fn note(experiment: &Experiment, columns: &[Column]) -> String {
    let is_timed = columns.iter().flatten().any(|figure| figure.key.starts_with("milliseconds."));
    let mut note = String::new();
    if experiment.repeats > 1 {
        note += &format!(
            "Means of {} jittered cameras, ± half the 95&#8239;% interval. Bold: the best, where its interval touches \
             no other way's. ",
            experiment.repeats
        );
    }
    if is_timed {
        note += "Times are of the camera itself: the median, and the 5th to 95th percentile of its frames.";
    }
    note
}

fn head(column: &Column) -> String {
    match column {
        Err(key) => format!("<th class=\"number\">{}?</th>", escaped(key)),
        Ok(figure) => match figure.format.unit() {
            "" => format!("<th class=\"number\">{}</th>", escaped(figure.label)),
            unit => format!("<th class=\"number\">{}<br><small>{unit}</small></th>", escaped(figure.label)),
        },
    }
}

/// The rows of one world, camera and motion, under a row that names them.
fn body(experiment: &Experiment, columns: &[Column], has_reported: bool, beside: &[Group]) -> String {
    let width = 1 + columns.len() + usize::from(has_reported);
    let place = beside.first().map(place).unwrap_or_default();
    let best: Vec<Option<usize>> = columns.iter().map(|column| best(column, beside)).collect();
    let rows: String = beside
        .iter()
        .enumerate()
        .map(|(i, group)| {
            let is_best: Vec<bool> = best.iter().map(|best| *best == Some(i)).collect();
            row(experiment, columns, &is_best, has_reported, group)
        })
        .collect();
    format!("<tbody>\n<tr class=\"place\"><th colspan=\"{width}\">{place}</th></tr>\n{rows}</tbody>\n")
}

/// Where a group was measured, as HTML.
pub(super) fn place(group: &Group) -> String {
    let motion = group.motion.map(|motion| format!(", {}", motion_text(motion))).unwrap_or_default();
    format!("{} <span>from {}{motion}</span>", escaped(group.world), escaped(group.camera))
}

/// Which group has the least of a figure, if that is sure: its interval touches that of no other.
fn best(column: &Column, beside: &[Group]) -> Option<usize> {
    let figure = column.ok().filter(|figure| figure.is_better_lower())?;
    let intervals: Vec<(usize, Interval)> =
        beside.iter().enumerate().filter_map(|(i, group)| Some((i, group.interval(figure.key)?))).collect();
    let (best, least) = intervals.iter().min_by(|(_, a), (_, b)| a.mean().total_cmp(&b.mean()))?;
    let mut others = intervals.iter().filter(|(i, _)| i != best).peekable();
    let has_others = others.peek().is_some();
    (has_others && others.all(|(_, other)| least.is_apart_from(other))).then_some(*best)
}

fn row(
    experiment: &Experiment,
    columns: &[Column],
    is_best: &[bool],
    has_reported: bool,
    group: &Group,
) -> String {
    let is_unjudged = |column: &Column| {
        !group.is_judged()
            && group.motion.is_none()
            && column.is_ok_and(|figure| figure.is_of_judged_pixels())
    };
    let marked: Vec<(&Column, bool)> = columns.iter().zip(is_best.iter().copied()).collect();
    let cells: String = marked
        .chunk_by(|(a, _), (b, _)| is_unjudged(a) && is_unjudged(b))
        .map(|run| match run {
            [(column, _), ..] if is_unjudged(column) => {
                format!("<td class=\"none\" colspan=\"{}\">no pixels to judge</td>", run.len())
            }
            run => run.iter().map(|(column, is_best)| cell(column, *is_best, group)).collect(),
        })
        .collect();
    let reported = experiment.ways.get(group.way).and_then(|way| way.reported.get(group.world));
    let reported = match (has_reported, reported) {
        (false, _) => String::new(),
        (true, None) => "<td class=\"reported\">–</td>".to_owned(),
        (true, Some(text)) => format!("<td class=\"reported\">{}</td>", escaped(text)),
    };
    format!("<tr><th>{}</th>{cells}{reported}</tr>\n", escaped(&group.name(experiment)))
}

fn cell(column: &Column, is_best: bool, group: &Group) -> String {
    let value = column.ok().and_then(|figure| value(figure, is_best, group));
    format!("<td class=\"number\">{}</td>", value.unwrap_or_else(|| "–".to_owned()))
}

fn value(figure: &Figure, is_best: bool, group: &Group) -> Option<String> {
    let number = |value: f64| minus(&figure.format.number(value));
    if let Some(spread) = group.spread(figure) {
        let range = format!("{} to {}", number(spread.p5), number(spread.p95));
        return Some(format!("{} <small>{range}</small>", number(spread.median)));
    }
    let interval = group.interval(figure.key)?;
    let mean = number(interval.mean());
    let mean = if is_best { format!("<b>{mean}</b>") } else { mean };
    let count = interval.samples.len();
    let half = if count > 1 && interval.half_width() > 0.0 {
        format!(" <small>± {}</small>", number(interval.half_width()))
    } else {
        String::new()
    };
    let short = if count < group.rows.len() { format!(" <small>of {count}</small>") } else { String::new() };
    Some(format!("{mean}{half}{short}"))
}
