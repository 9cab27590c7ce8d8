//! What `./run` builds first, for its picture, is a part of what it then builds for its window: no crate is compiled twice
//! because the window turns on a feature that the picture does without.

#![cfg(target_os = "linux")]

use std::collections::BTreeSet;
use std::process::Command;

/// Every crate that is compiled for the command, with its features.
fn crates(args: &[&str]) -> BTreeSet<String> {
    let tree = ["tree", "--package", "umbrage-cli", "--edges", "normal,build", "--prefix", "none"];
    let output = Command::new(env!("CARGO"))
        .args(tree)
        .args(["--format", "{p} {f}"])
        .args(args)
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
        .output()
        .expect("cargo tree runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let line = |line: &str| line.trim_end_matches(" (*)").trim_end().to_owned();
    text.lines().map(line).filter(|line| !line.starts_with("umbrage-cli ")).collect()
}

#[test]
fn the_pictures_build_is_a_part_of_the_windows() {
    let (picture, all) = (crates(&["--no-default-features"]), crates(&[]));
    assert!(picture.len() > 100 && all.len() > picture.len(), "{} and {} crates", picture.len(), all.len());
    let twice: Vec<_> = picture.difference(&all).collect();
    assert!(
        twice.is_empty(),
        "compiled twice, name the window's features of these in crates/umbrage-cli/Cargo.toml: {twice:#?}"
    );
}
