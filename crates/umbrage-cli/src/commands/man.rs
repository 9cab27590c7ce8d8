//! `umbrage man`: the manual's pages, one for the command and one for each of its commands.

use std::path::Path;

use clap::{Command, CommandFactory as _};
use clap_mangen::Man;
use umbrage_lab::files;

use crate::args::{Cli, ManArgs};
use crate::failure::Outcome;
use crate::output::print_bytes;

pub fn run(args: &ManArgs) -> Outcome {
    let mut command = Cli::command().disable_help_subcommand(true);
    command.build();
    match &args.output {
        Some(folder) => {
            files::make_folder(folder)?;
            write_all(command, folder)
        }
        None => {
            let (_, page) = page(command)?;
            Ok(print_bytes(&page)?)
        }
    }
}

/// Writes the page of a command, and those of the commands below it.
fn write_all(command: Command, folder: &Path) -> Outcome {
    for below in command.get_subcommands().filter(|below| !below.is_hide_set()) {
        write_all(below.clone(), folder)?;
    }
    let (name, page) = page(command)?;
    Ok(files::write(&folder.join(name), &page)?)
}

/// A command's page, after the name of its file.
fn page(command: Command) -> Outcome<(String, Vec<u8>)> {
    let man = Man::new(command);
    let mut page = Vec::new();
    man.render(&mut page)?;
    Ok((man.get_filename(), page))
}
