//! Which rows belong together: those that differ in their repeat alone, and those that a plot takes one mean of.

use std::collections::BTreeMap;

use umbrage_judge::statistics::{Interval, Spread};

use crate::figures::{self, Figure};
use crate::{Experiment, Measurement, Motion, Row, Variant};

/// A group is everything that was measured of one variant, value, world, camera and motion: one row for each repeat.
#[derive(Clone, Debug)]
pub struct Group<'a> {
    /// The index of the variant in [`Experiment::variants`].
    pub variant: usize,
    /// The value of the variant's sweep; `None` where the variant has no sweep.
    pub swept: Option<&'a toml::Value>,
    /// The name or path of the world.
    pub world: &'a str,
    /// The name of the camera.
    pub camera: &'a str,
    /// The path; `None` for a single picture.
    pub motion: Option<Motion>,
    /// The rows, by rising repeat.
    pub rows: Vec<&'a Row>,
    samples: BTreeMap<&'static str, Vec<(u32, f64)>>,
}

/// Groups rows in the experiment's order: worlds, cameras, motions, variants, values. Rows of a variant that the experiment
/// does not have are left out.
pub fn groups<'a>(experiment: &Experiment, rows: &'a [Row]) -> Vec<Group<'a>> {
    let mut sorted: Vec<&Row> = rows.iter().filter(|row| row.variant < experiment.variants.len()).collect();
    sorted.sort_by_cached_key(|row| (place(experiment, row), row.run.repeat));
    sorted
        .chunk_by(|a, b| place(experiment, a) == place(experiment, b))
        .filter_map(|rows| rows.first().map(|first| Group::of(first, rows)))
        .collect()
}

/// Where a row's group stands. Names follow their index, for what the experiment does not name.
fn place(experiment: &Experiment, row: &Row) -> (usize, String, usize, String, usize, usize, usize, String) {
    let run = &row.run;
    let index =
        |names: &[String], name: &str| names.iter().position(|other| other == name).unwrap_or(names.len());
    let motion = run.motion.map_or(0, |motion| 1 + motion as usize);
    let sweep = experiment.variants.get(row.variant).and_then(|variant| variant.sweep.as_ref());
    let value =
        sweep.and_then(|sweep| sweep.values.iter().position(|value| Some(value) == row.swept.as_ref()));
    (
        index(&experiment.worlds, &run.world),
        run.world.clone(),
        index(&experiment.cameras, &run.camera),
        run.camera.clone(),
        motion,
        row.variant,
        value.unwrap_or(usize::MAX),
        row.swept.as_ref().map(value_text).unwrap_or_default(),
    )
}

impl<'a> Group<'a> {
    fn of(first: &'a Row, rows: &[&'a Row]) -> Self {
        let mut samples: BTreeMap<&'static str, Vec<(u32, f64)>> = BTreeMap::new();
        for row in rows {
            for (figure, value) in figures::values(&row.outcome.measurement) {
                samples.entry(figure.key).or_default().push((row.run.repeat, value));
            }
        }
        Self {
            variant: first.variant,
            swept: first.swept.as_ref(),
            world: &first.run.world,
            camera: &first.run.camera,
            motion: first.run.motion,
            rows: rows.to_vec(),
            samples,
        }
    }

    /// Returns the samples of a figure, each with its repeat, by rising repeat. Repeats without the figure are left out.
    pub fn samples(&self, key: &str) -> &[(u32, f64)] {
        self.samples.get(key).map_or(&[], Vec::as_slice)
    }

    /// Returns the interval of a figure over the repeats; `None` where no repeat has the figure.
    pub fn interval(&self, key: &str) -> Option<Interval> {
        let samples = self.samples(key);
        (!samples.is_empty()).then(|| Interval::of(samples.iter().map(|(_, value)| *value).collect()))
    }

    /// Returns the spread of a timed figure over the frames of the first repeat that was timed; `None` where none was.
    pub fn spread(&self, figure: &Figure) -> Option<Spread> {
        self.rows.iter().find_map(|row| figure.spread_of(&row.outcome.measurement))
    }

    /// Whether any repeat has a judged pixel.
    pub fn is_judged(&self) -> bool {
        self.measurements().any(|measurement| measurement.error.is_some())
    }

    /// Returns what was measured, by rising repeat.
    pub fn measurements(&self) -> impl Iterator<Item = &'a Measurement> {
        self.rows.iter().map(|row| &row.outcome.measurement)
    }

    /// Whether another group has the same world, camera and motion.
    pub fn stands_beside(&self, other: &Group) -> bool {
        (self.world, self.camera, self.motion) == (other.world, other.camera, other.motion)
    }

    /// Returns the variant's name, with the swept value where there is one.
    pub fn name(&self, experiment: &Experiment) -> String {
        let variant = experiment.variants.get(self.variant);
        let name = variant.map_or("", |variant| variant.name.as_str());
        match (variant.and_then(|variant| variant.sweep.as_ref()), self.swept) {
            (Some(sweep), Some(value)) => format!("{name}, {} = {}", sweep.key, value_text(value)),
            (None, Some(value)) => format!("{name}, {}", value_text(value)),
            (_, None) => name.to_owned(),
        }
    }
}

/// A mean with the interval that it is trusted within.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// The mean itself.
    pub value: f64,
    /// The lower end of the interval; for times, the 5th percentile.
    pub low: f64,
    /// The upper end of the interval; for times, the 95th percentile.
    pub high: f64,
}

impl Mean {
    /// Computes the mean of a figure over groups, each of which counts the same. The groups are independent of each other, so
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

/// Writes a swept value as a page shows it: text without its quotes.
pub fn value_text(value: &toml::Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

/// Returns the name of a path, with its number in the specification.
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

/// The variants of some groups, each once, by their index.
pub(crate) fn variants_of<'e>(experiment: &'e Experiment, groups: &[&Group]) -> Vec<(usize, &'e Variant)> {
    let present = |index: usize| groups.iter().any(|group| group.variant == index);
    experiment.variants.iter().enumerate().filter(|(index, _)| present(*index)).collect()
}
