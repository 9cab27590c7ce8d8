//! What people should read, and what is under way, over the picture.

use eframe::egui;

use crate::action::Action;

/// Shows what is under way and the messages in the corner of the picture's rectangle.
pub fn show(
    ui: &mut egui::Ui,
    picture: egui::Rect,
    under_way: &[&str],
    messages: &[String],
) -> Option<Action> {
    if messages.is_empty() && under_way.is_empty() {
        return None;
    }
    let place = picture.left_top() + egui::vec2(12.0, 12.0);
    let area = egui::Area::new(ui.scope_id().with("messages")).fixed_pos(place);
    let shown = area.show(ui.ctx(), |ui| {
        ui.set_max_width((picture.width() - 24.0).max(160.0));
        for what in under_way {
            egui::Frame::popup(ui.style()).show(ui, |ui| {
                ui.horizontal(|ui| {
                    ui.spinner();
                    ui.label(*what);
                });
            });
        }
        // Many are scrolled, so that the picture is still seen.
        let most = 0.5 * picture.height();
        let area = egui::ScrollArea::vertical().max_height(most).min_scrolled_height(most);
        area.show(ui, |ui| list(ui, messages)).inner
    });
    shown.inner
}

fn list(ui: &mut egui::Ui, messages: &[String]) -> Option<Action> {
    let mut closed = None;
    for (number, message) in messages.iter().enumerate() {
        egui::Frame::popup(ui.style()).show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                ui.label(message);
                if ui.button("close").on_hover_text("Closes this message.").clicked() {
                    closed = Some(Action::CloseMessage(number));
                }
            });
        });
    }
    let several = messages.len() > 2;
    if several && ui.button("close all").on_hover_text("Closes all messages.").clicked() {
        closed = Some(Action::CloseMessages);
    }
    closed
}
