//! What tests of the documents read: files in folders, and links in a text.

use std::path::{Path, PathBuf};

/// The repository.
pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// What lies in a folder.
pub fn entries(folder: &Path) -> impl Iterator<Item = PathBuf> {
    folder.read_dir().expect("a folder").map(|entry| entry.expect("an entry").path())
}

/// Files below a folder, as far down as they lie, whose names end so.
pub fn files(folder: &Path, end: &str) -> Vec<PathBuf> {
    entries(folder)
        .flat_map(|path| if path.is_dir() { files(&path, end) } else { vec![path] })
        .filter(|path| path.to_string_lossy().ends_with(end))
        .collect()
}

/// Targets of links and pictures, without those into the web.
pub fn links(text: &str) -> impl Iterator<Item = &str> {
    let targets = text.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(target, _)| target);
    targets.filter(|target| !target.contains("://"))
}
