//! What a plot shows: points of each variant, and which of them nothing beats.

use crate::figures::Figure;
use crate::tabulate::{Group, Mean, value_text, variants_of};
use crate::{Experiment, Plot};

use super::axis::Scale;

/// Larger values than any figure has; beyond them, sums of positions would lose their meaning.
const LARGEST: f64 = 1e15;

/// A place in a plot, in the units of its axes.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub x: Mean,
    pub y: Mean,
    /// The label beside the point; empty where it has none. Of a sweep, only the ends have labels.
    pub label: String,
}

/// What a variant looks like in a plot.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// A point.
    Point(Point),
    /// Points that are joined, one for each value.
    Line(Vec<Point>),
    /// The same height everywhere, of a variant that does not sweep.
    Level(Mean),
    /// A bar from 0 for each world that has the figure: the world's index, and how high the bar is.
    Bars(Vec<(usize, Mean)>),
}

/// A variant in a plot.
#[derive(Clone, Debug)]
pub(super) struct Series {
    /// The index of the variant in [`Experiment::variants`].
    pub variant: usize,
    pub name: String,
    pub shape: Shape,
}

/// Everything that is drawn in one plot. All numbers are finite.
#[derive(Clone, Debug)]
pub(super) struct Chart {
    pub x_heading: String,
    pub y_heading: String,
    pub x_scale: Scale,
    pub series: Vec<Series>,
    /// The Pareto front from left to right; empty where none is wanted.
    pub front: Vec<[f64; 2]>,
}

impl Series {
    /// Its points; none of a level or of bars.
    pub(super) fn points(&self) -> &[Point] {
        match &self.shape {
            Shape::Point(point) => std::slice::from_ref(point),
            Shape::Line(points) => points,
            Shape::Level(_) | Shape::Bars(_) => &[],
        }
    }
}

/// What a plot of some groups shows.
pub(super) fn chart(experiment: &Experiment, plot: &Plot, groups: &[&Group]) -> Chart {
    let named = |key: &str| Figure::named(key);
    let y_heading = named(&plot.y).map(Figure::heading).unwrap_or_default();
    let (x_heading, x_scale, series) = match (named(&plot.x), named(&plot.y)) {
        (Some(x), Some(y)) => {
            let scale = if plot.log_x { Scale::Logarithmic } else { Scale::Linear };
            (x.heading(), scale, against_figure(experiment, groups, x, y))
        }
        (None, Some(y)) if plot.x == "world" => {
            let (worlds, series) = over_worlds(experiment, groups, y);
            ("world".to_owned(), Scale::Names(worlds), series)
        }
        (None, Some(y)) => against_sweep(experiment, plot, groups, y),
        (_, None) => (plot.x.clone(), Scale::Linear, Vec::new()),
    };
    let front = if plot.pareto { front(&series) } else { Vec::new() };
    Chart { x_heading, y_heading, x_scale, series, front }
}

/// One variant's groups by swept value, in the sweep's order.
fn by_value<'g, 'a>(
    groups: &[&'g Group<'a>],
    variant: usize,
) -> Vec<(Option<&'a toml::Value>, Vec<&'g Group<'a>>)> {
    let mut parts: Vec<(Option<&toml::Value>, Vec<&Group>)> = Vec::new();
    for group in groups.iter().filter(|group| group.variant == variant) {
        match parts.iter_mut().find(|(value, _)| *value == group.swept) {
            Some((_, part)) => part.push(group),
            None => parts.push((group.swept, vec![group])),
        }
    }
    parts
}

fn against_figure(experiment: &Experiment, groups: &[&Group], x: &Figure, y: &Figure) -> Vec<Series> {
    let series = variants_of(experiment, groups).into_iter().filter_map(|(index, variant)| {
        let values = by_value(groups, index);
        let ends = [values.first(), values.last()].map(|end| end.and_then(|(value, _)| *value));
        let point = |(value, part): &(Option<&toml::Value>, Vec<&Group>)| {
            let label = match value {
                None => variant.name.clone(),
                Some(value) if ends.contains(&Some(value)) => {
                    let key = variant.sweep.as_ref().map_or("", |sweep| sweep.key.as_str());
                    format!("{key} = {}", value_text(value))
                }
                Some(_) => String::new(),
            };
            Some(Point { x: mean(part, x)?, y: mean(part, y)?, label })
        };
        let points: Vec<Point> = values.iter().filter_map(point).collect();
        let shape = match (&variant.sweep, points.first()) {
            (_, None) => return None,
            (None, Some(point)) => Shape::Point(point.clone()),
            (Some(_), Some(_)) => Shape::Line(points),
        };
        Some(Series { variant: index, name: series_name(experiment, index), shape })
    });
    series.collect()
}

