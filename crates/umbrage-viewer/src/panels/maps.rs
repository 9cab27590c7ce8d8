//! The window that shows a shadow map as a picture.

use eframe::egui;
use umbrage::ShadowPlan;
use umbrage_render::MapLook;

use crate::action::Action;
use crate::drawing::Drawing;
use crate::view_state::ViewState;

/// Side of a map in its window, pixels.
const SIDE_PX: u32 = 512;

/// Shows the window for the left side; `chosen` is the number of the view whose map is looked at.
pub fn show(
    context: &egui::Context,
    view: &mut ViewState,
    drawing: &mut Drawing,
    chosen: &mut usize,
) -> Option<Action> {
    let names = drawing.plan(0).map(names)?;
    let ViewState { maps, map_look, .. } = view;
    let window = egui::Window::new("Shadow maps")
        .open(maps)
        .default_size([300.0, 380.0])
        .default_pos([288.0, 48.0])
        .show(context, |ui| {
            look(ui, map_look);
            menu(ui, &names, chosen);
            let Some(name) = names.get(*chosen) else {
                ui.weak("no shadow maps are drawn");
                return None;
            };
            match drawing.map(0, *chosen, *map_look, SIDE_PX) {
                Ok(None) => None,
                Ok(Some(id)) => {
                    let side = ui.available_width().min(ui.available_height().max(200.0));
                    let image = egui::Image::new((id, egui::Vec2::splat(side))).alt_text(name);
                    ui.add(image).on_hover_text("Dark is near the light, unless inverted.");
                    None
                }
                Err(why) => Some(Action::Say(why.to_string())),
            }
        });
    window?.inner?
}

/// The maps of a plan in words, view by view.
fn names(plan: &ShadowPlan) -> Vec<String> {
    let several = plan.lights().len() > 1;
    let name = |view: &umbrage::ShadowView| {
        let light = if several { format!("light {}, ", view.light) } else { String::new() };
        format!("{light}map {}: {:.3} m a texel", view.split, view.texel_metres)
    };
    plan.views().iter().map(name).collect()
}

fn menu(ui: &mut egui::Ui, names: &[String], chosen: &mut usize) {
    *chosen = (*chosen).min(names.len().saturating_sub(1));
    let name = names.get(*chosen).map_or("", String::as_str);
    let menu = egui::ComboBox::from_id_salt("map").selected_text(name).show_ui(ui, |ui| {
        for (i, name) in names.iter().enumerate() {
            let item = ui.selectable_label(i == *chosen, name);
            if item.on_hover_text("The light, the split, and the size of its largest texel.").clicked() {
                *chosen = i;
            }
        }
    });
    menu.response.on_hover_text("Which shadow map is shown.");
}

fn look(ui: &mut egui::Ui, look: &mut MapLook) {
    ui.horizontal_wrapped(|ui| {
        ui.checkbox(&mut look.invert, "invert")
            .on_hover_text("Near is light instead of dark, as in Ferko 2010.");
        ui.checkbox(&mut look.stretch, "stretch contrast")
            .on_hover_text("Grey goes from the nearest depth that was drawn to the farthest.");
        ui.checkbox(&mut look.even, "linear depth").on_hover_text(
            "Grey is linear in metres along the light, whatever projection or warp the map has.",
        );
    });
}
