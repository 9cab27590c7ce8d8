//! Which panel stands where, and which windows lie over the picture.
//!
//! A panel takes what it shows. Widgets change the [`ViewState`](crate::view_state::ViewState) that they are bound to;
//! everything else that people ask for is returned as an `Action`.

pub mod settings;

pub(crate) mod light_handles;
pub(crate) mod messages;
pub(crate) mod picture;

mod animation;
mod lesson;
mod maps;
mod method;
mod save_picture;
mod split_plot;
mod top_bar;
mod truth;
mod why;
mod world;

use eframe::egui;

use crate::action::Action;
use crate::bookmarks::Bookmarks;
use crate::history::History;
use crate::input;
use crate::session::Session;

/// How wide the panel of the world and of its shadows is at first, points.
const SCENE_WIDTH: f32 = 264.0;
/// How wide the panel of settings is at first, points.
const SETTINGS_WIDTH: f32 = 316.0;
/// How wide the picture must be for panels to stand beside it, points.
const PICTURE_WIDTH: f32 = 240.0;

/// What the panels keep from frame to frame.
#[derive(Clone, Debug, Default)]
pub(crate) struct PanelState {
    /// Settings that were refused.
    pub refused: Option<settings::Refused>,
    /// The shadow map that is looked at, by the number of its view.
    pub map: usize,
    /// The path of a world as it is typed.
    pub path: String,
    /// The number of the lesson that is shown, from 0.
    pub lesson: Option<usize>,
    /// The name of a bookmark as it is typed.
    pub bookmark: String,
    /// The picture that is saved next, where its window is open.
    pub picture: Option<save_picture::Form>,
}

/// Shows the panels beside the picture; below it where there is no room for that, as on a phone.
pub(crate) fn show(
    ui: &mut egui::Ui,
    mut session: Option<&mut Session>,
    state: &mut PanelState,
    bookmarks: &Bookmarks,
    adapter: &str,
) -> Vec<Action> {
    // The window is cleared to their colour already, and a software adapter is spared to fill them.
    let frame = egui::Frame::side_top_panel(ui.style()).fill(egui::Color32::TRANSPARENT);
    let bar = egui::Panel::top("bar").frame(frame);
    let mut actions =
        bar.show(ui, |ui| top_bar::show(ui, session.as_deref_mut(), state, bookmarks, adapter)).inner;
    let scrolled = || egui::ScrollArea::vertical().auto_shrink(false);
    if ui.available_width() < SCENE_WIDTH + PICTURE_WIDTH + SETTINGS_WIDTH {
        let height = 0.45 * ui.available_height();
        let panel = egui::Panel::bottom("all panels").resizable(true).default_size(height).frame(frame);
        panel.show(ui, |ui| {
            scrolled().show(ui, |ui| {
                actions.extend(scene_panels(ui, session.as_deref_mut()));
                ui.separator();
                actions.extend(settings_panel(ui, session, state));
            });
        });
        return actions;
    }
    egui::Panel::left("scene").default_size(SCENE_WIDTH).frame(frame).show(ui, |ui| {
        scrolled().show(ui, |ui| actions.extend(scene_panels(ui, session.as_deref_mut())));
    });
    egui::Panel::right("settings").default_size(SETTINGS_WIDTH).frame(frame).show(ui, |ui| {
        scrolled().show(ui, |ui| actions.extend(settings_panel(ui, session, state)));
    });
    actions
}

fn scene_panels(ui: &mut egui::Ui, session: Option<&mut Session>) -> Vec<Action> {
    let Some(Session { world, view, drawing, truth, timings, .. }) = session else {
        ui.heading("World");
        ui.weak("nothing is loaded yet");
        return Vec::new();
    };
    let compare = world::show(ui, view, &world.scene);
    ui.separator();
    let lambda = method::show(ui, view, drawing);
    ui.separator();
    truth::show(ui, view, truth);
    ui.separator();
    timings.show(ui);
    compare.into_iter().chain(lambda).collect()
}

fn settings_panel(
    ui: &mut egui::Ui,
    session: Option<&mut Session>,
    state: &mut PanelState,
) -> Option<Action> {
    let Session { view, history, .. } = session?;
    let stepped = steps(ui, history);
    if view.compare {
        ui.horizontal(|ui| {
            for (side, name) in ["left", "right"].into_iter().enumerate() {
                let value = ui.selectable_value(&mut view.edited, side, name);
                if value.on_hover_text(format!("Edit the {name} side.")).changed() {
                    state.refused = None;
                }
            }
        });
    }
    let changed = settings::show(ui, view.edited_settings(), &mut state.refused);
    changed.map(|changed| Action::SetSettings(Box::new(changed))).or(stepped)
}

/// The buttons that go back and forth among settings.
fn steps(ui: &mut egui::Ui, history: &History) -> Option<Action> {
    let row = ui.horizontal(|ui| {
        let undo = ui.add_enabled(history.can_undo(), egui::Button::new("undo"));
        let redo = ui.add_enabled(history.can_redo(), egui::Button::new("redo"));
        let undo = undo.on_hover_text("Undoes the last change of settings (Ctrl + Z).").clicked();
        let redo = redo.on_hover_text("Redoes what was undone (Ctrl + Shift + Z).").clicked();
        undo.then_some(Action::Undo).or(redo.then_some(Action::Redo))
    });
    row.inner
}

/// Shows the windows that lie over the picture.
pub(crate) fn windows(context: &egui::Context, session: &mut Session, state: &mut PanelState) -> Vec<Action> {
    help(context, &mut session.view.help);
    if let Some(pick) = session.pick.take() {
        let names = session.view.lights(&session.world.scene).into_iter().map(|light| light.name);
        session.pick = why::show(context, pick, &names.collect::<Vec<_>>());
    }
    let most = session.drawing.max_side_px();
    let mut actions: Vec<Action> =
        save_picture::show(context, &mut state.picture, most).into_iter().collect();
    actions.extend(lesson::show(context, &mut state.lesson));
    if session.view.maps {
        let Session { view, drawing, .. } = session;
        actions.extend(maps::show(context, view, drawing, &mut state.map));
    }
    actions
}

fn help(context: &egui::Context, is_open: &mut bool) {
    egui::Window::new("Keys").open(is_open).resizable(false).show(context, |ui| {
        egui::Grid::new("keys").striped(true).show(ui, |ui| {
            for (key, what) in input::KEYS {
                ui.strong(*key);
                ui.label(*what);
                ui.end_row();
            }
        });
    });
}
