//! How wrong the shadows are, compared with ray-traced ground truth.

use eframe::egui;

use crate::truth::{Figures, TruthOverlay};
use crate::view_state::ViewState;

const HELP: &str = "Rays are traced to every light, tile by tile, once the picture holds still (T). Orange: in shadow, and should be lit. Blue: lit, and should be in shadow. Grey: right, behind glass. Dark: not judged.";

const ASK_HELP: &str = "A click on the picture says which map serves the pixel, what its texel stores, what is true there, and why the two differ (I). Ctrl and a click do so at any time.";

/// Shows the panel.
pub fn show(ui: &mut egui::Ui, view: &mut ViewState, truth: &TruthOverlay) {
    ui.heading("Ground truth");
    ui.checkbox(&mut view.truth, "show errors").on_hover_text(HELP);
    ui.checkbox(&mut view.asks, "ask a pixel why").on_hover_text(ASK_HELP);
    if !view.truth {
        return;
    }
    if view.frozen_camera.is_some() {
        ui.weak("not compared while the planned camera is frozen");
    } else if view.playing || view.follows_path() {
        ui.weak("stop what moves to compare");
    } else {
        figures(ui, truth);
    }
}

fn figures(ui: &mut egui::Ui, truth: &TruthOverlay) {
    let Some(traced) = truth.traced() else {
        ui.weak("waiting for the picture to hold still");
        return;
    };
    ui.add(egui::ProgressBar::new(traced as f32).text(format!("{:.0} % traced", traced * 100.0)));
    let sides: Vec<&Figures> = (0..2).filter_map(|side| truth.figures(side)).collect();
    let row = |ui: &mut egui::Ui, name: &str, help: &str, of: &dyn Fn(&Figures) -> String| {
        ui.label(name).on_hover_text(help);
        for figures in &sides {
            ui.monospace(of(figures));
        }
        ui.end_row();
    };
    let percent = |share: f64| format!("{:.3} %", share * 100.0);
    egui::Grid::new("figures").striped(true).show(ui, |ui| {
        if sides.len() > 1 {
            ui.label("");
            ui.label("left");
            ui.label("right");
            ui.end_row();
        }
        row(ui, "false shadow", "The share of judged pixels that are in shadow, and should be lit.", &|f| {
            percent(f.tally.false_shadow_share())
        });
        row(ui, "false light", "The share of judged pixels that are lit, and should be in shadow.", &|f| {
            percent(f.tally.false_light_share())
        });
        row(ui, "mis-shadowed", "The sum of both.", &|f| percent(f.tally.mis_shadowed()));
        let help = "How far visibility is from the truth in the mean, 0 to 1: also where a shade stays on the right side of one half.";
        row(ui, "mean error", help, &|f| format!("{:.4}", f.tally.mae()));
        let help = "Wrong pixels for each pixel of true shadow edge, once all is traced.";
        row(ui, "edge displacement", help, &|f| {
            f.edge_displacement_px.map_or("…".to_owned(), |px| format!("{px:.3} px"))
        });
        row(ui, "judged", "Pixels that are traced and judged so far, of every light.", &|f| {
            f.tally.judged.to_string()
        });
    });
}
