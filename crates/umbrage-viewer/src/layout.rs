//! What stands in which panel, and which windows lie over the picture.

use eframe::egui;

use crate::app::Viewer;
use crate::{input, settings_panel};

impl Viewer {
    pub(crate) fn seen_panels(&mut self, ui: &mut egui::Ui) {
        self.world_panel(ui);
        ui.separator();
        self.method_panel(ui);
        ui.separator();
        self.truth_panel(ui);
    }

    pub(crate) fn settings_panels(&mut self, ui: &mut egui::Ui) {
        let Some(choices) = &mut self.choices else { return };
        if choices.compare {
            ui.horizontal(|ui| {
                ui.selectable_value(&mut choices.edited, 0, "left").on_hover_text("Change the left side.");
                ui.selectable_value(&mut choices.edited, 1, "right").on_hover_text("Change the right side.");
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
