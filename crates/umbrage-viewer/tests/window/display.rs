//! A display without a screen.

use std::io::Read as _;
use std::process::{Command, ExitCode, Stdio};

/// Runs `work` on the display that there is; where there is none, starts Xvfb, and this program once more on it: to change
/// one's own environment is unsafe.
pub fn on_display(work: impl FnOnce()) -> ExitCode {
    if umbrage_viewer::native::has_display() {
        work();
        return ExitCode::SUCCESS;
    }
    let mut server = Command::new("Xvfb")
        .args(["-displayfd", "1", "-screen", "0", "1280x800x24", "-nolisten", "tcp"])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("Xvfb starts; run scripts/setup");
    let (mut number, mut byte) = (String::new(), [0]);
    let out = server.stdout.as_mut().expect("a pipe");
    while out.read(&mut byte).expect("Xvfb says its number") == 1 && byte[0] != b'\n' {
        number.push(char::from(byte[0]));
    }
    assert!(!number.is_empty(), "Xvfb did not say which display it is");
    let program = std::env::current_exe().expect("a program");
    let status = Command::new(program)
        .args(std::env::args_os().skip(1))
        .env("DISPLAY", format!(":{number}"))
        .status()
        .expect("this program starts again");
    server.kill().expect("Xvfb ends");
    server.wait().expect("Xvfb ends");
    ExitCode::from(u8::try_from(status.code().unwrap_or(1)).unwrap_or(1))
}
