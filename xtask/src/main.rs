//! Repository chores: `cargo xtask results` times every world into `docs/results.md`, `cargo xtask error` measures how
//! wrong the default is into `docs/error.md`, `cargo xtask biases` measures every kind of bias into `docs/biases.md`,
//! `cargo xtask claims` says which claims of the paper and the tutorial hold in `docs/claims.md`, `cargo xtask ferko` measures the
//! thesis' tables and figures again in `docs/ferko.md`, `cargo xtask families` sets other families of shadows beside maps in
//! `docs/families.md`, `cargo xtask exact` measures rays where maps are not sure in `docs/exact.md`, `cargo xtask filters` compares every
//! filter in `docs/filters.md`, `cargo xtask field` measures scenes that are far or large or small in `docs/field.md`,
//! `cargo xtask peers` sets Umbrage beside other renderers in `docs/peers.md`, `cargo xtask bevy` Bevy with Umbrage's plug-in beside
//! Bevy in `docs/bevy.md`, `cargo xtask pictures` draws the pictures of the documents, `cargo xtask documents` makes all of these
//! again, `cargo xtask web` builds the web page, `cargo xtask npm` the package for JavaScript.
//!
//! This crate does not: see any of the others. It runs the command `umbrage`, and joins and copies what that leaves.

mod biases;
mod claims;
mod command;
mod error;
mod field;
mod filters;
#[cfg(feature = "web")]
mod npm;
mod peers;
mod pictures;
mod reports;
mod results;
#[cfg(feature = "web")]
mod wasm;
#[cfg(feature = "web")]
mod web;

use clap::{Parser, Subcommand};

/// Repository chores.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask")]
struct Cli {
    #[command(subcommand)]
    chore: Chore,
}

/// What documents are made from that are put together from reports.
#[derive(Debug, clap::Args)]
struct Pages {
    /// Part of the name of the adapter to draw on
    #[arg(long)]
    adapter: Option<String>,
    /// A folder with what `umbrage report` leaves, where it is made already
    #[arg(long, value_name = "DIR")]
    pages: Option<std::path::PathBuf>,
}

#[derive(Debug, Subcommand)]
enum Chore {
    /// Measures every world and writes docs/results.md
    Results {
        /// Part of the name of the adapter to measure on
        #[arg(long)]
        adapter: Option<String>,
        /// Frames a world
        #[arg(long, default_value_t = 21)]
        frames: u32,
        /// Measure planning alone, and leave the rest as it is
        #[arg(long, conflicts_with_all = ["adapter", "frames"])]
        planning: bool,
    },
    /// Measures the default against exact shadows and writes docs/error.md
    Error {
        /// Part of the name of the adapter to draw on
        #[arg(long)]
        adapter: Option<String>,
    },
    /// Measures every kind of bias and writes docs/biases.md
    Biases(Pages),
    /// Says which claims of the paper and the tutorial hold, in docs/claims.md
    Claims(Pages),
    /// Measures the thesis' tables and figures again, in docs/ferko.md
    Ferko(Pages),
    /// Sets other families of shadows beside maps, in docs/families.md
    Families(Pages),
    /// Measures rays where maps are not sure, in docs/exact.md
    Exact(Pages),
    /// Compares every filter, in docs/filters.md
    Filters(Pages),
    /// Measures by distance from the origin and by scale, in docs/field.md
    Field(field::Args),
    /// Sets Umbrage beside other renderers on the same worlds, in docs/peers.md
    Peers(peers::Args),
    /// Sets Bevy with Umbrage's plug-in beside Bevy as it is, in docs/bevy.md
    Bevy(peers::plugin::Args),
    /// Draws the pictures of the documents
    Pictures,
    /// Makes every document and picture again, one after another; hours on a small machine
    Documents,
    #[cfg(feature = "web")]
    /// Builds the web page, and prints how large it is
    Web {
        /// The folder to write, seen from the repository's root
        #[arg(long, value_name = "DIR", default_value = "dist")]
        out: std::path::PathBuf,
    },
    #[cfg(feature = "web")]
    /// Builds the package for JavaScript, and prints how large it is
    Npm {
        /// The folder to write, seen from the repository's root
        #[arg(long, value_name = "DIR", default_value = "target/npm/umbrage")]
        out: std::path::PathBuf,
    },
}

fn main() -> anyhow::Result<()> {
    run(Cli::parse().chore)
}

fn run(chore: Chore) -> anyhow::Result<()> {
    match chore {
        Chore::Results { planning: true, .. } => results::write_planning(),
        Chore::Results { adapter, frames, .. } => results::write(adapter.as_deref(), frames),
        Chore::Error { adapter } => error::write(adapter.as_deref()),
        Chore::Biases(Pages { adapter, pages }) => biases::write(adapter.as_deref(), pages.as_deref()),
        Chore::Claims(Pages { adapter, pages }) => claims::CLAIMS.write(adapter.as_deref(), pages.as_deref()),
        Chore::Ferko(Pages { adapter, pages }) => claims::FERKO.write(adapter.as_deref(), pages.as_deref()),
        Chore::Families(Pages { adapter, pages }) => {
            claims::FAMILIES.write(adapter.as_deref(), pages.as_deref())
        }
        Chore::Exact(Pages { adapter, pages }) => claims::EXACT.write(adapter.as_deref(), pages.as_deref()),
        Chore::Filters(Pages { adapter, pages }) => filters::write(adapter.as_deref(), pages.as_deref()),
        Chore::Documents => documents(),
        Chore::Field(args) => field::write(&args),
        Chore::Peers(args) => peers::write(&args),
        Chore::Bevy(args) => peers::plugin::write(&args),
        Chore::Pictures => pictures::draw(),
        #[cfg(feature = "web")]
        Chore::Web { out } => web::build(&out),
        #[cfg(feature = "web")]
        Chore::Npm { out } => npm::build(&out),
    }
}

/// The chores that make documents, as they follow each other: what is timed comes first, while the machine is at rest.
const DOCUMENTS: [&str; 12] = [
    "peers", "bevy", "results", "exact", "families", "ferko", "filters", "claims", "error", "biases",
    "field", "pictures",
];

fn documents() -> anyhow::Result<()> {
    DOCUMENTS.into_iter().try_for_each(|chore| run(Cli::parse_from(["xtask", chore]).chore))
}
