//! Handles in the picture that move lights.

use eframe::egui::{self, Color32, Rect, Sense, Stroke, pos2, vec2};
use umbrage_scene::{LightKind, Scene};

use crate::moved_lights::{Handle, Part, parts, project};
use crate::view_state::ViewState;

/// A handle's radius, points.
const RADIUS: f32 = 9.0;
/// How far from its middle a handle that is dragged on a sphere lies, as a share of the way from the picture's middle to its
/// nearer rim.
const REACH: f32 = 0.7;

/// Shows the handles over the picture, and moves the lights whose handles are dragged.
pub fn show(ui: &egui::Ui, view: &mut ViewState, scene: &Scene, rect: Rect) {
    let Ok(camera) = umbrage_render::camera(&view.camera(), rect.width() / rect.height().max(1.0)) else {
        return;
    };
    let (target, reach) = (view.flight.target(), REACH * half_extent(&camera, view.flight.distance));
    for (number, light) in view.numbered_lights(scene) {
        for part in parts(&light) {
            let handle = Handle::of(&light, *part, target, reach);
            let on_screen = |point| project(&camera, point).map(|[x, y]| rect.min + rect.size() * vec2(x, y));
            let Some(place) = on_screen(handle.point).filter(|place| rect.contains(*place)) else { continue };
            let response = widget(ui, number, *part, &light.name, place);
            if let Some(middle) = handle.middle.and_then(on_screen) {
                ui.painter_at(rect)
                    .line_segment([place, middle], Stroke::new(1.5, Color32::from_rgb(255, 220, 120)));
            }
            paint(ui, rect, place, &response);
            let pointer = response.interact_pointer_pos().filter(|_| response.dragged());
            let ndc = |pointer: egui::Pos2| {
                let share = (pointer - rect.min) / rect.size();
                pos2(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y)
            };
            let point = pointer.map(ndc).and_then(|ndc| handle.dragged(&camera, ndc.x, ndc.y));
            if let Some(point) = point {
                let before = view.moved_lights.get(&number).copied().unwrap_or_default();
                view.moved_lights.insert(number, handle.moved(&light, *part, before, point));
                if light.kind == LightKind::Directional {
                    // The hour would place it again.
                    view.hour = None;
                }
                ui.ctx().request_repaint();
            }
        }
    }
}

/// Half of the shorter side of what is seen at a distance, metres.
fn half_extent(camera: &umbrage::Camera, distance: f32) -> f32 {
    let m = camera.clip_from_view();
    let at_one = m.x_axis.x.max(m.y_axis.y).recip();
    // Parallel rays see as much at any distance.
    if m.w_axis.w == 0.0 { at_one * distance } else { at_one }
}

fn widget(ui: &egui::Ui, number: usize, part: Part, name: &str, place: egui::Pos2) -> egui::Response {
    let name = if name.is_empty() { format!("light {number}") } else { name.to_owned() };
    let (words, help) = match part {
        Part::At => (format!("position of {name}"), "Drag: the light moves across the picture."),
        Part::Way => (format!("direction of {name}"), "Drag: the light turns around what it shines at."),
    };
    let id = ui.scope_id().with(("light handle", number, part == Part::At));
    let response =
        ui.interact(Rect::from_center_size(place, egui::Vec2::splat(2.0 * RADIUS)), id, Sense::drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &words));
    response.on_hover_cursor(egui::CursorIcon::Grab).on_hover_text(format!("{words}. {help}"))
}

fn paint(ui: &egui::Ui, rect: Rect, place: egui::Pos2, response: &egui::Response) {
    let is_held = response.hovered() || response.dragged();
    let fill = if is_held { Color32::WHITE } else { Color32::from_rgb(255, 200, 60) };
    ui.painter_at(rect).circle(place, RADIUS, fill, Stroke::new(2.0, Color32::BLACK));
}
