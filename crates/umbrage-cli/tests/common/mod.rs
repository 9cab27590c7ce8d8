//! The command as tests run it.

use std::path::Path;
use std::process::{Command, Output};

pub fn umbrage(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_umbrage"));
    // Mesa's GL complains on stderr where it has no such folder.
    command.args(args).env("XDG_RUNTIME_DIR", std::env::temp_dir());
    // No window is to open in a person's face.
    command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
    command.output().expect("the command runs")
}

/// What a command that succeeds prints.
pub fn stdout(args: &[&str]) -> String {
    let output = umbrage(args);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{args:?}: {stderr}");
    String::from_utf8(output.stdout).expect("text")
}

pub fn text(path: &Path) -> &str {
    path.to_str().expect("a readable path")
}
