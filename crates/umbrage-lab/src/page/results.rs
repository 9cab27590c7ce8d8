//! The table of figures: worlds and cameras one under the other, in each of them a row for each variant and value.

use maud::{Markup, html};
use umbrage_judge::statistics::Interval;

use super::escape::minus;
use super::table::{self, Field, Kind, Part, Table};
use crate::Experiment;
use crate::figures::Figure;
use crate::tabulate::{Group, motion_text};

/// A column: a figure, or the key of one that there is not.
type Column = Result<&'static Figure, String>;

/// The section of the page.
pub(super) fn section(experiment: &Experiment, table: &Table) -> Markup {
    html! {
        section id="table" { "\n"
            h2 { "Figures" } "\n"
            p.meta { (note(experiment)) } "\n"
            (table.html())
        }
    }
}

/// The table itself.
pub(super) fn table(experiment: &Experiment, groups: &[Group]) -> Table {
    let columns = columns(experiment);
    let has_reported = experiment.variants.iter().any(|variant| !variant.reported.is_empty());
    let mut heads = vec![Field::plain(Kind::Name, "variant")];
    heads.extend(columns.iter().map(head));
    heads.extend(has_reported.then(|| Field::plain(Kind::Words, "the source reported")));
    let groups = groups
        .chunk_by(|a, b| a.stands_beside(b))
        .map(|beside| rows(experiment, &columns, has_reported, beside))
        .collect();
    Table { heads, groups }
}

/// The columns that the experiment asks for, each with its companion beside it.
fn columns(experiment: &Experiment) -> Vec<Column> {
    let is_asked_for = |figure: &&Figure| experiment.columns.iter().any(|key| key == figure.key);
    let with_companion = |key: &'_ String| {
        let figure = Figure::named(key);
        let companion = figure.and_then(Figure::companion).filter(|companion| !is_asked_for(companion));
        std::iter::once(figure.ok_or(key.clone())).chain(companion.map(Ok))
    };
    experiment.columns.iter().flat_map(with_companion).collect()
}

fn note(experiment: &Experiment) -> String {
    let is_timed = columns(experiment).iter().flatten().any(|figure| figure.key.starts_with("milliseconds."));
    let mut note = String::new();
    if experiment.repeats > 1 {
        note += &format!(
            "Means of {} jittered cameras, ± half the 95\u{202f}% interval. Bold: the best, where its interval touches \
             no other variant's. ",
            experiment.repeats
        );
    }
    if is_timed {
        note += "Times are of the camera itself: the median, and the 5th to 95th percentile of its frames.";
    }
    note
}

fn head(column: &Column) -> Field {
    let parts = match column {
        Err(key) => vec![Part::Plain(format!("{key}?"))],
        Ok(figure) => match figure.format.unit() {
            "" => vec![Part::Plain(figure.label.to_owned())],
            unit => vec![Part::Plain(figure.label.to_owned()), Part::Unit(unit.to_owned())],
        },
    };
    Field::new(Kind::Number, parts)
}

/// The rows of one world, camera and motion, under a title that names them.
fn rows(experiment: &Experiment, columns: &[Column], has_reported: bool, beside: &[Group]) -> table::Group {
    let best: Vec<Option<usize>> = columns.iter().map(|column| best(column, beside)).collect();
    let row = |(i, group): (usize, &Group)| {
        let is_best: Vec<bool> = best.iter().map(|best| *best == Some(i)).collect();
        row(experiment, columns, &is_best, has_reported, group)
    };
    let title = beside.first().map(place);
    table::Group { title, rows: beside.iter().enumerate().map(row).collect() }
}

/// Where a group was measured.
pub(super) fn place(group: &Group) -> Vec<Part> {
    let motion = group.motion.map(|motion| format!(", {}", motion_text(motion))).unwrap_or_default();
    vec![Part::Plain(group.world.to_owned()), Part::Beside(format!("from {}{motion}", group.camera))]
}

/// The group that has the minimum of a figure, if that is sure: its interval touches that of no other.
fn best(column: &Column, beside: &[Group]) -> Option<usize> {
    let figure = column.as_ref().ok().filter(|figure| figure.is_better_lower())?;
    let intervals: Vec<(usize, Interval)> =
        beside.iter().enumerate().filter_map(|(i, group)| Some((i, group.interval(figure.key)?))).collect();
    let (best, min) = intervals.iter().min_by(|(_, a), (_, b)| a.mean().total_cmp(&b.mean()))?;
    let mut others = intervals.iter().filter(|(i, _)| i != best).peekable();
    let has_others = others.peek().is_some();
    (has_others && others.all(|(_, other)| min.is_apart_from(other))).then_some(*best)
}

fn row(
    experiment: &Experiment,
    columns: &[Column],
    is_best: &[bool],
    has_reported: bool,
    group: &Group,
) -> Vec<Field> {
    let is_unjudged = |column: &Column| {
        !group.is_judged()
            && group.motion.is_none()
            && column.as_ref().is_ok_and(|figure| figure.is_of_judged_pixels())
    };
    let marked: Vec<(&Column, bool)> = columns.iter().zip(is_best.iter().copied()).collect();
    let mut fields = vec![Field::plain(Kind::Name, group.name(experiment))];
    for neighbours in marked.chunk_by(|(a, _), (b, _)| is_unjudged(a) && is_unjudged(b)) {
        match neighbours {
            [(column, _), ..] if is_unjudged(column) => fields.push(Field {
                columns: neighbours.len(),
                ..Field::plain(Kind::Missing, "no pixels to judge")
            }),
            _ => fields.extend(neighbours.iter().map(|(column, is_best)| number(column, *is_best, group))),
        }
    }
    if has_reported {
        let reported = experiment.variants.get(group.variant).and_then(|of| of.reported.get(group.world));
        fields.push(Field::plain(Kind::Reported, reported.map_or("–", String::as_str)));
    }
    fields
}

fn number(column: &Column, is_best: bool, group: &Group) -> Field {
    let value = column.as_ref().ok().and_then(|figure| value(figure, is_best, group));
    Field::new(Kind::Number, value.unwrap_or_else(|| vec![Part::Plain("–".to_owned())]))
}

fn value(figure: &Figure, is_best: bool, group: &Group) -> Option<Vec<Part>> {
    let number = |value: f64| minus(&figure.format.number(value));
    if let Some(spread) = group.spread(figure) {
        let range = format!("{} to {}", number(spread.p5), number(spread.p95));
        return Some(vec![Part::Plain(number(spread.median)), Part::Small(range)]);
    }
    let interval = group.interval(figure.key)?;
    let mean = number(interval.mean());
    let mut parts = vec![if is_best { Part::Best(mean) } else { Part::Plain(mean) }];
    let count = interval.samples.len();
    if count > 1 && interval.half_width() > 0.0 {
        parts.push(Part::Small(format!("± {}", number(interval.half_width()))));
    }
    if count < group.rows.len() {
        parts.push(Part::Small(format!("of {count}")));
    }
    Some(parts)
}
