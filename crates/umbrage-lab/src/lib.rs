//! Experiments on shadows: what is measured, stored, and reported.
//!
//! A [`Cell`] is one measurement and everything it depends on: a world, a camera, settings, a repeat. [`Laboratory`]
//! measures a cell: it draws it, judges it against exact shadows and times it, and gives a [`Measurement`]. An
//! [`Experiment`] is a file that says which cells to measure and what its source claimed of them. [`Store`] keeps each
//! cell's result under a hash of its inputs, so that nothing is measured twice. [`page`] makes of it all one HTML file
//! that needs nothing else.
//!
//! This crate does not: know how shadows are made or judged, parse a command line, or print.

pub mod aliasing;
pub mod csv;
pub mod figures;
pub mod files;
pub mod heat;
pub mod page;
pub mod settings;
pub mod tabulate;

mod cell;
mod error;
mod experiment;
mod flicker;
mod judgement;
mod laboratory;
mod lines;
mod measure;
mod measurement;
mod run;
mod store;
mod truths;

pub use cell::{AreaLight, Cell, Motion, SUB_PIXELS, SmoothTruth};
pub use error::LabError;
pub use experiment::{Claim, Entry, Experiment, Plot, Sweep, Way};
pub use flicker::Watch;
pub use laboratory::{Judged, Laboratory, Shot, TruthKind};
pub use measurement::{Machine, MeasuredLight, Measurement, Milliseconds, Outcome, Pictures, TruthCounts};
pub use run::{Row, run};
pub use store::Store;
