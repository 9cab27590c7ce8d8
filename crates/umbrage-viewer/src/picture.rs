//! The picture: drawn when it changes, one side or two with a divider between them, lines and what is wrong over it.

use eframe::egui::{self, Color32, Pos2, Rect, Sense, Stroke, pos2};
use umbrage_render::{Frame, RenderError};

use crate::app::Viewer;
use crate::choices::Choices;
use crate::stage::Stage;
use crate::{colours, input, lines, overlay};

/// Half the width of the divider's handle, points.
const GRIP: f32 = 8.0;

/// Shows it in all the room that there is.
pub fn show(viewer: &mut Viewer, ui: &mut egui::Ui) {
    let rect = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(rect, Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "the picture"));
    if response.clicked() || response.dragged() {
        // What was typed in is left, so that keys fly again.
        ui.memory_mut(|memory| memory.focused().into_iter().for_each(|id| memory.surrender_focus(id)));
    }
    if viewer.stage.is_none() {
        ui.painter().rect_filled(rect, 0.0, Color32::from_gray(24));
    }
    if let Some(choices) = &mut viewer.choices {
        // Whoever takes the camera in hand leaves the path.
        if input::pointed(ui, &response, &mut choices.flight) {
            choices.path = None;
            ui.ctx().request_repaint();
        }
    }
    let drawn = if viewer.lost().is_none() { draw(viewer, ui, rect) } else { Ok(()) };
    if let Err(why) = drawn {
        viewer.is_tracing = false;
        if let Some(choices) = &mut viewer.choices {
            // Not again with every frame.
            choices.overlay = false;
        }
        viewer.say(format!("this cannot be drawn: {why}"));
    }
    paint(viewer, ui, rect);
    divider(viewer, ui, rect);
    way_back(viewer, ui, rect);
    messages(viewer, ui, rect);
}

/// Draws what changed, and goes on tracing where nothing did.
fn draw(viewer: &mut Viewer, ui: &egui::Ui, rect: Rect) -> Result<(), RenderError> {
    let pixels = size_px(rect, ui.pixels_per_point(), viewer.gpu.device.limits().max_texture_dimension_2d);
    let show = viewer.show();
    let (Some(choices), Some(stage)) = (&viewer.choices, &mut viewer.stage) else { return Ok(()) };
    let frame = frame(choices, stage, pixels)?;
    let mut drawn = false;
    for side in 0..stage.sides() {
        drawn |= stage.draw(side, &Frame { show: show.clone(), ..frame.clone() })?;
    }
    let now = ui.input(|input| input.time);
    for side in 0..stage.sides() {
        // Those of the other side are taken too, so that they do not pile up.
        let times = stage.times(side);
        if side == 0 {
            times.into_iter().for_each(|times| viewer.timings.push(now, times));
        }
    }
    if !choices.overlay || choices.frozen.is_some() {
        viewer.is_tracing = false;
        viewer.overlay.stop();
        return Ok(());
    }
    let shot = overlay::Shot {
        camera: choices.camera(),
        lights: choices.lights(stage.scene()),
        frames: vec![frame; stage.sides()],
        version: viewer.version,
    };
    // While the picture changes, nothing is traced: it would slow it, and be thrown away.
    if drawn {
        viewer.overlay.keep(&shot);
        viewer.is_tracing = true;
        return Ok(());
    }
    // As far as both sides have shadows: what one leaves out is not the other's fault.
    let ends = (0..stage.sides()).filter_map(|side| stage.plan(side)?.splits().last().copied());
    let distance = ends.fold(f64::INFINITY, f64::min);
    viewer.is_tracing = viewer.overlay.advance(ui.ctx(), stage, viewer.world, &shot, distance)?;
    Ok(())
}

/// The frame that a picture of so many pixels is.
fn frame(choices: &Choices, stage: &Stage, [width, height]: [u32; 2]) -> Result<Frame, RenderError> {
    let aspect = width as f32 / height as f32;
    let lights = choices.lights(stage.scene());
    let show = umbrage_render::Show::World;
    let frame = Frame::of(&choices.camera(), &lights, choices.seconds, [width, height], show)?;
    Ok(Frame {
        planned_for: choices
            .frozen
            .as_ref()
            .map(|camera| umbrage_render::camera(camera, aspect))
            .transpose()?,
        samples: if choices.smooth { 4 } else { 1 },
        ..frame
    })
}

/// How many pixels a rectangle has, as many as the device can draw at most.
fn size_px(rect: Rect, pixels_per_point: f32, most: u32) -> [u32; 2] {
    [rect.width(), rect.height()].map(|side| ((side * pixels_per_point).round() as u32).clamp(1, most))
}

/// Puts the sides, what is wrong, and lines on the screen.
fn paint(viewer: &Viewer, ui: &egui::Ui, rect: Rect) {
    let (Some(choices), Some(stage)) = (&viewer.choices, &viewer.stage) else { return };
    let painter = ui.painter_at(rect);
    let divider = if choices.compare { choices.divider } else { 1.0 };
    let shares = [0.0..divider, divider..1.0];
    for (side, share) in shares.into_iter().enumerate().take(stage.sides()) {
        let part = |x: f32| rect.left() + rect.width() * x;
        // Each side is all of the picture, and seen through its share of the screen.
        let window = Rect::from_x_y_ranges(part(share.start)..=part(share.end), rect.y_range());
        let painter = painter.with_clip_rect(window.intersect(painter.clip_rect()));
        painter.extend(stage.picture(side, rect));
        let is_judged = choices.overlay && choices.frozen.is_none();
        if let Some(id) = viewer.overlay.picture(side).filter(|_| is_judged) {
            painter.image(id, rect, Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0)), Color32::WHITE);
        }
    }
    if choices.lines.any() {
        // They are of the left side.
        let left = rect.with_max_x(rect.left() + rect.width() * divider);
        paint_lines(choices, stage, &ui.painter_at(left), rect);
    }
}

