//! What documents point at is there: files that they name, and pages that they link to.

mod markdown;

use std::path::PathBuf;

use markdown::{entries, files, links, root};

/// The documents: Markdown in the root, in `docs/`, in `examples/` and in `integrations/`.
fn documents() -> Vec<PathBuf> {
    let in_root = entries(root()).filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    let below = ["docs", "examples", "integrations"].map(|folder| files(&root().join(folder), ".md"));
    in_root.chain(below.concat()).collect()
}

/// Paths below `crates/`, `docs/` and so on that stand between backticks, but for files that a recipe says to make:
/// `(new)`. Braces stand for several: `a/{b,c}.rs`.
fn named_paths(text: &str) -> Vec<String> {
    const ROOTS: &[&str] =
        &["crates/", "docs/", "xtask/", "scripts/", "experiments/", "examples/", "fuzz/", "integrations/"];
    let lines = text.lines().filter(|line| !line.contains("(new)"));
    let quoted = lines.flat_map(|line| line.split('`').skip(1).step_by(2));
    let is_path =
        |word: &&str| ROOTS.iter().any(|root| word.starts_with(root)) && !word.contains(['*', '…', ' ', 'N']);
    quoted.filter(is_path).flat_map(spread).collect()
}

/// The paths that braces stand for.
fn spread(path: &str) -> Vec<String> {
    let Some((before, rest)) = path.split_once('{') else { return vec![path.to_owned()] };
    let Some((names, after)) = rest.split_once('}') else { return vec![path.to_owned()] };
    names.split(',').map(|name| format!("{before}{}{after}", name.trim())).collect()
}

#[test]
fn every_file_and_page_that_a_document_names_is_there() {
    let mut missing = Vec::new();
    for document in documents() {
        let text = std::fs::read_to_string(&document).expect("a document");
        let folder = document.parent().expect("a folder");
        // A decision speaks of files as they were.
        let is_of_its_time = folder.ends_with("decisions");
        let named = if is_of_its_time { Vec::new() } else { named_paths(&text) };
        let named = named.into_iter().map(|path| (root().join(&path), path));
        let linked = links(&text).filter(|link| !link.starts_with('#')).map(|link| {
            let path = link.split('#').next().unwrap_or(link);
            (folder.join(path), link.to_owned())
        });
        let lost = named.chain(linked).filter(|(path, _)| !path.exists());
        missing.extend(lost.map(|(_, name)| format!("{}: {name}", document.display())));
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}