fn against_sweep(
    experiment: &Experiment,
    plot: &Plot,
    groups: &[&Group],
    y: &Figure,
) -> (String, Scale, Vec<Series>) {
    let mut keys: Vec<&str> = Vec::new();
    let mut values: Vec<&toml::Value> = Vec::new();
    for (_, variant) in variants_of(experiment, groups) {
        let Some(sweep) = &variant.sweep else { continue };
        if !keys.contains(&sweep.key.as_str()) {
            keys.push(&sweep.key);
        }
        values.extend(&sweep.values);
    }
    let scale = sweep_scale(&values, plot.log_x);
    let position = |value: &toml::Value| match &scale {
        Scale::Names(names) => names.iter().position(|name| *name == value_text(value)).map(|i| i as f64),
        Scale::Linear | Scale::Logarithmic => number(value),
    };
    let mut series = Vec::new();
    for (index, variant) in variants_of(experiment, groups) {
        let parts = by_value(groups, index);
        let shape = if variant.sweep.is_some() {
            let point = |(value, part): &(Option<&toml::Value>, Vec<&Group>)| {
                let x = position((*value)?)?;
                Some(Point { x: Mean { value: x, low: x, high: x }, y: mean(part, y)?, label: String::new() })
            };
            Some(Shape::Line(parts.iter().filter_map(point).collect::<Vec<_>>()))
        } else {
            parts.first().and_then(|(_, part)| mean(part, y)).map(Shape::Level)
        };
        match shape {
            Some(Shape::Line(points)) if points.is_empty() => {}
            Some(shape) => {
                series.push(Series { variant: index, name: series_name(experiment, index), shape });
            }
            None => {}
        }
    }
    (keys.join(" or "), scale, series)
}

/// The worlds of some groups in their order, and each variant's bars over them.
fn over_worlds(experiment: &Experiment, groups: &[&Group], y: &Figure) -> (Vec<String>, Vec<Series>) {
    let mut worlds: Vec<&str> = Vec::new();
    for group in groups {
        if !worlds.contains(&group.world) {
            worlds.push(group.world);
        }
    }
    let bars = |index: usize| {
        let bar = |(place, world): (usize, &&str)| {
            let of = |group: &&&Group| group.variant == index && group.world == *world;
            Some((place, mean(&groups.iter().filter(of).copied().collect::<Vec<_>>(), y)?))
        };
        worlds.iter().enumerate().filter_map(bar).collect::<Vec<_>>()
    };
    let series = variants_of(experiment, groups).into_iter().filter_map(|(index, variant)| {
        let bars = bars(index);
        let is_empty = bars.is_empty();
        let series = Series { variant: index, name: variant.name.clone(), shape: Shape::Bars(bars) };
        (!is_empty).then_some(series)
    });
    let series = series.collect();
    (worlds.into_iter().map(str::to_owned).collect(), series)
}

/// Numbers have their place; anything else stands in the order that it is given in.
fn sweep_scale(values: &[&toml::Value], log_x: bool) -> Scale {
    if values.iter().all(|value| number(value).is_some()) {
        return if log_x { Scale::Logarithmic } else { Scale::Linear };
    }
    let mut names: Vec<String> = Vec::new();
    for name in values.iter().map(|value| value_text(value)) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    Scale::Names(names)
}

fn series_name(experiment: &Experiment, index: usize) -> String {
    experiment.variants.get(index).map(|variant| variant.name.clone()).unwrap_or_default()
}

fn number(value: &toml::Value) -> Option<f64> {
    let number = value.as_float().or_else(|| value.as_integer().map(|integer| integer as f64));
    number.filter(|number| number.abs() <= LARGEST)
}

/// In the figure's unit; `None` of what cannot be drawn.
fn mean(groups: &[&Group], figure: &Figure) -> Option<Mean> {
    let Mean { value, low, high } = Mean::over(groups, figure)?;
    let [value, low, high] = [value, low, high].map(|v| figure.format.in_unit(v));
    [value, low, high].iter().all(|v| v.abs() <= LARGEST).then_some(Mean { value, low, high })
}

/// The points that no other beats in both, from left to right: less is better in both.
fn front(series: &[Series]) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> =
        series.iter().flat_map(Series::points).map(|point| [point.x.value, point.y.value]).collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut front: Vec<[f64; 2]> = Vec::new();
    for point in points {
        if front.last().is_none_or(|last| point[1] < last[1]) {
            front.push(point);
        }
    }
    front
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_what_nothing_beats_in_both() {
        let series = |x: f64, y: f64| {
            let mean = |value: f64| Mean { value, low: value, high: value };
            let point = Point { x: mean(x), y: mean(y), label: String::new() };
            Series { variant: 0, name: String::new(), shape: Shape::Point(point) }
        };
        let all = [series(3.0, 1.0), series(1.0, 3.0), series(2.0, 3.5), series(2.0, 2.0), series(4.0, 1.0)];
        assert_eq!(front(&all), [[1.0, 3.0], [2.0, 2.0], [3.0, 1.0]]);
        assert!(front(&[]).is_empty());
    }
}
