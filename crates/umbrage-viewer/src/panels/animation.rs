//! What moves in the world: which animation, whether it plays, and its time.

use eframe::egui;
use umbrage_scene::rig::{Animation, Rig};

use crate::view_state::ViewState;

/// Shows the widgets.
pub fn show(ui: &mut egui::Ui, view: &mut ViewState, rig: &Rig) {
    if !rig.animations.is_empty() {
        choice(ui, view, rig);
    }
    ui.horizontal(|ui| {
        ui.checkbox(&mut view.playing, "animate")
            .on_hover_text("Lets objects and lights move that do so in this world (Space).");
        let time = egui::DragValue::new(&mut view.seconds).speed(0.05).suffix(" s").range(0.0..=86_400.0);
        let response = ui.add(time).on_hover_text("Time of the animation, seconds from its start.");
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, "time"));
    });
    let shown = view.animation.and_then(|animation| rig.animations.get(animation));
    if let Some(animation) = shown.filter(|animation| animation.seconds > 0.0) {
        along(ui, view, animation);
    }
}

/// Which animation is shown.
fn choice(ui: &mut egui::Ui, view: &mut ViewState, rig: &Rig) {
    let chosen = view.animation.map_or_else(|| "none".to_owned(), |chosen| name(rig, chosen));
    let choices = (0..rig.animations.len()).map(Some).chain([None]);
    let box_ = egui::ComboBox::from_label("animation").selected_text(chosen).show_ui(ui, |ui| {
        for choice in choices {
            let text = choice.map_or_else(|| "none".to_owned(), |choice| name(rig, choice));
            if ui.selectable_label(view.animation == choice, text).clicked() && view.animation != choice {
                (view.animation, view.seconds) = (choice, 0.0);
            }
        }
    });
    box_.response.on_hover_text("Which of the file's animations moves its nodes; none leaves them at rest.");
}

/// The time within the animation, which begins again at its end.
fn along(ui: &mut egui::Ui, view: &mut ViewState, animation: &Animation) {
    let mut place = animation.local_time(view.seconds);
    // At the very end it begins again.
    let slider = egui::Slider::new(&mut place, 0.0..=animation.seconds.next_down())
        .text("along it")
        .suffix(" s")
        .max_decimals(3);
    let slider = ui
        .add(slider)
        .on_hover_text("The time since the animation began, the last time, seconds. Dragging stops it.");
    // It also rounds what plays by.
    if slider.dragged() || slider.has_focus() {
        (view.seconds, view.playing) = (place, false);
    }
}

fn name(rig: &Rig, animation: usize) -> String {
    match rig.animations.get(animation) {
        Some(Animation { name, .. }) if !name.is_empty() => name.clone(),
        Some(_) | None => format!("animation {animation}"),
    }
}
