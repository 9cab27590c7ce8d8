//! Tells the crate which commit it is built from, so that every page and `umbrage --version` can say so.

use std::path::Path;
use std::process::Command;

fn main() {
    // Whatever changes a source changes whether the commit is the whole truth.
    for path in ["../../crates", "../../Cargo.lock"] {
        println!("cargo:rerun-if-changed={path}");
    }
    // They lie elsewhere in a linked worktree. A path that is not there would build the crate anew each time.
    let branch = git(&["symbolic-ref", "--quiet", "HEAD"]);
    let files = ["HEAD", "logs/HEAD", "packed-refs"].into_iter().chain(branch.as_deref());
    let paths = files.filter_map(|file| git(&["rev-parse", "--git-path", file]));
    for path in paths.filter(|path| Path::new(path).exists()) {
        println!("cargo:rerun-if-changed={path}");
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

/// What git prints, where there is a repository of this workspace. A source archive may lie in another one, whose commit says nothing.
fn git(words: &[&str]) -> Option<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().ok()?;
    let of = printed(&["rev-parse", "--show-toplevel"])?;
    (Path::new(&of).canonicalize().ok()? == root).then(|| printed(words))?
}

fn printed(words: &[&str]) -> Option<String> {
    let output = Command::new("git").args(words).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
}
