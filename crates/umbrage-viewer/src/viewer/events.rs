//! What each event does.

use std::path::Path;
use std::sync::Arc;

use eframe::egui;
use umbrage_render::Picture;
use umbrage_scene::Imported;

use super::Viewer;
use crate::event::Event;
use crate::load::{self, Source};
use crate::{edit, export, files};

impl Viewer {
    /// Opens a file by its name and bytes: settings or a world.
    pub fn open(&mut self, context: &egui::Context, name: &str, bytes: Vec<u8>) {
        if load::extension(Path::new(name)) != "toml" {
            return self.load(context, Source::Bytes { name: name.to_owned(), bytes });
        }
        match edit::from_file(name, &String::from_utf8_lossy(&bytes)) {
            Ok(settings) => self.set_settings(settings),
            Err(why) => self.messages.say(format!("{why}; the settings stay as they were")),
        }
    }

    /// Takes the settings of the file that is watched, where it has changed.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn read_settings_again(&mut self, context: &egui::Context) {
        let Some(reload) = &mut self.start.reload else { return };
        context.request_repaint_after(crate::reload::PERIOD);
        match reload.poll(std::time::Instant::now()) {
            None => {}
            Some(Ok(settings)) => self.set_settings_of_file(settings),
            Some(Err(why)) => self.messages.say(format!("{why}; the settings stay as they were")),
        }
    }

    /// Gives the side that is edited the settings of the file that has changed, as a step of its own.
    #[cfg(not(target_arch = "wasm32"))]
    fn set_settings_of_file(&mut self, settings: umbrage::Settings) {
        let Some(session) = &mut self.session else { return };
        session.history.close_step();
        if session.view.compare {
            let side = ["left", "right"][session.view.edited];
            self.messages.say(format!("the settings file has changed, and the {side} side has its settings"));
        }
        self.set_settings(settings);
    }

    /// Handles what came since the last frame.
    pub(super) fn poll(&mut self, context: &egui::Context) {
        if let Some(session) = &mut self.session {
            session.count_frame();
            if self.tasks.saving.is_some() {
                session.drawing.poll();
            }
            if let Err(why) = session.advance_casters(context) {
                self.messages.say(format!("nothing is traced, and shadow maps alone answer: {why}"));
            }
        }
        let mut events = self.tasks.poll();
        let errors = self.device_errors.take();
        // A lost device closes the window, which says so.
        if !errors.is_empty() && self.lost().is_none() {
            events.push(Event::DeviceErrors(errors));
        }
        events.extend(files::take_dropped(context, &mut self.tasks));
        for event in events {
            self.handle(context, event);
        }
    }

    fn handle(&mut self, context: &egui::Context, event: Event) {
        match event {
            Event::Loaded(source, imported) => {
                let Imported { scene, warnings } = *imported;
                self.open_world(source, Arc::new(scene));
                self.messages.say_all(warnings);
            }
            Event::Opened(Source::Bytes { name, bytes }) => self.open(context, &name, bytes),
            Event::Opened(source @ (Source::Named(_) | Source::Address(_))) => self.load(context, source),
            Event::PictureRead(name, picture) => {
                let saved = picture.and_then(|picture: Picture| export::save_picture(&name, &picture));
                self.messages.say(match saved {
                    Ok(path) => format!("saved {path}"),
                    Err(why) => format!("the picture was not saved: {why}"),
                });
            }
            Event::DeviceErrors(errors) => {
                if let Some(session) = &mut self.session {
                    session.revert_refused_settings();
                }
                for error in errors {
                    self.messages.say(format!("the graphics device refused: {error}"));
                }
            }
            Event::NotLoaded(source, why) => {
                self.messages.say(why);
                self.go_on_without(context, &source);
            }
            Event::Failed(why) => self.messages.say(why),
        }
    }
}
