//! The picture: one side or two with a divider between them, and lines and verdicts over it.

use eframe::egui::{self, Color32, Pos2, Rect, Sense, Stroke, pos2};

use super::light_handles;
use crate::action::{Action, Toggle};
use crate::pick::{self, Pick};
use crate::session::Session;
use crate::view_state::ViewState;
use crate::{colours, input, lines};

/// Half the width of the divider's handle, points.
const GRIP: f32 = 8.0;

/// Draws and shows the picture in all the room that there is. Returns the rectangle that it fills. On a lost device nothing
/// is drawn.
pub fn show(ui: &mut egui::Ui, session: Option<&mut Session>, is_lost: bool) -> (Rect, Vec<Action>) {
    let rect = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(rect, Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "the picture"));
    if response.clicked() || response.dragged() {
        // The focus leaves text fields, so that keys fly again.
        ui.memory_mut(|memory| memory.focused().into_iter().for_each(|id| memory.surrender_focus(id)));
    }
    let Some(session) = session else {
        ui.painter().rect_filled(rect, 0.0, Color32::from_gray(24));
        return (rect, Vec::new());
    };
    if input::point(ui, &response, &mut session.view.flight) {
        // Whoever takes the camera in hand leaves the path.
        session.view.path = None;
        ui.ctx().request_repaint();
    }
    let mut actions = Vec::new();
    let size = size_px(rect, ui.pixels_per_point(), session.drawing.max_side_px());
    actions.extend(ask(ui, &response, session, size));
    if !is_lost && let Err(why) = session.draw(ui.ctx(), size) {
        session.give_up();
        actions.push(Action::Say(format!("this cannot be drawn: {why}")));
    }
    if !is_lost && let Err(why) = session.answer(ui.ctx(), size) {
        actions.push(Action::Say(format!("this pixel cannot be explained: {why}")));
    }
    paint(ui, session, rect);
    mark(ui, session, rect, size);
    if session.view.handles {
        light_handles::show(ui, &mut session.view, &session.world.scene, rect);
    }
    divider(ui, &mut session.view, rect);
    actions.extend(show_panels_button(ui, &session.view, rect));
    (rect, actions)
}

/// Asks why of the pixel that is clicked on.
fn ask(ui: &egui::Ui, response: &egui::Response, session: &mut Session, size: [u32; 2]) -> Option<Action> {
    let asks = session.view.asks || ui.input(|input| input.modifiers.command);
    let place = response.interact_pointer_pos().filter(|_| response.clicked() && asks)?;
    let view = &session.view;
    if view.playing || view.follows_path() {
        let why = "a pixel is explained while the picture holds still: stop the animation and the flight along the path, and ask again";
        return Some(Action::Say(why.to_owned()));
    }
    let is_right = place.x >= response.rect.left() + response.rect.width() * view.divider;
    let side = usize::from(view.compare && is_right);
    let light = session.pick.as_ref().map_or(0, |pick| pick.light);
    session.pick = Some(Pick::new(pick::pixel_at(place, response.rect, size), side, light));
    None
}

/// Marks the pixel that is asked about.
fn mark(ui: &egui::Ui, session: &Session, rect: Rect, size: [u32; 2]) {
    let Some(pick) = &session.pick else { return };
    let painter = ui.painter_at(rect);
    let place = pick::place_of(pick.pixel, rect, size);
    painter.circle_stroke(place, 7.0, Stroke::new(3.0, Color32::BLACK));
    painter.circle_stroke(place, 7.0, Stroke::new(1.5, Color32::WHITE));
}

/// How many pixels a rectangle has, at least one and at most as many as the device can draw.
fn size_px(rect: Rect, pixels_per_point: f32, most: u32) -> [u32; 2] {
    [rect.width(), rect.height()].map(|side| ((side * pixels_per_point).round() as u32).clamp(1, most))
}

