//! How the shadows are made: splits, texels, shadow maps, frusta, and split distances.

use eframe::egui;
use umbrage::{LightKind, Scheme, Settings, ShadowPlan, schema};
use umbrage_render::Mark;

use super::split_plot;
use crate::action::Action;
use crate::drawing::Drawing;
use crate::edit;
use crate::view_state::{PictureMode, ViewState};

const MODES: [(PictureMode, &str, &str); 4] = [
    (PictureMode::Shadows, "shaded", "The world with its shadows."),
    (
        PictureMode::Marked(Mark::Splits),
        "splits tint",
        "Surfaces are tinted by the shadow map (split, cascade) that serves them.",
    ),
    (
        PictureMode::Marked(Mark::Texels),
        "texels",
        "The texels of the shadow maps as a chequer, which fades where they are smaller than a pixel.",
    ),
    (
        PictureMode::Marked(Mark::Extents),
        "pixels per texel",
        "How many pixels a texel spans on screen, m of Lloyd et al. 2006: white for one, orange for more (undersampled), blue for less (oversampled), full from eight times on.",
    ),
];

/// Shows the panel.
pub fn show(ui: &mut egui::Ui, view: &mut ViewState, drawing: &Drawing) -> Option<Action> {
    ui.heading("Method");
    ui.horizontal_wrapped(|ui| {
        for (mode, name, help) in MODES {
            ui.radio_value(&mut view.mode, mode, name).on_hover_text(help);
        }
    });
    ui.checkbox(&mut view.maps, "shadow maps")
        .on_hover_text("Opens a window with the shadow maps of the left side (M).");
    let mut frozen = view.frozen_camera.is_some();
    let help = "Shadows stay planned for the camera as it is now; fly on, and look at them from outside (F).";
    if ui.checkbox(&mut frozen, "freeze the planned camera").on_hover_text(help).changed() {
        view.frozen_camera = frozen.then(|| view.camera());
    }
    lines(ui, view);
    let side = view.edited.min(drawing.sides() - 1);
    let plan = drawing.plan(side).filter(|plan| !plan.views().is_empty())?;
    let lambda = split_distances(ui, plan, &view.settings[side]);
    load(ui, plan, drawing, side);
    lambda
}

fn lines(ui: &mut egui::Ui, view: &mut ViewState) {
    ui.horizontal_wrapped(|ui| {
        ui.checkbox(&mut view.lines.slices, "frusta").on_hover_text(
            "The slices of the planned camera's frustum that the first light's maps serve, as lines.",
        );
        ui.checkbox(&mut view.lines.maps, "map volumes")
            .on_hover_text("The volume that each map of the first light covers, as lines.");
        ui.checkbox(&mut view.lines.casters, "caster volumes").on_hover_text(
            "The volume that holds every caster of each map, as lines. Freeze the camera to see them from outside.",
        );
    });
}

/// The plot of the split distances, and λ.
fn split_distances(ui: &mut egui::Ui, plan: &ShadowPlan, settings: &Settings) -> Option<Action> {
    // The view is split for suns; punctual lights have depths of their own.
    let has_sun = plan.lights().iter().any(|light| matches!(light.kind(), LightKind::Directional { .. }));
    let lambda = (settings.scheme == Scheme::Practical).then_some(settings.lambda);
    let chosen = has_sun.then(|| split_plot::show(ui, plan.splits(), lambda)).flatten()?;
    let changed = edit::with(settings, schema::key("lambda")?, Some(f64::from(chosen).into())).ok()?;
    Some(Action::SetSettings(Box::new(changed)))
}

/// What the shadow maps take, and what is drawn into them.
fn load(ui: &mut egui::Ui, plan: &ShadowPlan, drawing: &Drawing, side: usize) {
    let texels: u64 = plan.views().iter().map(|view| u64::from(view.tile.size).pow(2)).sum();
    let triangles: u64 = drawing.loads(side).iter().map(|load| load.triangles).sum();
    let mebibytes = |bytes: u64| bytes as f64 / f64::from(1 << 20);
    let bytes = mebibytes(drawing.bytes(side));
    ui.label(format!("{} maps, {:.1} M texels, {bytes:.1} MiB", plan.views().len(), texels as f64 / 1e6))
        .on_hover_text("Texels of depth; and the memory of all textures that lookups read or are made from.");
    if drawing.occluder_bytes(side) > 0 {
        ui.label(format!("{:.1} MiB of casters for rays", mebibytes(drawing.occluder_bytes(side))))
            .on_hover_text(
                "The triangles that rays go through, and the boxes around them; both sides share them.",
            );
    }
    ui.label(format!("{triangles} triangles cast"))
        .on_hover_text("Triangles drawn into all shadow maps of the last picture.");
}
