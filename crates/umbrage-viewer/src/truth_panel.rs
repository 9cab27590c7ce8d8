//! How wrong the shadows are, and how long they take.

use eframe::egui;

use crate::app::Viewer;
use crate::overlay::Figures;

impl Viewer {
    pub(crate) fn truth_panel(&mut self, ui: &mut egui::Ui) {
        ui.heading("Truth");
        let Some(choices) = &mut self.choices else { return };
        ui.checkbox(&mut choices.overlay, "show what is wrong").on_hover_text(
            "LightKind to every light, tile by tile, once the picture holds still (T). Orange: shadowed, and should be lit. Blue: lit, and should be shadowed. Dark: not judged.",
        );
        if choices.overlay {
            if choices.frozen.is_some() {
                ui.weak("not judged while the planned camera is frozen");
            } else if choices.playing || choices.flies() {
                ui.weak("stop what moves to have it judged");
            } else {
                self.figures_table(ui);
            }
        }
        ui.separator();
        ui.heading("Time");
        if let Some(median) = self.timings.median() {
            ui.label(format!("{median:.2} ms a picture on the device"))
                .on_hover_text("The median over the last ten seconds: casters, filter and shading.");
        }
        self.timings.show(ui);
    }

    fn figures_table(&self, ui: &mut egui::Ui) {
        let Some(traced) = self.overlay.traced() else {
            ui.weak("waiting for the picture to hold still");
            return;
        };
        ui.add(egui::ProgressBar::new(traced as f32).text(format!("{:.0} % traced", traced * 100.0)));
        let sides: Vec<&Figures> = (0..2).filter_map(|side| self.overlay.figures(side)).collect();
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
            row(ui, "false shadow", "Of judged pixels: shadowed, and should be lit.", &|f| {
                percent(f.tally.false_shadow_share())
            });
            row(ui, "false light", "Of judged pixels: lit, and should be shadowed.", &|f| {
                percent(f.tally.false_light_share())
            });
            row(ui, "mis-shadowed", "Both together.", &|f| percent(f.tally.mis_shadowed()));
            row(
                ui,
                "edges off by",
                "Wrong pixels for each pixel of true shadow edge; when all is traced.",
                &|f| f.edge_displacement_px.map_or("…".to_owned(), |px| format!("{px:.3} px")),
            );
            row(ui, "judged", "Pixels that are traced and judged so far, of every light.", &|f| {
                f.tally.judged.to_string()
            });
        });
    }
}
