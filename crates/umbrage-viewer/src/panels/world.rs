//! The world as it is seen: time of day, the camera's motion, and what is drawn; `animation.rs` has what moves.

use eframe::egui;
use umbrage_render::FrameLight;
use umbrage_scene::Scene;

use crate::action::Action;
use crate::sky;
use crate::view_state::{PathPosition, PictureMode, ViewState, is_sun};

/// Shows the panel.
pub fn show(ui: &mut egui::Ui, view: &mut ViewState, scene: &Scene) -> Option<Action> {
    ui.heading("World");
    if scene.lights.iter().any(is_sun) {
        time_of_day(ui, &mut view.hour);
    } else {
        ui.weak("this world has punctual lights and no sun");
    }
    lights(ui, view);
    super::animation::show(ui, view, &scene.rig);
    camera(ui, view);
    brightness(ui, view, scene);
    let msaa = ui.checkbox(&mut view.multisampled, "multisampling");
    msaa.on_hover_text(
        "Four samples a pixel (MSAA), which cost a software adapter four times. Ground truth is compared at one.",
    );
    let mut shadows = view.mode != PictureMode::Unshadowed;
    let box_ = ui.checkbox(&mut shadows, "shadows");
    if box_
        .on_hover_text("Off, no shadow map is drawn or read: the difference in time is their cost.")
        .changed()
    {
        view.mode = if shadows { PictureMode::Shadows } else { PictureMode::Unshadowed };
    }
    let mut compare = view.compare;
    let box_ = ui.checkbox(&mut compare, "compare two settings");
    box_.on_hover_text("Side by side, with a divider to drag (C).").changed().then_some(Action::ToggleCompare)
}

/// Whether lights have handles, and the way back to where they were.
fn lights(ui: &mut egui::Ui, view: &mut ViewState) {
    ui.horizontal(|ui| {
        ui.checkbox(&mut view.handles, "move lights").on_hover_text(
            "Each light has a handle in the picture: drag a point light or a spot to another place, and a sun or a spot to another direction.",
        );
        let back = ui.add_enabled(!view.moved_lights.is_empty(), egui::Button::new("reset lights"));
        if back.on_hover_text("All lights are where the world has them again.").clicked() {
            view.moved_lights.clear();
        }
    });
}

/// Exposure and haze.
fn brightness(ui: &mut egui::Ui, view: &mut ViewState, scene: &Scene) {
    let stops = egui::Slider::new(&mut view.exposure.stops, -8.0..=8.0)
        .text("exposure")
        .clamping(egui::SliderClamping::Never)
        .suffix(" stops")
        .max_decimals(1);
    ui.add(stops)
        .on_hover_text("How much brighter or darker the picture is; each stop doubles or halves its light.");
    let mut automatic = view.exposure.lux.is_none();
    let box_ = ui.checkbox(&mut automatic, "automatic exposure");
    let help =
        "Stops count from what the world's own lights ask for. Off, they count from a light that stays.";
    if box_.on_hover_text(help).changed() {
        view.exposure.lux = (!automatic).then(|| metered(view, scene));
    }
    if let Some(lux) = &mut view.exposure.lux {
        let slider = egui::Slider::new(lux, 1e-3..=1e6)
            .logarithmic(true)
            .clamping(egui::SliderClamping::Never)
            .text("exposed for")
            .suffix(" lx");
        ui.add(slider).on_hover_text("A white surface in this light is white on the screen, lux.");
    }
    ui.checkbox(&mut view.haze, "haze").on_hover_text(
        "Takes colour from what is far, in worlds with a sun; thicker the smaller the world is.",
    );
}

/// What the world's lights ask for, lux.
fn metered(view: &ViewState, scene: &Scene) -> f32 {
    let (lights, pose) = (view.lights(scene), view.pose(scene));
    let lights: Vec<_> = lights.iter().filter_map(|light| FrameLight::at(light, &pose).ok()).collect();
    umbrage_render::metered_lux(scene, &lights)
}

fn time_of_day(ui: &mut egui::Ui, hour: &mut Option<f32>) {
    let mut own = hour.is_none();
    let box_ = ui.checkbox(&mut own, "the world's own sun");
    if box_.on_hover_text("Off, the time of day places the sun.").changed() {
        *hour = if own { None } else { Some(9.0) };
    }
    let mut shown = hour.unwrap_or(12.0);
    let slider = egui::Slider::new(&mut shown, sky::DAY[0]..=sky::DAY[1])
        .text("time of day")
        .suffix(" h")
        .max_decimals(2);
    let help = "Places the sun as at 50° north in the middle of May: Meeus 1998, eq. 13.6.";
    if ui.add(slider).on_hover_text(help).changed() {
        *hour = Some(shown);
    }
}

fn camera(ui: &mut egui::Ui, view: &mut ViewState) {
    let speed = egui::Slider::new(&mut view.flight.speed, 0.1..=500.0)
        .logarithmic(true)
        .text("speed")
        .clamping(egui::SliderClamping::Edits)
        .suffix(" m/s");
    ui.add(speed).on_hover_text("How fast keys move the camera; Shift is four times as fast.");
    let Some(PathPosition { along, held }) = &mut view.path else { return };
    let mut place = *along;
    let slider = egui::Slider::new(&mut place, 0.0..=1.0).text("along the path").max_decimals(3);
    let help = "The camera's position on the world's path, 0 to 1. Dragging holds it there.";
    let slider = ui.add(slider).on_hover_text(help);
    // It also rounds what flies by.
    if slider.dragged() || slider.has_focus() {
        (*along, *held) = (place, true);
    }
    ui.checkbox(held, "hold").on_hover_text("The camera stays on the path where it is.");
}
