//! How the shadows are made: splits, texels, maps, frusta, and where the view is cut.

use eframe::egui;
use umbrage::{LightKind, Scheme, schema};
use umbrage_render::{MapLook, Mark};

use crate::app::Viewer;
use crate::choices::Shown;
use crate::{edit, split_plot};

/// Side of a map in its window, pixels.
const MAP_SIDE: u32 = 512;

const MARKS: [(Shown, &str, &str); 4] = [
    (Shown::Shadows, "as it is", "The world with its shadows."),
    (Shown::Marked(Mark::Splits), "splits tint", "Tinted by the map that serves each place."),
    (
        Shown::Marked(Mark::Texels),
        "texels",
        "The texels of the maps as a chequer; where they are smaller than a pixel it fades.",
    ),
    (
        Shown::Marked(Mark::Extents),
        "pixels per texel",
        "How far a texel reaches on screen, m of Lloyd et al. 2006: white for one pixel, orange for more (too coarse), blue for less (wasted), full from eight times on.",
    ),
];

impl Viewer {
    pub(crate) fn method_panel(&mut self, ui: &mut egui::Ui) {
        ui.heading("Method");
        let Some(choices) = &mut self.choices else { return };
        ui.horizontal_wrapped(|ui| {
            for (shown, name, help) in MARKS {
                ui.radio_value(&mut choices.shown, shown, name).on_hover_text(help);
            }
        });
        ui.checkbox(&mut choices.maps, "shadow maps")
            .on_hover_text("The maps of the left side as pictures (M).");
        let mut frozen = choices.frozen.is_some();
        let freeze = ui.checkbox(&mut frozen, "freeze the planned camera");
        if freeze.on_hover_text("Shadows stay planned for the camera as it is now; fly on, and look at them from outside (F).").changed() {
            choices.frozen = frozen.then(|| choices.camera());
        }
        ui.horizontal_wrapped(|ui| {
            let lines = &mut choices.lines;
            ui.checkbox(&mut lines.slices, "frusta").on_hover_text(
                "The slices of the planned camera's view that the first light's maps serve, as lines.",
            );
            ui.checkbox(&mut lines.maps, "map bodies")
                .on_hover_text("What each map of the first light covers, as lines.");
            ui.checkbox(&mut lines.casters, "caster volumes").on_hover_text(
                "What can cast into each map, as lines. Freeze the camera to see them from outside.",
            );
        });
        self.cuts(ui);
    }

    /// Where the view is cut, and λ.
    fn cuts(&mut self, ui: &mut egui::Ui) {
        let (Some(choices), Some(stage)) = (&self.choices, &self.stage) else { return };
        let edited = choices.edited.min(stage.sides() - 1);
        let settings = &choices.settings[edited];
        let Some(plan) = stage.plan(edited).filter(|plan| !plan.views().is_empty()) else { return };
        let is_cut_by_lambda = settings.scheme == Scheme::Practical;
        // What is cut is the view of suns; lamps have depths of their own.
        let has_sun = plan.lights().iter().any(|light| matches!(light.kind(), LightKind::Directional { .. }));
        let lambda = has_sun
            .then(|| split_plot::show(ui, plan.splits(), is_cut_by_lambda.then_some(settings.lambda)))
            .flatten();
        let texels: u64 = plan.views().iter().map(|view| u64::from(view.tile.size).pow(2)).sum();
        let triangles: u64 = stage.loads(edited).iter().map(|load| load.triangles).sum();
        let bytes = stage.bytes(edited) as f64 / f64::from(1 << 20);
        ui.label(format!("{} maps, {:.1} M texels, {bytes:.1} MiB", plan.views().len(), texels as f64 / 1e6))
            .on_hover_text("Everything that lookups read and that it is made from.");
        ui.label(format!("{triangles} triangles cast"))
            .on_hover_text("Drawn into all maps of the last picture.");
        let with = |value: f32| {
            let key = schema::key("lambda")?;
            edit::with(settings, key, Some(f64::from(value).into())).ok()
        };
        if let Some(changed) = lambda.and_then(with) {
            self.set_settings(changed);
        }
    }

    /// The maps as pictures.
    pub(crate) fn map_window(&mut self, context: &egui::Context) {
        let (Some(choices), Some(stage)) = (&mut self.choices, &mut self.stage) else { return };
        let Some(plan) = stage.plan(0) else { return };
        let views: Vec<(usize, String)> = plan
            .views()
            .iter()
            .enumerate()
            .map(|(i, view)| {
                let light =
                    if plan.lights().len() > 1 { format!("light {}, ", view.light) } else { String::new() };
                (i, format!("{light}map {}: {:.3} m a texel", view.split, view.texel_metres))
            })
            .collect();
        let mut failed = None;
        egui::Window::new("Shadow maps")
            .open(&mut choices.maps)
            .default_size([300.0, 380.0])
            .default_pos([288.0, 48.0])
            .show(context, |ui| {
                look(ui, &mut choices.look);
                let chosen = self.shown_map.min(views.len().saturating_sub(1));
                let name = views.get(chosen).map_or("", |(_, name)| name.as_str());
                let menu = egui::ComboBox::from_id_salt("map").selected_text(name).show_ui(ui, |ui| {
                    for (i, name) in &views {
                        let item = ui.selectable_label(*i == chosen, name);
                        if item.on_hover_text("The light and the split, and its largest texel.").clicked() {
                            self.shown_map = *i;
                        }
                    }
                });
                menu.response.on_hover_text("Which map.");
                if views.is_empty() {
                    ui.weak("no maps are drawn");
                    return;
                }
                match stage.map(0, chosen, choices.look, MAP_SIDE) {
                    Ok(id) => {
                        let side = ui.available_width().min(ui.available_height().max(200.0));
                        let image = egui::Image::new((id, egui::Vec2::splat(side))).alt_text(name);
                        ui.add(image).on_hover_text("Dark is near the light, unless inverted.");
                    }
                    Err(why) => failed = Some(why.to_string()),
                }
            });
        if let Some(why) = failed {
            self.say(why);
        }
    }
}

fn look(ui: &mut egui::Ui, look: &mut MapLook) {
    ui.horizontal_wrapped(|ui| {
        ui.checkbox(&mut look.invert, "invert")
            .on_hover_text("Near light instead of near dark: the look of Ferko 2010.");
        ui.checkbox(&mut look.stretch, "stretch")
            .on_hover_text("Grey from the nearest depth that was drawn to the farthest.");
        ui.checkbox(&mut look.even, "even in metres")
            .on_hover_text("Linear along the light, whatever a lamp or a warp makes of depth.");
    });
}
