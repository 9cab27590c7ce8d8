//! One file a subcommand.

mod adapters;
mod bench;
mod completions;
mod demo;
mod man;
pub mod measure;
pub mod plan;
mod presets;
mod render;
pub mod report;
mod settings;
mod sheet;
#[cfg(feature = "window")]
mod view;
#[cfg(not(feature = "window"))]
#[path = "commands/no_view.rs"]
mod view;
pub mod wgsl;
pub mod worlds;

use crate::args::Command;
use crate::failure::Outcome;

/// Does what was asked for.
pub fn run(command: Command) -> Outcome {
    match command {
        Command::Demo(args) => demo::run(&args),
        Command::Render(args) => render::run(&args),
        Command::Plan(args) => plan::run(&args),
        Command::Wgsl(args) => wgsl::run(&args),
        Command::Measure(args) => measure::run(&args),
        Command::Sheet(args) => sheet::run(&args),
        Command::Report(args) => report::run(&args),
        Command::Bench(args) => bench::run(&args),
        Command::View(args) => view::run(&args),
        Command::Settings(args) => settings::run(&args),
        Command::Worlds(args) => worlds::run(&args),
        Command::Adapters => adapters::run(),
        Command::Presets(args) => presets::run(&args),
        Command::Completions(args) => completions::run(&args),
        Command::Man(args) => man::run(&args),
    }
}
