//! What each action does.

use eframe::egui;
use umbrage::Settings;

use super::Viewer;
use crate::action::{Action, Toggle};
use crate::session::Session;
use crate::view_state::PathPosition;
use crate::{edit, export, files, rust_text};

impl Viewer {
    /// Carries out actions, one after the other.
    pub(super) fn act(&mut self, context: &egui::Context, actions: Vec<Action>) {
        for action in actions {
            self.act_once(context, action);
        }
    }

    fn act_once(&mut self, context: &egui::Context, action: Action) {
        match action {
            Action::GoToCamera(number) => self.go_to_camera(number),
            Action::Toggle(part) => self.toggle(part),
            Action::SetSettings(settings) => self.set_settings(*settings),
            Action::ToggleCompare => self.toggle_compare(),
            Action::Load(source) => self.load(context, source),
            Action::ChooseFile => self.tasks.opening = Some(files::choose(context)),
            #[cfg(not(target_arch = "wasm32"))]
            Action::ChooseReport => self.tasks.opening = Some(files::choose_report(context)),
            Action::CopyToml => {
                self.copy(context, |settings| edit::file(settings).map_err(|why| why.to_string()));
            }
            Action::CopyRust => self.copy(context, rust_text::rust),
            Action::SavePicture => self.save_picture(),
            Action::SaveExperiment => self.save_experiment(),
            Action::Say(message) => self.messages.say(message),
            Action::CloseMessage(number) => self.messages.close(number),
            Action::CloseMessages => self.messages.close_all(),
        }
    }

    fn toggle(&mut self, part: Toggle) {
        let Some(view) = self.view() else { return };
        match part {
            Toggle::Orbit => view.flight.motion = view.flight.motion.other(),
            Toggle::Animation => view.playing ^= true,
            Toggle::Path => view.path = view.path.is_none().then(PathPosition::default),
            Toggle::FrozenCamera => {
                view.frozen_camera = view.frozen_camera.is_none().then(|| view.camera());
            }
            Toggle::Truth => view.truth ^= true,
            Toggle::Maps => view.maps ^= true,
            Toggle::Panels => view.panels ^= true,
            Toggle::Help => view.help ^= true,
        }
    }

    fn go_to_camera(&mut self, number: usize) {
        let Some(Session { world, view, .. }) = &mut self.session else { return };
        if let Some(camera) = world.scene.cameras.get(number) {
            view.go_to(&world.scene, camera);
        }
    }

    pub(super) fn set_settings(&mut self, settings: Settings) {
        let Some(session) = &mut self.session else { return };
        self.panels.refused = None;
        if let Err(why) = session.set_settings(settings) {
            self.messages.say(format!("these settings cannot be used here: {why}"));
        }
    }

    fn toggle_compare(&mut self) {
        let Some(session) = &mut self.session else { return };
        self.panels.refused = None;
        if let Err(why) = session.set_compare(!session.view.compare) {
            self.messages.say(format!("there is no room for a second picture: {why}"));
        }
    }

    fn copy(&mut self, context: &egui::Context, text: impl FnOnce(&Settings) -> Result<String, String>) {
        let Some(session) = &self.session else { return };
        match text(session.view.edited_settings()) {
            Ok(text) => context.copy_text(text),
            Err(why) => self.messages.say(format!("the settings were not copied: {why}")),
        }
    }

    fn save_picture(&mut self) {
        match self.session.as_mut().map(|session| session.drawing.request_picture(0)) {
            Some(Ok(coming)) => self.tasks.saving = coming,
            Some(Err(why)) => self.messages.say(format!("the picture was not saved: {why}")),
            None => {}
        }
    }

    fn save_experiment(&mut self) {
        let Some(Session { world, view, .. }) = &self.session else { return };
        match export::save_experiment(world, view) {
            Ok(path) => self.messages.say(format!("saved {path}")),
            Err(why) => self.messages.say(format!("the experiment was not saved: {why}")),
        }
    }
}
