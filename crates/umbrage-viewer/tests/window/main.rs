//! The window as people use it: opened under Xvfb, driven by its widgets, looked at as it is on the screen, closed.
//!
//! Not a test of libtest's: windows want the main thread. What it sees is in `target/tmp/window`, to look at.

mod checks;
mod display;
mod script;

use std::cell::RefCell;
use std::rc::Rc;

use umbrage::Settings;
use umbrage_viewer::Start;
use umbrage_viewer::load::Source;
use umbrage_viewer::native::{Options, run_wrapped};

use script::{Log, Scripted};

fn main() -> std::process::ExitCode {
    // Whoever lists tests, or wants one by its name, does not mean this.
    if std::env::args().any(|arg| arg == "--list") {
        return std::process::ExitCode::SUCCESS;
    }
    display::on_display(drive)
}

fn drive() {
    let log = Rc::new(RefCell::new(Log::default()));
    let start = Start::new(Source::Named("primitives".to_owned()), Settings::default());
    let options =
        Options { adapter: Some("vulkan".to_owned()), size: Some([1180.0, 760.0]), unlimited: true };
    let (steps, seen) = (Rc::new(RefCell::new(script::steps())), Rc::clone(&log));
    run_wrapped(start, &options, &move |viewer| {
        Box::new(Scripted::new(viewer, Rc::clone(&steps), Rc::clone(&seen)))
    })
    .expect("the window opens, and closes without an error");
    checks::all(&log.borrow());
    println!("window: ok");
}
