//! Every cell of an experiment, measured or taken from the store.

use crate::{Cell, Entry, LabError, Outcome, Store};

/// A cell, where it stands in the experiment, and what it came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Index into [`crate::Experiment::ways`].
    pub way: usize,
    /// The value of the way's sweep, as it is written; `None` where it has none.
    pub swept: Option<toml::Value>,
    /// What was measured.
    pub cell: Cell,
    /// What came of it.
    pub outcome: Outcome,
}

/// Takes results from the store, and measures and stores the rest, in order. `on_progress` hears after each cell how
/// many are done, of how many, and whether this one was stored already.
///
/// # Errors
/// The first that `measure` or the store returns. What was measured before it stays stored: another run goes on there.
pub fn run(
    entries: &[Entry],
    store: &Store,
    mut measure: impl FnMut(&Cell) -> Result<Outcome, LabError>,
    mut on_progress: impl FnMut(usize, usize, bool),
) -> Result<Vec<Row>, LabError> {
    let mut rows = Vec::with_capacity(entries.len());
    for Entry { way, swept, cell } in entries {
        let stored = store.get(cell);
        let was_stored = stored.is_some();
        let outcome = match stored {
            Some(outcome) => outcome,
            None => {
                let outcome = measure(cell)?;
                store.put(cell, &outcome)?;
                outcome
            }
        };
        rows.push(Row { way: *way, swept: swept.clone(), cell: cell.clone(), outcome });
        on_progress(rows.len(), entries.len(), was_stored);
    }
    Ok(rows)
}
