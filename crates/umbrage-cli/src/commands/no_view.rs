//! What stands in for `umbrage view` where the program was built without its window.

use umbrage_scene::Scene;

use crate::args::{DemoArgs, ViewArgs};
use crate::failure::{Failure, Outcome};

/// What to do about it.
const NO_WINDOW: &str = "this program was built without its window; `cargo build --release` in the repository builds one that has it";

/// `umbrage view`.
pub fn run(_: &ViewArgs) -> Outcome {
    Err(Failure::Work(anyhow::Error::msg(NO_WINDOW)))
}

/// Whether `umbrage demo` may open a window.
pub fn is_possible() -> bool {
    false
}

/// The window of `umbrage demo`.
pub fn of_demo(_: &DemoArgs, _: Scene) -> Outcome {
    Err(Failure::Work(anyhow::Error::msg(NO_WINDOW)))
}
