//! What has the schema of one variant of a filter or a shade?

use super::key::Key;
use super::values::Choice;

/// One variant of a table with a `kind`.
#[derive(Debug)]
pub(crate) struct Kind {
    /// Its name, label, help and source.
    pub choice: Choice,
    /// The rows of its numbers, in a panel's order. Kinds of one table may share rows.
    pub keys: &'static [Key],
}