fn paint_lines(choices: &Choices, stage: &Stage, painter: &egui::Painter, rect: Rect) {
    let Some(plan) = stage.plan(0) else { return };
    let Ok(camera) = umbrage_render::camera(&choices.camera(), rect.width() / rect.height()) else { return };
    let bounds = stage.scene().bounds_at(choices.seconds);
    let reach = 1.5 * f64::from(bounds.min.abs().max(bounds.max.abs()).max_element());
    for (split, line) in lines::of_plan(plan, choices.lines, reach) {
        if let Some(ends) = lines::project(&camera, line) {
            let place = |p: glam::Vec2| rect.min + rect.size() * egui::vec2(p.x, p.y);
            painter.line_segment(
                ends.map(place),
                Stroke::new(1.5, colours::of_split(split).gamma_multiply(1.2)),
            );
        }
    }
}

/// Brings the panels back, for those who have no keys.
fn way_back(viewer: &mut Viewer, ui: &egui::Ui, rect: Rect) {
    let Some(choices) = viewer.choices.as_mut().filter(|choices| !choices.panels) else { return };
    let place = rect.right_top() + egui::vec2(-64.0, 8.0);
    egui::Area::new(ui.scope_id().with("way back")).fixed_pos(place).show(ui.ctx(), |ui| {
        choices.panels = ui.button("Show").on_hover_text("Brings the panels back (H).").clicked();
    });
}

/// The line between two sides, and the handle that moves it.
fn divider(viewer: &mut Viewer, ui: &mut egui::Ui, rect: Rect) {
    let Some(choices) = viewer.choices.as_mut().filter(|choices| choices.compare) else { return };
    let x = rect.left() + rect.width() * choices.divider;
    let handle = Rect::from_x_y_ranges(x - GRIP..=x + GRIP, rect.y_range());
    let response = ui.interact(handle, ui.scope_id().with("divider"), Sense::drag());
    response.widget_info(|| {
        egui::WidgetInfo::slider(true, f64::from(choices.divider), "divider between the two sides")
    });
    if let Some(Pos2 { x, .. }) = response.interact_pointer_pos().filter(|_| response.dragged()) {
        choices.divider = ((x - rect.left()) / rect.width().max(1.0)).clamp(0.02, 0.98);
    }
    let response = response
        .on_hover_cursor(egui::CursorIcon::ResizeHorizontal)
        .on_hover_text("Drag: more of the left side, or of the right one.");
    let colour = if response.hovered() { Color32::WHITE } else { Color32::from_white_alpha(160) };
    ui.painter().vline(x, rect.y_range(), Stroke::new(2.0, colour));
    ui.painter().circle(pos2(x, rect.center().y), GRIP, colour, Stroke::new(1.0, Color32::BLACK));
}

/// What people should read, and what is under way, over the picture.
fn messages(viewer: &mut Viewer, ui: &mut egui::Ui, rect: Rect) {
    let traces = viewer.choices.as_ref().is_some_and(|choices| choices.overlay);
    let under_way = [
        viewer.loading.as_ref().map(|task| task.what.clone()),
        viewer.overlay.waits_for().filter(|_| traces).map(str::to_owned),
    ];
    let under_way: Vec<String> = under_way.into_iter().flatten().collect();
    if viewer.messages.is_empty() && under_way.is_empty() {
        return;
    }
    let place = rect.left_top() + egui::vec2(12.0, 12.0);
    egui::Area::new(ui.scope_id().with("messages")).fixed_pos(place).show(ui.ctx(), |ui| {
        ui.set_max_width((rect.width() - 24.0).max(160.0));
        for what in under_way {
            egui::Frame::popup(ui.style()).show(ui, |ui| {
                ui.horizontal(|ui| {
                    ui.spinner();
                    ui.label(what);
                });
            });
        }
        // Many are scrolled, so that the picture is still seen.
        let most = 0.5 * rect.height();
        let area = egui::ScrollArea::vertical().max_height(most).min_scrolled_height(most);
        area.show(ui, |ui| said(viewer, ui));
    });
}

fn said(viewer: &mut Viewer, ui: &mut egui::Ui) {
    let mut closed = None;
    for (i, message) in viewer.messages.iter().enumerate() {
        egui::Frame::popup(ui.style()).show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                ui.label(message);
                if ui.button("close").on_hover_text("Closes this message.").clicked() {
                    closed = Some(i);
                }
            });
        });
    }
    let several = viewer.messages.len() > 2;
    if several && ui.button("close all").on_hover_text("Closes all messages.").clicked() {
        viewer.messages.clear();
        return;
    }
    closed.into_iter().for_each(|i| drop(viewer.messages.remove(i)));
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
