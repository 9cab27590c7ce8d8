//! What goes on, on a terminal: a bar on stderr, gone when the work is done. Silent where stderr is no terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar of `steps` steps.
pub fn bar(steps: u64, what: &'static str) -> ProgressBar {
    let bar = ProgressBar::new(steps).with_message(what);
    let style = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len}, {eta} left");
    if let Ok(style) = style {
        bar.set_style(style);
    }
    bar
}
