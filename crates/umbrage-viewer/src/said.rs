//! What work under way says of how far it is, to whoever shows it.

use std::sync::{Arc, Mutex, PoisonError};

/// The last that was said, in words for people; empty where nothing was. Copies share it.
#[derive(Clone, Debug, Default)]
pub struct Said(Arc<Mutex<String>>);

impl Said {
    /// Says how far the work is.
    pub fn say(&self, words: impl Into<String>) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = words.into();
    }

    /// Returns the last that was said.
    pub fn last(&self) -> String {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}
