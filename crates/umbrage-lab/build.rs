//! Tells the crate which commit it is built from, so that every page and `umbrage --version` can say so.

use std::path::Path;
use std::process::Command;

fn main() {
    // Whatever changes a source changes whether the commit is the whole truth.
    for path in ["../../crates", "../../Cargo.lock"] {
        println!("cargo:rerun-if-changed={path}");
    }
    // It lies elsewhere in a linked worktree. A path that is not there would build the crate anew each time.
    if let Some(moves) =
        git(&["rev-parse", "--git-path", "logs/HEAD"]).filter(|path| Path::new(path).exists())
    {
        println!("cargo:rerun-if-changed={moves}");
    }
    let version = env!("CARGO_PKG_VERSION");
    let changed =
        git(&["status", "--porcelain", "--untracked-files=no"]).is_some_and(|list| !list.is_empty());
    let changed = if changed { ", changed" } else { "" };
    let head =
        git(&["rev-parse", "--short=10", "HEAD"]).zip(git(&["show", "--no-patch", "--format=%cs", "HEAD"]));
    let (commit, version) = match head {
        Some((commit, day)) => {
            (format!("{commit}{changed}"), format!("{version} ({commit}, {day}{changed})"))
        }
        None => ("unknown".to_owned(), version.to_owned()),
    };
    println!("cargo:rustc-env=UMBRAGE_COMMIT={commit}");
    println!("cargo:rustc-env=UMBRAGE_VERSION={version}");
}

/// What git prints, where there is a repository.
fn git(words: &[&str]) -> Option<String> {
    let output = Command::new("git").args(words).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
}
