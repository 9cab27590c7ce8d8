//! The window and the web page: any world with its shadows, every setting while it runs, and how wrong each pixel is.
//!
//! This crate does not: know how shadows are made, judged or read from files. It shows what the other crates say.

#[cfg(target_arch = "wasm32")]
pub mod web;

/// The program.
#[derive(Debug, Default)]
pub struct Viewer {}

impl eframe::App for Viewer {
    fn ui(&mut self, ui: &mut eframe::egui::Ui, _frame: &mut eframe::Frame) {
        ui.label("Umbrage");
    }
}
