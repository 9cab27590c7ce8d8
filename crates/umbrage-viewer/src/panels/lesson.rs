//! The window that explains what a lesson shows.

use eframe::egui;

use crate::action::Action;
use crate::lessons::LESSONS;

/// Shows the window of the lesson with this number, and the ways to the lessons before and after it.
pub fn show(context: &egui::Context, number: &mut Option<usize>) -> Option<Action> {
    let i = (*number)?;
    let lesson = LESSONS.get(i)?;
    let mut is_open = true;
    let window = egui::Window::new(format!("Lesson {}: {}", i + 1, lesson.title));
    let window =
        window.id(egui::Id::unique("lesson")).open(&mut is_open).default_width(380.0).collapsible(true);
    let place = context.content_rect().left_bottom() + egui::vec2(288.0, -190.0);
    let shown = window.default_pos(place).show(context, |ui| {
        ui.add(egui::Label::new(lesson.text).wrap());
        ui.horizontal(|ui| {
            let before = ui.add_enabled(i > 0, egui::Button::new("back"));
            let after = ui.add_enabled(i + 1 < LESSONS.len(), egui::Button::new("next"));
            let before = before.on_hover_text("The lesson before this one.").clicked();
            let after = after.on_hover_text("The lesson after this one.").clicked();
            before.then(|| i - 1).or(after.then_some(i + 1)).map(Action::Learn)
        })
        .inner
    });
    if !is_open {
        *number = None;
    }
    shown?.inner?
}
