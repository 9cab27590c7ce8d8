//! The stores of shards, taken into one: the same rows as if one process had measured all.
//!
//! Nothing is measured here, and no adapter is needed: which adapter drew is read from the results.

use std::collections::BTreeSet;
use std::fmt;
use std::path::PathBuf;

use crate::{Entry, Experiment, LabError, Program, Row, Run, Store};

/// So many runs are named where many are missing.
const NAMED: usize = 3;

/// An error of stores that do not make an experiment whole.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MergeError {
    /// A folder is no store.
    #[error("there are no results to merge: give the folder that a shard was written to, not {}", .0.display())]
    NoStore(PathBuf),
    /// Stores hold results, and none of this experiment.
    #[error("none of {0} results is of this experiment as it is written now: measure its shards again")]
    OtherExperiment(usize),
    /// Stores hold results of this experiment that another program made.
    #[error(
        "{0} results of this experiment were made by another program, and none by this one: merge with the program that measured, or measure the shards again with this one"
    )]
    OtherProgram(usize),
    /// Adapters differ in their last digits and in times, so that their results make no one table.
    #[error("results are by {} adapters, {}: name one of them", .0.len(), .0.join(" and "))]
    Adapters(Vec<String>),
    /// No adapter that results are by has that name.
    #[error("no results are by an adapter called `{name}`; they are by {}", there.join(" and "))]
    NoAdapter {
        /// The part of a name that was asked for.
        name: String,
        /// The adapters that results are by.
        there: Vec<String>,
    },
    /// Some runs are in none of the stores.
    #[error("{} of {of} runs are in none of the stores: {}{}", runs.len(), Named(runs), OfOthers(*by_others))]
    Missing {
        /// Each run that is missing, in words.
        runs: Vec<String>,
        /// The number of all runs.
        of: usize,
        /// The number of results of this experiment that another program made, and that do not count.
        by_others: usize,
    },
}

/// How many results were made by another program.
struct OfOthers(usize);

impl fmt::Display for OfOthers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            0 => Ok(()),
            count => write!(f, "; {count} results there were made by another program, and do not count"),
        }
    }
}

/// The first of some names.
struct Named<'a>(&'a [String]);

impl fmt::Display for Named<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0[..self.0.len().min(NAMED)].join("; "))?;
        match self.0.len().saturating_sub(NAMED) {
            0 => Ok(()),
            more => write!(f, "; and {more} more"),
        }
    }
}

/// Takes an experiment's results out of stores into another one, and makes its rows of all that lies there then. `adapter` is a
/// part of the name of the adapter that drew, where there are several. `runs` lists the experiment's runs by an adapter and a
/// program.
///
/// # Errors
/// When the stores do not make the experiment whole: a [`MergeError`]. What there is of it lies in `into` nevertheless.
pub fn merge(
    experiment: &Experiment,
    from: &[PathBuf],
    into: &Store,
    adapter: Option<&str>,
    runs: impl Fn(&str, &str) -> Result<Vec<Entry>, LabError>,
) -> Result<Vec<Row>, LabError> {
    let is_store = |folder: &&PathBuf| folder.join("runs").is_dir();
    if let Some(other) = from.iter().find(|folder| !is_store(folder)) {
        return Err(MergeError::NoStore(other.clone()).into());
    }
    let read = from.iter().map(|folder| Store::at(folder, into.program()));
    let stores: Vec<Store> = read.chain([into.clone()]).collect();
    let Held { entries, by_others } = Held::of(&stores, into.program(), adapter, runs)?;
    let (mut rows, mut missing) = (Vec::new(), Vec::new());
    for Entry { variant, swept, run } in &entries {
        match stores.iter().find_map(|store| store.get(run)) {
            Some(outcome) => {
                into.put(run, &outcome)?;
                rows.push(Row { variant: *variant, swept: swept.clone(), run: run.clone(), outcome });
            }
            None => missing.push(in_words(experiment, *variant, run)),
        }
    }
    match missing.is_empty() {
        true => Ok(rows),
        false => Err(MergeError::Missing { runs: missing, of: entries.len(), by_others }.into()),
    }
}

/// What stores hold of an experiment.
struct Held {
    /// Its runs, by this program and by the adapter that drew them.
    entries: Vec<Entry>,
    /// The number of its results that other programs made.
    by_others: usize,
}

impl Held {
    fn of(
        stores: &[Store],
        program: &Program,
        adapter: Option<&str>,
        runs: impl Fn(&str, &str) -> Result<Vec<Entry>, LabError>,
    ) -> Result<Self, LabError> {
        let held: Vec<Run> = stores.iter().flat_map(Store::runs).collect();
        let makers: BTreeSet<_> =
            held.iter().map(|run| (run.adapter.as_str(), run.program.as_str())).collect();
        let (mut own, mut by_others) = (Vec::new(), 0);
        for (by, maker) in makers {
            let entries = runs(by, maker)?;
            let count = entries.iter().filter(|entry| held.contains(&entry.run)).count();
            if maker != program.hash() {
                by_others += count;
            } else if count > 0 {
                own.push((by.to_owned(), entries));
            }
        }
        match (own.is_empty(), by_others) {
            (true, 0) => Err(MergeError::OtherExperiment(held.len()).into()),
            (true, count) => Err(MergeError::OtherProgram(count).into()),
            (false, _) => Ok(Self { entries: by_adapter(own, adapter)?, by_others }),
        }
    }
}

/// The runs by the one adapter that is wanted.
fn by_adapter(own: Vec<(String, Vec<Entry>)>, wanted: Option<&str>) -> Result<Vec<Entry>, MergeError> {
    let there: Vec<String> = own.iter().map(|(by, _)| by.clone()).collect();
    let name = wanted.unwrap_or_default().to_lowercase();
    let mut chosen = own.into_iter().filter(|(by, _)| by.to_lowercase().contains(&name));
    match (chosen.next(), chosen.next()) {
        (Some((_, entries)), None) => Ok(entries),
        (Some(_), Some(_)) => Err(MergeError::Adapters(there)),
        (None, _) => Err(MergeError::NoAdapter { name, there }),
    }
}

/// Which run it is.
fn in_words(experiment: &Experiment, variant: usize, run: &Run) -> String {
    let variant = experiment.variants.get(variant).map_or("", |variant| variant.name.as_str());
    format!("`{variant}` in {} from {}, repeat {}", run.world, run.camera, run.repeat)
}
