//! What stands in which panel, and which windows lie over the picture.

use eframe::egui;

use crate::app::Viewer;
use crate::{input, settings_panel};

/// How wide the panels are at first, points: of what is seen, and of settings.
const SEEN: f32 = 264.0;
const SETTINGS: f32 = 316.0;
/// How wide the picture must be, so that panels may stand beside it.
const PICTURE: f32 = 240.0;

impl Viewer {
    /// Panels beside the picture; below it where there is no room for that, as on a phone.
    pub(crate) fn panels(&mut self, ui: &mut egui::Ui) {
        // The window is cleared to their colour already, and a software adapter is spared to fill them.
        let side = egui::Frame::side_top_panel(ui.style()).fill(egui::Color32::TRANSPARENT);
        egui::Panel::top("bar").frame(side).show(ui, |ui| self.top_bar(ui));
        let scrolled = || egui::ScrollArea::vertical().auto_shrink(false);
        if ui.available_width() < SEEN + PICTURE + SETTINGS {
            let height = 0.45 * ui.available_height();
            egui::Panel::bottom("all panels").resizable(true).default_size(height).frame(side).show(
                ui,
                |ui| {
                    scrolled().show(ui, |ui| {
                        self.seen_panels(ui);
                        ui.separator();
                        self.settings_panels(ui);
                    });
                },
            );
            return;
        }
        egui::Panel::left("what is seen").default_size(SEEN).frame(side).show(ui, |ui| {
            scrolled().show(ui, |ui| self.seen_panels(ui));
        });
        egui::Panel::right("settings").default_size(SETTINGS).frame(side).show(ui, |ui| {
            scrolled().show(ui, |ui| self.settings_panels(ui));
        });
    }

    fn seen_panels(&mut self, ui: &mut egui::Ui) {
        self.world_panel(ui);
        ui.separator();
        self.method_panel(ui);
        ui.separator();
        self.truth_panel(ui);
    }

    fn settings_panels(&mut self, ui: &mut egui::Ui) {
        let Some(choices) = &mut self.choices else { return };
        if choices.compare {
            ui.horizontal(|ui| {
                for (side, name) in ["left", "right"].into_iter().enumerate() {
                    let value = ui.selectable_value(&mut choices.edited, side, name);
                    if value.on_hover_text(format!("Change the {name} side.")).changed() {
                        self.refused = None;
                    }
                }
            });
        }
        let settings = choices.settings[choices.edited].clone();
        if let Some(changed) = settings_panel::show(ui, &settings, &mut self.refused) {
            self.set_settings(changed);
        }
    }

    /// What is drawn without panels, over the picture.
    pub(crate) fn windows(&mut self, context: &egui::Context) {
        let Some(choices) = &mut self.choices else { return };
        egui::Window::new("Keys").open(&mut choices.help).resizable(false).show(context, |ui| {
            egui::Grid::new("keys").striped(true).show(ui, |ui| {
                for (key, what) in input::KEYS {
                    ui.strong(*key);
                    ui.label(*what);
                    ui.end_row();
                }
            });
        });
        if choices.maps {
            self.map_window(context);
        }
    }
}
