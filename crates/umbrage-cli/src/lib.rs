//! The command `umbrage`: draw, plan, compare and time the shadows of large worlds.
//!
//! Thin: one file a subcommand, in `commands/`; what they share is in `args`, `settings`, `world` and `output`. Results
//! go to stdout or to `-o`, everything else to stderr. Exit status 0, 1 (the work failed) or 2 (a usage error).
//! [`library`] is the same for a program that has a command line of another kind.
//!
//! This crate does not: know how shadows are made. It parses, calls, and prints.

pub mod library;

mod advice;
mod args;
mod cameras_json;
mod commands;
mod contact_sheet;
mod failure;
mod label;
mod output;
mod pages;
mod plan_json;
mod progress;
mod settings;
mod world;

use std::process::ExitCode;

use clap::Parser as _;

pub use failure::{Failure, Outcome};

/// Does what the command line asks for, prints what comes of it, and returns the status for scripts.
pub fn main() -> ExitCode {
    let commands = args::Cli::parse();
    match commands::run(commands.command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            failure.exit_code()
        }
    }
}
