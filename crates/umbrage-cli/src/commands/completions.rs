//! `umbrage completions`: what lets a shell complete the words of the command.

use clap::CommandFactory as _;

use crate::args::{Cli, CompletionsArgs};
use crate::failure::Outcome;
use crate::output::print_bytes;

pub fn run(args: &CompletionsArgs) -> Outcome {
    // Into memory first: a reader that has gone away is no failure, and this writer would panic at it.
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "umbrage", &mut text);
    Ok(print_bytes(&text)?)
}
