//! The generated pages of the documents are those that the program writes today.
//!
//! `UPDATE_PAGES=1 cargo test -p umbrage-cli --test pages` writes them anew.

use std::path::Path;
use std::process::Command;

fn is_current(page: &str, args: &[&str]) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(page);
    let output = Command::new(env!("CARGO_BIN_EXE_umbrage")).args(args).output().expect("the command runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let wanted = String::from_utf8(output.stdout).expect("text");
    if std::env::var_os("UPDATE_PAGES").is_some() {
        std::fs::write(&path, &wanted).expect("the page is written");
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    let differs = found.lines().zip(wanted.lines()).position(|(found, wanted)| found != wanted);
    assert!(
        found == wanted,
        "docs/{page} is not what `umbrage {}` prints (from line {}): write it anew with \
         UPDATE_PAGES=1 cargo test -p umbrage-cli --test pages",
        args.join(" "),
        differs.map_or(1 + found.lines().count().min(wanted.lines().count()), |line| line + 1)
    );
}

#[test]
fn the_page_of_worlds_is_current() {
    is_current("worlds.md", &["worlds", "--markdown"]);
}

#[test]
fn the_page_of_settings_is_current() {
    is_current("settings.md", &["settings", "--markdown"]);
}
