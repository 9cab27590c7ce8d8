//! Which rows belong together: those that differ in their repeat alone, and those that a plot takes one mean of.

use std::collections::BTreeMap;

use umbrage_judge::statistics::{Interval, Spread};

use crate::figures::{self, Figure};
use crate::{Experiment, Measurement, Motion, Row, Way};

/// Everything measured of one way, value, world, camera and motion: a repeat each.
#[derive(Clone, Debug)]
pub struct Group<'a> {
    /// Index into [`Experiment::ways`].
    pub way: usize,
    /// The value of the way's sweep; `None` where it has none.
    pub swept: Option<&'a toml::Value>,
    /// Which world.
    pub world: &'a str,
    /// Which camera of it.
    pub camera: &'a str,
    /// Which path; `None` for a single picture.
    pub motion: Option<Motion>,
    /// By rising repeat.
    pub rows: Vec<&'a Row>,
    samples: BTreeMap<&'static str, Vec<(u32, f64)>>,
}

/// Groups in the experiment's order: worlds, cameras, motions, ways, values. Rows of no way of the experiment are left
/// out.
pub fn groups<'a>(experiment: &Experiment, rows: &'a [Row]) -> Vec<Group<'a>> {
    let mut sorted: Vec<&Row> = rows.iter().filter(|row| row.way < experiment.ways.len()).collect();
    sorted.sort_by_cached_key(|row| (place(experiment, row), row.cell.repeat));
    sorted
        .chunk_by(|a, b| place(experiment, a) == place(experiment, b))
        .filter_map(|rows| rows.first().map(|first| Group::of(first, rows)))
        .collect()
}

/// Where a row's group stands. Names follow their index, for what the experiment does not name.
fn place(experiment: &Experiment, row: &Row) -> (usize, String, usize, String, usize, usize, usize, String) {
    let cell = &row.cell;
    let index =
        |names: &[String], name: &str| names.iter().position(|other| other == name).unwrap_or(names.len());
    let motion = cell.motion.map_or(0, |motion| 1 + motion as usize);
    let sweep = experiment.ways.get(row.way).and_then(|way| way.sweep.as_ref());
    let value =
        sweep.and_then(|sweep| sweep.values.iter().position(|value| Some(value) == row.swept.as_ref()));
    (
        index(&experiment.worlds, &cell.world),
        cell.world.clone(),
        index(&experiment.cameras, &cell.camera),
        cell.camera.clone(),
        motion,
        row.way,
        value.unwrap_or(usize::MAX),
        row.swept.as_ref().map(value_text).unwrap_or_default(),
    )
}

impl<'a> Group<'a> {
    fn of(first: &'a Row, rows: &[&'a Row]) -> Self {
        let mut samples: BTreeMap<&'static str, Vec<(u32, f64)>> = BTreeMap::new();
        for row in rows {
            for (figure, value) in figures::values(&row.outcome.measurement) {
                samples.entry(figure.key).or_default().push((row.cell.repeat, value));
            }
        }
        Self {
            way: first.way,
            swept: first.swept.as_ref(),
            world: &first.cell.world,
            camera: &first.cell.camera,
            motion: first.cell.motion,
            rows: rows.to_vec(),
            samples,
        }
    }

    /// The samples of a figure, each with its repeat, by rising repeat. Repeats without the figure are left out.
    pub fn samples(&self, key: &str) -> &[(u32, f64)] {
        self.samples.get(key).map_or(&[], Vec::as_slice)
    }

    /// The figure over the repeats; `None` where no repeat has it.
    pub fn interval(&self, key: &str) -> Option<Interval> {
        let samples = self.samples(key);
        (!samples.is_empty()).then(|| Interval::of(samples.iter().map(|(_, value)| *value).collect()))
    }

    /// The spread of a timed figure over the frames of the first repeat that was timed.
    pub fn spread(&self, figure: &Figure) -> Option<Spread> {
        self.rows.iter().find_map(|row| figure.spread_of(&row.outcome.measurement))
    }

    /// Whether any repeat has a pixel that is judged.
    pub fn is_judged(&self) -> bool {
        self.measurements().any(|measurement| measurement.error.is_some())
    }

    /// What was measured, by rising repeat.
    pub fn measurements(&self) -> impl Iterator<Item = &'a Measurement> {
        self.rows.iter().map(|row| &row.outcome.measurement)
    }

    /// Whether another group has the same world, camera and motion.
    pub fn stands_beside(&self, other: &Group) -> bool {
        (self.world, self.camera, self.motion) == (other.world, other.camera, other.motion)
    }

    /// The way's name, with the swept value where there is one.
    pub fn name(&self, experiment: &Experiment) -> String {
        let way = experiment.ways.get(self.way);
        let name = way.map_or("", |way| way.name.as_str());
        match (way.and_then(|way| way.sweep.as_ref()), self.swept) {
            (Some(sweep), Some(value)) => format!("{name}, {} = {}", sweep.key, value_text(value)),
            (None, Some(value)) => format!("{name}, {}", value_text(value)),
            (_, None) => name.to_owned(),
        }
    }
}

/// A value and how far it is trusted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// The mean.
    pub value: f64,
    /// The interval's lower end; for times, the 5th percentile.
    pub low: f64,
    /// The interval's upper end; for times, the 95th percentile.
    pub high: f64,
}

impl Mean {
    /// The mean of a figure over groups, each of them counting the same. The groups are independent of each other, so
    /// the half width of the whole is the root of the summed squares of theirs, divided by their number. `None` where no
    /// group has the figure.
    pub fn over(groups: &[&Group], figure: &Figure) -> Option<Self> {
        let intervals: Vec<Interval> = groups.iter().filter_map(|group| group.interval(figure.key)).collect();
        let count = intervals.len() as f64;
        if intervals.is_empty() {
            return None;
        }
        let value = intervals.iter().map(Interval::mean).sum::<f64>() / count;
        let spreads: Vec<Spread> = groups.iter().filter_map(|group| group.spread(figure)).collect();
        if spreads.len() == intervals.len() {
            let mean = |end: fn(&Spread) -> f64| spreads.iter().map(end).sum::<f64>() / count;
            return Some(Self { value: mean(|s| s.median), low: mean(|s| s.p5), high: mean(|s| s.p95) });
        }
        let half_width = intervals.iter().map(|i| i.half_width().powi(2)).sum::<f64>().sqrt() / count;
        Some(Self { value, low: value - half_width, high: value + half_width })
    }
}

/// A swept value as a page writes it: text without its quotes.
pub fn value_text(value: &toml::Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

/// What a path is called, with its number in the specification.
pub fn motion_text(motion: Motion) -> &'static str {
    match motion {
        Motion::Translate => "T1 translate",
        Motion::Yaw => "T2 yaw",
        Motion::Walk => "T3 walk",
        Motion::Fast => "T4 fast",
        Motion::Sun => "T5 sun",
        Motion::Objects => "T6 objects",
        Motion::SubTexel => "T7 sub-texel",
    }
}

/// The ways of some groups, each once, by their index.
pub(crate) fn ways_of<'e>(experiment: &'e Experiment, groups: &[&Group]) -> Vec<(usize, &'e Way)> {
    let present = |index: usize| groups.iter().any(|group| group.way == index);
    experiment.ways.iter().enumerate().filter(|(index, _)| present(*index)).collect()
}
