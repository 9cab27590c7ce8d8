//! Experiments on shadows: what is measured, stored, and reported.
//!
//! A [`Run`] is one measurement and everything it depends on: a world, a camera, settings, a repeat. [`Laboratory`]
//! measures a run: it draws it, judges it against exact shadows and times it, and gives a [`Measurement`]. An
//! [`Experiment`] is a file that says which runs to measure and what its source claimed of them. [`Store`] keeps each
//! run's outcome under a hash of its inputs, so that nothing is measured twice; a [`Shard`] is a share of the runs, and
//! [`merge`](merge()) makes one store of several. [`page`] makes of it all one HTML file
//! that needs nothing else, and beside it verdicts, tables and plots as files.
//!
//! This crate does not: know how shadows are made or judged, parse a command line, or print.

pub mod aliasing;
pub mod csv;
pub mod figures;
pub mod files;
pub mod heat;
pub mod page;
pub use umbrage_interchange::settings;
pub mod tabulate;

mod error;
mod experiment;
mod flicker;
mod foreign;
mod judgement;
mod laboratory;
mod measure;
mod measurement;
mod merge;
mod path;
mod program;
mod rays;
mod rows;
mod run;
mod shard;
mod shot;
mod store;
mod technique;
mod timed;
mod truth_kind;
mod truths;

pub use error::LabError;
pub use experiment::{Claim, Entry, Experiment, Plot, Sweep, Variant};
pub use foreign::{Foreign, ForeignError, Wrong};
pub use laboratory::{Judged, Laboratory};
pub use measurement::{
    Machine, MadeReady, MeasuredLight, Measurement, Milliseconds, Outcome, Pictures, TruthCounts,
};
pub use merge::{MergeError, merge};
pub use path::{Motion, Watch};
pub use program::Program;
pub use rays::Rays;
pub use rows::{Row, measure_all};
pub use run::{AreaLight, Run};
pub use shard::{NoShard, Shard};
pub use shot::Shot;
pub use store::Store;
pub use technique::{OfFamily, Technique};
pub use truth_kind::{SUB_PIXELS, SmoothTruth, TruthKind};

/// The version that this was built from, with the commit and its day where there is a repository:
/// `0.1.0 (a84e2f0bc1, 2026-11-29)`, with `, changed` after the day where sources differ from the commit.
pub const VERSION: &str = env!("UMBRAGE_VERSION");
