//! The split distances on a linear scale over a logarithmic one, and λ between the two as a handle.
//!
//! Zhang et al. 2006, eqs. 4–6: splits are equal on the linear scale for λ = 0, and on the logarithmic one for λ = 1.

use eframe::egui;
use eframe::egui::{Pos2, Rect, Stroke, Vec2, pos2};

use crate::colours::of_split;

/// Height of the plot, points.
const HEIGHT: f32 = 96.0;

const HELP: &str = "The split distances, linear above and logarithmic below.";

/// Shows the split distances C_0 … C_m, metres, and returns another λ where the handle was dragged. Without `lambda` there is
/// no handle.
pub fn show(ui: &mut egui::Ui, distances: &[f64], lambda: Option<f32>) -> Option<f32> {
    let (Some(&near), Some(&far)) = (distances.first(), distances.last()) else { return None };
    let size = Vec2::new(ui.available_width().max(120.0), HEIGHT);
    let (rect, response) = ui.allocate_exact_size(size, egui::Sense::click_and_drag());
    let names: Vec<String> = distances.iter().map(|distance| format!("{distance:.1}")).collect();
    let words = format!("split distances {} m", names.join(", "));
    response.widget_info(|| match lambda {
        Some(lambda) => egui::WidgetInfo::slider(true, f64::from(lambda), format!("{words}, λ {lambda:.2}")),
        None => egui::WidgetInfo::labeled(egui::Role::Image, true, &words),
    });
    let painter = ui.painter_at(rect);
    let inner = rect.shrink2(Vec2::new(10.0, 18.0));
    let linear = |distance: f64| inner.left() + inner.width() * linear_place(distance, near, far) as f32;
    let logarithmic =
        |distance: f64| inner.left() + inner.width() * logarithmic_place(distance, near, far) as f32;
    for (split, pair) in distances.windows(2).enumerate() {
        let corners = vec![
            pos2(linear(pair[0]), inner.top()),
            pos2(linear(pair[1]), inner.top()),
            pos2(logarithmic(pair[1]), inner.bottom()),
            pos2(logarithmic(pair[0]), inner.bottom()),
        ];
        let fill = of_split(split).gamma_multiply(0.7);
        painter.add(egui::Shape::convex_polygon(corners, fill, Stroke::NONE));
    }
    let ink = Stroke::new(1.0, ui.visuals().text_color());
    painter.hline(inner.x_range(), inner.top(), ink);
    painter.hline(inner.x_range(), inner.bottom(), ink);
    for &distance in distances {
        let (above, below) = (linear(distance), logarithmic(distance));
        painter.line_segment([pos2(above, inner.top()), pos2(below, inner.bottom())], ink);
    }
    labels(ui, &painter, inner, near, far);
    let Some(lambda) = lambda else {
        response.on_hover_text(format!("{HELP} λ places them where the scheme is `practical`."));
        return None;
    };
    handle(ui, &painter, inner, lambda);
    let dragged = response.dragged() || response.clicked();
    let pointer = response.interact_pointer_pos();
    response.on_hover_text(format!("{HELP} They are equally far apart above for λ = 0, and below for λ = 1. Drag up and down to change λ.\n\nZhang et al. 2006, eqs. 4 to 6"));
    pointer.filter(|_| dragged).map(|at| lambda_at(at, inner)).filter(|new| *new != lambda)
}

fn handle(ui: &egui::Ui, painter: &egui::Painter, inner: Rect, lambda: f32) {
    let place = pos2(inner.right() - inner.width() * 0.02, inner.bottom() - inner.height() * (1.0 - lambda));
    let (ink, paper) = (ui.visuals().strong_text_color(), ui.visuals().extreme_bg_color);
    painter.circle(place, 6.0, ink, Stroke::new(1.0, paper));
    let words = format!("λ {lambda:.2}");
    painter.text(place - Vec2::new(10.0, 0.0), egui::Align2::RIGHT_CENTER, words, font(ui), ink);
}

fn lambda_at(at: Pos2, inner: Rect) -> f32 {
    let share = ((at.y - inner.top()) / inner.height()).clamp(0.0, 1.0);
    (share * 100.0).round() / 100.0
}

fn labels(ui: &egui::Ui, painter: &egui::Painter, inner: Rect, near: f64, far: f64) {
    let colour = ui.visuals().text_color();
    let text = |at, anchor, words: String| {
        painter.text(at, anchor, words, font(ui), colour);
    };
    text(inner.left_top(), egui::Align2::LEFT_BOTTOM, format!("{near:.1} m"));
    text(inner.center_top(), egui::Align2::CENTER_BOTTOM, "linear".to_owned());
    text(inner.right_top(), egui::Align2::RIGHT_BOTTOM, format!("{far:.0} m"));
    text(inner.center_bottom(), egui::Align2::CENTER_TOP, "logarithmic".to_owned());
}

fn font(ui: &egui::Ui) -> egui::FontId {
    egui::TextStyle::Small.resolve(ui.style())
}

/// The place of a distance on the linear scale, 0 to 1.
fn linear_place(distance: f64, near: f64, far: f64) -> f64 {
    ((distance - near) / (far - near).max(1e-9)).clamp(0.0, 1.0)
}

/// The place of a distance on the logarithmic scale, 0 to 1.
fn logarithmic_place(distance: f64, near: f64, far: f64) -> f64 {
    let near = near.max(1e-6);
    ((distance.max(near) / near).ln() / (far / near).max(1.000_001).ln()).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_end_at_the_ends_and_equal_splits_are_equal_on_their_own_scale() {
        for place in [linear_place, logarithmic_place] {
            assert_eq!((place(1.0, 1.0, 1000.0), place(1000.0, 1.0, 1000.0)), (0.0, 1.0));
        }
        assert!((logarithmic_place(10.0, 1.0, 1000.0) - 1.0 / 3.0).abs() < 1e-9);
        assert!((linear_place(334.0, 1.0, 1000.0) - 1.0 / 3.0).abs() < 1e-9);
    }

    #[test]
    fn the_handle_is_at_lambda() {
        let inner = Rect::from_min_size(Pos2::ZERO, Vec2::new(100.0, 50.0));
        assert_eq!(lambda_at(pos2(3.0, -9.0), inner), 0.0);
        assert_eq!(lambda_at(pos2(3.0, 40.0), inner), 0.8);
        assert_eq!(lambda_at(pos2(3.0, 99.0), inner), 1.0);
    }
}
