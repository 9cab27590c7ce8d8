//! The window and the web page: any world with its shadows, every setting while it runs, how shadows are made, and how
//! wrong each pixel is.
//!
//! [`Viewer`] is the program, for eframe: the same in a window (`native::run`) and in a browser (`web`). What
//! is shown is drawn by `umbrage-render`, and judged by `umbrage-judge`, in between the window's own frames.
//!
//! This crate does not: know how shadows are made, judged or read from files, nor settings by their names, but
//! λ, its scheme, cuts by hand, and what has a kind. Things that move are judged while they stand.

pub mod choices;
pub mod edit;
pub mod flight;
pub mod lines;
pub mod load;
pub mod overlay;
pub mod probe;
pub mod rust_text;
pub mod settings_panel;
pub mod sky;
pub mod take;

mod app;
mod arrivals;
mod blit;
mod colours;
mod input;
mod layout;
mod method_panel;
mod picture;
mod split_plot;
mod stage;
mod task;
mod timings;
mod top_bar;
mod trouble;
mod truth_panel;
mod world_panel;

#[cfg(not(target_arch = "wasm32"))]
pub mod bench;
#[cfg(not(target_arch = "wasm32"))]
pub mod native;
#[cfg(target_arch = "wasm32")]
pub mod web;

pub use app::{Start, Viewer};
