//! What is seen, and when: time of day, time, the way the camera moves.

use eframe::egui;

use crate::app::Viewer;
use crate::choices::{OnPath, Shown, is_sun};
use crate::sky;

impl Viewer {
    pub(crate) fn world_panel(&mut self, ui: &mut egui::Ui) {
        ui.heading("World");
        let (Some(choices), Some(stage)) = (&mut self.choices, &self.stage) else {
            ui.weak("nothing is loaded yet");
            return;
        };
        let scene = stage.scene();
        if scene.lights.iter().any(is_sun) {
            ui.horizontal(|ui| {
                let mut own = choices.hour.is_none();
                let box_ = ui.checkbox(&mut own, "the world's own sun");
                if box_.on_hover_text("Off, the time of day says where the sun is.").changed() {
                    choices.hour = if own { None } else { Some(9.0) };
                }
            });
            let mut hour = choices.hour.unwrap_or(12.0);
            let slider = egui::Slider::new(&mut hour, sky::DAY[0]..=sky::DAY[1])
                .text("time of day")
                .suffix(" h")
                .max_decimals(2);
            let slider = ui
                .add(slider)
                .on_hover_text("Where the sun is, at 50° north in the middle of May: Meeus 1998, eq. 13.6.");
            if slider.changed() {
                choices.hour = Some(hour);
            }
        } else {
            ui.weak("this world has lamps, and no sun");
        }
        ui.horizontal(|ui| {
            ui.checkbox(&mut choices.playing, "let things move")
                .on_hover_text("Things and lamps that move (Space).");
            let time =
                egui::DragValue::new(&mut choices.seconds).speed(0.05).suffix(" s").range(0.0..=86_400.0);
            let response = ui.add(time).on_hover_text("When, seconds from the start.");
            response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, "time"));
        });
        let speed = egui::Slider::new(&mut choices.flight.speed, 0.1..=500.0)
            .logarithmic(true)
            .text("speed")
            .clamping(egui::SliderClamping::Edits)
            .suffix(" m/s");
        ui.add(speed).on_hover_text("How fast keys move the camera; Shift is four times as fast.");
        if let Some(OnPath { along, held }) = &mut choices.path {
            let mut place = *along;
            let slider = egui::Slider::new(&mut place, 0.0..=1.0).text("along the path").max_decimals(3);
            let slider = ui
                .add(slider)
                .on_hover_text("How far along the world's path the camera is. Dragging holds it there.");
            // It also rounds what flies by.
            if slider.dragged() || slider.has_focus() {
                (*along, *held) = (place, true);
            }
            ui.checkbox(held, "hold").on_hover_text("The camera stays on the path where it is.");
        }
        let smooth = ui.checkbox(&mut choices.smooth, "smooth edges");
        smooth.on_hover_text("Four samples a pixel. Dear without a GPU. What is judged always has one.");
        let mut shadows = choices.shown != Shown::Unshadowed;
        if ui
            .checkbox(&mut shadows, "shadows")
            .on_hover_text("Off, none are drawn: what do they cost?")
            .changed()
        {
            choices.shown = if shadows { Shown::Shadows } else { Shown::Unshadowed };
        }
        let mut compare = choices.compare;
        if ui
            .checkbox(&mut compare, "compare two settings")
            .on_hover_text("Side by side, with a divider to drag (C).")
            .changed()
        {
            self.set_compare(compare);
        }
    }
}