/// Puts the sides, their verdicts and lines on the screen.
fn paint(ui: &egui::Ui, session: &Session, rect: Rect) {
    let Session { view, drawing, truth, .. } = session;
    let painter = ui.painter_at(rect);
    let divider = if view.compare { view.divider } else { 1.0 };
    let shares = [0.0..divider, divider..1.0];
    for (side, share) in shares.into_iter().enumerate().take(drawing.sides()) {
        let part = |x: f32| rect.left() + rect.width() * x;
        // Each side is all of the picture, and seen through its share of the screen.
        let window = Rect::from_x_y_ranges(part(share.start)..=part(share.end), rect.y_range());
        let painter = painter.with_clip_rect(window.intersect(painter.clip_rect()));
        painter.extend(drawing.picture(side, rect));
        if let Some(id) = truth.texture(side).filter(|_| view.compares_with_truth()) {
            painter.image(id, rect, Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0)), Color32::WHITE);
        }
    }
    if view.lines.any() {
        // They are of the left side.
        let left = rect.with_max_x(rect.left() + rect.width() * divider);
        paint_lines(session, &ui.painter_at(left), rect);
    }
}

fn paint_lines(session: &Session, painter: &egui::Painter, rect: Rect) {
    let Session { world, view, drawing, .. } = session;
    let Some(plan) = drawing.plan(0) else { return };
    let Ok(camera) = umbrage_render::camera(&view.camera(), rect.width() / rect.height()) else { return };
    let bounds = world.scene.bounds_in(&view.pose(&world.scene));
    let reach = 1.5 * f64::from(bounds.min.abs().max(bounds.max.abs()).max_element());
    for (split, line) in lines::of_plan(plan, view.lines, reach) {
        if let Some(ends) = lines::project(&camera, line) {
            let place = |p: glam::Vec2| rect.min + rect.size() * egui::vec2(p.x, p.y);
            let stroke = Stroke::new(1.5, colours::of_split(split).gamma_multiply(1.2));
            painter.line_segment(ends.map(place), stroke);
        }
    }
}

/// The button that brings the panels back, for those who have no keys.
fn show_panels_button(ui: &egui::Ui, view: &ViewState, rect: Rect) -> Option<Action> {
    if view.panels {
        return None;
    }
    let place = rect.right_top() + egui::vec2(-64.0, 8.0);
    let area = egui::Area::new(ui.scope_id().with("show panels"))
        .fixed_pos(place)
        .show(ui.ctx(), |ui| ui.button("Show").on_hover_text("Brings the panels back (H).").clicked());
    area.inner.then_some(Action::Toggle(Toggle::Panels))
}

/// The line between two sides, and the handle that moves it.
fn divider(ui: &mut egui::Ui, view: &mut ViewState, rect: Rect) {
    if !view.compare {
        return;
    }
    let x = rect.left() + rect.width() * view.divider;
    let handle = Rect::from_x_y_ranges(x - GRIP..=x + GRIP, rect.y_range());
    let response = ui.interact(handle, ui.scope_id().with("divider"), Sense::drag());
    response.widget_info(|| {
        egui::WidgetInfo::slider(true, f64::from(view.divider), "divider between the two sides")
    });
    if let Some(Pos2 { x, .. }) = response.interact_pointer_pos().filter(|_| response.dragged()) {
        view.divider = ((x - rect.left()) / rect.width().max(1.0)).clamp(0.02, 0.98);
    }
    let response = response
        .on_hover_cursor(egui::CursorIcon::ResizeHorizontal)
        .on_hover_text("Drag: more of the left side, or of the right one.");
    let colour = if response.hovered() { Color32::WHITE } else { Color32::from_white_alpha(160) };
    ui.painter().vline(x, rect.y_range(), Stroke::new(2.0, colour));
    ui.painter().circle(pos2(x, rect.center().y), GRIP, colour, Stroke::new(1.0, Color32::BLACK));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_has_a_pixel_at_least_and_no_more_than_the_device_can_draw() {
        let rect = |width, height| Rect::from_min_size(Pos2::ZERO, egui::vec2(width, height));
        assert_eq!(size_px(rect(100.4, 50.0), 2.0, 4096), [201, 100]);
        assert_eq!(size_px(rect(0.0, -3.0), 1.0, 4096), [1, 1]);
        assert_eq!(size_px(rect(9000.0, 10.0), 1.0, 4096), [4096, 10]);
    }
}
