//! Tells the crate which commit it is built from, so that every page can say so.

use std::process::Command;

fn main() {
    // Whatever changes a source changes whether the commit is the whole truth.
    for path in ["../../crates", "../../Cargo.lock", "../../.git/logs/HEAD"] {
        println!("cargo:rerun-if-changed={path}");
    }
    let git = |words: &[&str]| {
        let output =
            Command::new("git").args(words).output().ok().filter(|output| output.status.success())?;
        String::from_utf8(output.stdout).ok()
    };
    let commit = git(&["rev-parse", "--short=10", "HEAD"]).map(|hash| hash.trim().to_owned());
    let changed =
        git(&["status", "--porcelain", "--untracked-files=no"]).is_some_and(|list| !list.is_empty());
    let commit = commit.unwrap_or_else(|| "unknown".to_owned()) + if changed { ", changed" } else { "" };
    println!("cargo:rustc-env=UMBRAGE_COMMIT={commit}");
}
