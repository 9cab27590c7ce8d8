//! The stores of shards, taken into one: the same rows as if one process had measured all.
//!
//! Nothing is measured here, and no adapter is needed: which adapter drew is read from the results.

use std::collections::{BTreeSet, HashSet};
use std::fmt;
use std::path::PathBuf;

use crate::store::key;
use crate::{Entry, Experiment, LabError, Row, Run, Store};

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
    let from: Vec<Store> = from.iter().map(|folder| Store::at(folder, into.program())).collect();
    let Held { entries, by_others } = Held::of(&from, into, adapter, runs)?;
    let (mut rows, mut missing) = (Vec::new(), Vec::new());
    for Entry { variant, swept, run } in &entries {
        let taken = || {
            let outcome = from.iter().find_map(|store| store.get(run))?;
            Some(into.put(run, &outcome).map(|()| outcome))
        };
        match into.get(run).map(Ok).or_else(taken).transpose()? {
            Some(outcome) => {
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
        from: &[Store],
        into: &Store,
        adapter: Option<&str>,
        runs: impl Fn(&str, &str) -> Result<Vec<Entry>, LabError>,
    ) -> Result<Self, LabError> {
        let given: Vec<Run> = from.iter().flat_map(Store::runs).collect();
        let held: Vec<Run> = given.iter().cloned().chain(into.runs()).collect();
        let keys = held.iter().map(key).collect::<Result<HashSet<_>, _>>()?;
        let makers: BTreeSet<_> =
            held.iter().map(|run| (run.adapter.as_str(), run.program.as_str())).collect();
        let (mut own, mut by_others) = (Vec::new(), 0);
        for (by, maker) in makers {
            let entries = runs(by, maker)?;
            let wanted = entries.iter().map(|entry| key(&entry.run)).collect::<Result<HashSet<_>, _>>()?;
            let count = wanted.intersection(&keys).count();
            if maker != into.program().hash() {
                by_others += count;
            } else if count > 0 {
                let is_given =
                    given.iter().any(|run| (run.adapter.as_str(), run.program.as_str()) == (by, maker));
                own.push(Own { adapter: by.to_owned(), entries, is_given });
            }
        }
        match (own.is_empty(), by_others) {
            (true, 0) => Err(MergeError::OtherExperiment(held.len()).into()),
            (true, count) => Err(MergeError::OtherProgram(count).into()),
            (false, _) => Ok(Self { entries: by_adapter(own, adapter)?, by_others }),
        }
    }
}

/// An adapter's runs, of which this program has results.
struct Own {
    adapter: String,
    entries: Vec<Entry>,
    /// Whether a store that is merged has results by it, and not only the one that is merged into.
    is_given: bool,
}

/// The runs by the one adapter that is wanted: the one of that whole name, or else of a name with that part. What is left in the
/// output alone is not in the way.
fn by_adapter(mut own: Vec<Own>, wanted: Option<&str>) -> Result<Vec<Entry>, MergeError> {
    let there: Vec<String> = own.iter().map(|own| own.adapter.clone()).collect();
    let name = wanted.unwrap_or_default().to_lowercase();
    let is_whole = |own: &Own| own.adapter.to_lowercase() == name;
    own.retain(|own| own.adapter.to_lowercase().contains(&name));
    keep_if_any(&mut own, is_whole);
    keep_if_any(&mut own, |own| own.is_given);
    let mut chosen = own.into_iter();
    match (chosen.next(), chosen.next()) {
        (Some(own), None) => Ok(own.entries),
        (Some(_), Some(_)) => Err(MergeError::Adapters(there)),
        (None, _) => Err(MergeError::NoAdapter { name, there }),
    }
}

/// Leaves those that something holds for, where there are any.
fn keep_if_any(own: &mut Vec<Own>, holds: impl Fn(&Own) -> bool) {
    if own.iter().any(&holds) {
        own.retain(holds);
    }
}

/// Which run it is.
fn in_words(experiment: &Experiment, variant: usize, run: &Run) -> String {
    let variant = experiment.variants.get(variant).map_or("", |variant| variant.name.as_str());
    format!("`{variant}` in {} from {}, repeat {}", run.world, run.camera, run.repeat)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How many adapters an error names that some are chosen from; `None` where one is chosen.
    fn refused(of: &[(&str, bool)], wanted: Option<&str>) -> Option<usize> {
        let own = of.iter().map(|(name, is_given)| Own {
            adapter: (*name).to_owned(),
            entries: Vec::new(),
            is_given: *is_given,
        });
        match by_adapter(own.collect(), wanted) {
            Ok(_) => None,
            Err(MergeError::Adapters(there) | MergeError::NoAdapter { there, .. }) => Some(there.len()),
            Err(other) => panic!("{other}"),
        }
    }

    #[test]
    fn an_adapters_whole_name_is_that_adapter_and_leftovers_are_not_in_the_way() {
        let [short, long] = [("Card 1", true), ("Card 12", true)];
        assert_eq!(refused(&[short, long], None), Some(2));
        assert_eq!(refused(&[short, long], Some("card")), Some(2));
        assert_eq!(refused(&[short, long], Some("card 1")), None);
        assert_eq!(refused(&[short, long], Some("Voodoo")), Some(2));
        assert_eq!(refused(&[short, ("Card 12", false)], None), None);
        assert_eq!(refused(&[short, ("Card 12", false)], Some("12")), None, "what is named is taken");
    }
}
