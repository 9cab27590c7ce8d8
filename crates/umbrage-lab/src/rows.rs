//! Every run of an experiment, measured or taken from the store.

use crate::{Entry, LabError, Outcome, Run, Store};

/// A row is a run, its place in the experiment, and its outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The index of the variant in [`crate::Experiment::variants`].
    pub variant: usize,
    /// The value of the variant's sweep, as it is written; `None` where the variant has no sweep.
    pub swept: Option<toml::Value>,
    /// The run that was measured.
    pub run: Run,
    /// The outcome of the run.
    pub outcome: Outcome,
}

/// Takes outcomes from the store, and measures and stores the rest, in order. `on_progress` is called after each run with
/// the number of runs that are done, the number of all, and whether this one was stored already.
///
/// # Errors
/// The first error of `measure` or of the store. What was measured before it stays stored: the next call goes on there.
pub fn measure_all(
    entries: &[Entry],
    store: &Store,
    mut measure: impl FnMut(&Run) -> Result<Outcome, LabError>,
    mut on_progress: impl FnMut(usize, usize, bool),
) -> Result<Vec<Row>, LabError> {
    let mut rows = Vec::with_capacity(entries.len());
    for Entry { variant, swept, run } in entries {
        let stored = store.get(run);
        let was_stored = stored.is_some();
        let outcome = match stored {
            Some(outcome) => outcome,
            None => {
                let outcome = measure(run)?;
                store.put(run, &outcome)?;
                outcome
            }
        };
        rows.push(Row { variant: *variant, swept: swept.clone(), run: run.clone(), outcome });
        on_progress(rows.len(), entries.len(), was_stored);
    }
    Ok(rows)
}
