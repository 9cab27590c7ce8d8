//! The window and the web page: any world with its shadows, every setting while it runs, how shadows are made, and how
//! wrong each pixel is.
//!
//! [`Viewer`] is the program, for eframe: the same in a window (`native::run`) and in a browser (`web`). What it shows is
//! a session: a world, the state of the view, its pictures, and their comparison with ray-traced ground truth. Pictures are drawn by `umbrage-render` and judged by `umbrage-judge` between the window's own frames.
//!
//! This crate does not: know how shadows are made, judged or read from files, nor settings by their names, except λ, the
//! split scheme and distances, the kinds of filters and shades. Moving objects are judged while they stand.

pub mod flight;
pub mod lessons;
pub mod lines;
pub mod link;
pub mod load;
pub mod panels;
pub mod probe;
pub mod rust_text;
pub mod truth;
pub mod view_state;
pub mod why;
pub mod world;

mod action;
mod bookmarks;
mod bvh_build;
mod caster_build;
mod colours;
mod device_errors;
mod drawing;
mod edit;
mod event;
mod export;
mod files;
mod history;
mod input;
mod keep;
mod messages;
mod moved_lights;
pub mod pick;
mod said;
mod session;
mod sky;
mod task;
mod tasks;
mod timings;
mod viewer;

#[cfg(not(target_arch = "wasm32"))]
pub mod bench;
#[cfg(target_arch = "wasm32")]
pub mod browser;
#[cfg(not(target_arch = "wasm32"))]
pub mod native;
#[cfg(not(target_arch = "wasm32"))]
pub mod reload;
#[cfg(target_arch = "wasm32")]
pub mod web;

pub use viewer::{Start, Viewer};
