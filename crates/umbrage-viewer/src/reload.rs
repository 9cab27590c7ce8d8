//! A settings file that is read again whenever it changes.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant, SystemTime};

use umbrage::Settings;

/// How often the file is looked at.
pub const PERIOD: Duration = Duration::from_secs(1);

/// What makes settings of the file, or says in one line what is wrong with it.
pub type Resolve = dyn Fn() -> Result<Settings, String> + Send + Sync;

/// A settings file, and what it was when it was read last.
#[derive(Clone)]
pub struct Reload {
    path: PathBuf,
    resolve: Arc<Resolve>,
    read: Option<Stamp>,
    next: Instant,
}

/// What tells one state of a file from another: when it was written, and its size in bytes.
type Stamp = (SystemTime, u64);

impl std::fmt::Debug for Reload {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Reload").field("path", &self.path).finish_non_exhaustive()
    }
}

impl Reload {
    /// Watches a file that is read after this for the first time; `resolve` reads it again.
    pub fn new(path: PathBuf, resolve: Arc<Resolve>) -> Self {
        let mut reload = Self { path, resolve, read: None, next: Instant::now() };
        reload.read = reload.stamp();
        reload
    }

    /// Returns the settings, or what is wrong with them, where the file has changed; `None` where not, or before it is time to
    /// look again.
    pub fn poll(&mut self, now: Instant) -> Option<Result<Settings, String>> {
        if now < self.next {
            return None;
        }
        self.next = now + PERIOD;
        let stamp = self.stamp();
        if stamp == self.read {
            return None;
        }
        self.read = stamp;
        Some((self.resolve)())
    }

    fn stamp(&self) -> Option<Stamp> {
        let about = self.path.metadata().ok()?;
        Some((about.modified().ok()?, about.len()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit;

    #[test]
    fn a_file_is_read_when_it_changes_and_not_before() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.toml");
        let write = |text: &str| std::fs::write(&path, text).expect("a file");
        write("[shadows]\nsplits = 2\n");
        let file = path.clone();
        let resolve = move || {
            let text = std::fs::read_to_string(&file).map_err(|why| why.to_string())?;
            edit::from_file("a.toml", &text).map_err(|why| why.to_string())
        };
        let mut reload = Reload::new(path.clone(), Arc::new(resolve));
        let start = Instant::now();
        let mut at = |seconds: u64| reload.poll(start + Duration::from_secs(seconds));
        assert_eq!(at(1), None, "it is as it was read");
        write("[shadows]\nsplits = 22\n");
        assert_eq!(at(1), None, "it is not time yet");
        let wrong = at(3).expect("it changed").expect_err("22 splits");
        assert!(wrong.contains("splits") && wrong.contains("22") && wrong.ends_with("a.toml"), "{wrong}");
        assert_eq!(at(5), None, "what is wrong is said once");
        write("[shadows]\nsplits = 3\n");
        assert_eq!(at(7).expect("it changed").map(|settings| settings.splits), Ok(3));
        std::fs::remove_file(&path).expect("a file");
        assert!(at(9).expect("it is gone").is_err());
        assert_eq!(at(11), None);
    }
}
