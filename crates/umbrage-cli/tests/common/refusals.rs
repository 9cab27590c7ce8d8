//! What a refusal must be: a status, one line, and no file left.

use std::path::Path;

use tempfile::TempDir;

use crate::common::umbrage;

/// Demands a status and an error of one line that names something, and no file.
pub fn refused(args: &[&str], status: i32, named: &str, unwritten: Option<&Path>) {
    let output = umbrage(args);
    let stderr = String::from_utf8_lossy(&output.stderr);
    let errors: Vec<&str> = stderr.lines().filter(|line| line.starts_with("error:")).collect();
    assert_eq!(output.status.code(), Some(status), "{args:?}: {stderr}");
    assert_eq!(errors.len(), 1, "{args:?}: {stderr}");
    assert!(stderr.contains(named), "{args:?} should name {named}: {stderr}");
    assert!(!stderr.contains("panicked"), "{args:?}: {stderr}");
    if let Some(path) = unwritten {
        assert!(!path.exists(), "{args:?} left {}", path.display());
    }
}

/// A folder that goes when it is no longer looked at.
pub fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}
