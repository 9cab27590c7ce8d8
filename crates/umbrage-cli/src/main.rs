//! The program `umbrage`; everything that it does is in the library beside it.

use std::process::ExitCode;

fn main() -> ExitCode {
    umbrage_cli::main()
}
