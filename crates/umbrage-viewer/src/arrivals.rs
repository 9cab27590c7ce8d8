//! What comes to the window while it runs: worlds that are loaded, files that are dropped or picked, pictures to save, and
//! what the device refuses.

use std::sync::Arc;

use eframe::egui;
use umbrage_scene::Imported;

use crate::app::Viewer;
use crate::load::{self, Source};
use crate::task::Task;
use crate::{edit, take};

impl Viewer {
    /// Reads a file that was dropped: settings, or a world.
    pub fn open(&mut self, context: &egui::Context, name: &str, bytes: Vec<u8>) {
        if load::extension(std::path::Path::new(name)) == "toml" {
            let text = String::from_utf8_lossy(&bytes).into_owned();
            match edit::from_file(&text) {
                Ok(settings) => self.set_settings(settings),
                Err(why) => self.say(format!("{why}, in {name}; the settings stay as they were")),
            }
        } else {
            self.load(context, Source::Bytes { name: name.to_owned(), bytes });
        }
    }

    /// Starts to save the picture of the left side.
    pub(crate) fn save_picture(&mut self) {
        match self.stage.as_mut().map(|stage| stage.picture_to_save(0)) {
            Some(Ok(coming)) => self.saving = coming,
            Some(Err(why)) => self.say(why.to_string()),
            None => {}
        }
    }

    /// What came since the last frame: worlds, files, pictures to save, errors.
    pub(crate) fn poll(&mut self, context: &egui::Context) {
        if let Some(Some(done)) = self.loading.as_ref().map(Task::poll) {
            self.loading = None;
            match done.and_then(|(source, loaded)| Ok((source, loaded?))) {
                Ok((source, Imported { scene, warnings })) => {
                    self.enter(source, Arc::new(scene));
                    warnings.into_iter().for_each(|warning| self.say(warning));
                }
                Err(why) => self.say(why),
            }
        }
        if let Some(Some(picked)) = self.opening.as_ref().map(Task::poll) {
            self.opening = None;
            match picked.and_then(|picked| picked) {
                Ok(Some(Source::Bytes { name, bytes })) => self.open(context, &name, bytes),
                Ok(Some(source)) => self.load(context, source),
                Ok(None) => {}
                Err(why) => self.say(why),
            }
        }
        self.poll_saving();
        self.poll_errors();
        self.take_dropped(context);
    }

    fn poll_saving(&mut self) {
        let Some(coming) = &self.saving else { return };
        if let Some(stage) = &self.stage {
            stage.poll();
        }
        if let Some(picture) = coming.take() {
            self.saving = None;
            let saved = picture.map_err(|why| why.to_string()).and_then(|picture| take::png(&picture));
            match saved.and_then(|bytes| take::save("umbrage", "png", &bytes)) {
                Ok(path) => self.say(format!("saved {path}")),
                Err(why) => self.say(format!("the picture was not saved: {why}")),
            }
        }
    }

    /// What the device refused after it had been asked: the settings before come back.
    fn poll_errors(&mut self) {
        let errors = self.trouble.errors();
        if let Some((_, frames)) = &mut self.good {
            *frames += 1;
        }
        if errors.is_empty() || self.lost().is_some() {
            return;
        }
        let before = self.good.take_if(|(_, frames)| *frames < 60);
        if let (Some((before, _)), Some(choices), Some(stage)) = (before, &mut self.choices, &mut self.stage)
        {
            choices.settings = before;
            self.version += 1;
            // They were in force before.
            let _ = stage.set_settings(choices.sides());
        }
        errors.into_iter().for_each(|error| self.say(format!("the graphics device refused: {error}")));
    }

    fn take_dropped(&mut self, context: &egui::Context) {
        let mut dropped = context.input(|input| input.raw.dropped_files.clone());
        // Of several files the world is meant; what it refers to is found beside it.
        if let Some(world) = dropped.iter().position(|file| load::is_world(file.path())) {
            dropped = vec![dropped.swap_remove(world)];
        }
        for file in dropped {
            #[cfg(not(target_arch = "wasm32"))]
            self.take_file(context, &*file);
            #[cfg(target_arch = "wasm32")]
            {
                self.opening = Some(crate::web::read(context, file));
            }
        }
    }

    /// Worlds are loaded from where they lie, so that what they refer to is found.
    #[cfg(not(target_arch = "wasm32"))]
    fn take_file(&mut self, context: &egui::Context, file: &dyn egui::DroppedFile) {
        let path = file.path();
        let name = path.to_string_lossy().into_owned();
        if path.is_file() && load::extension(path) != "toml" {
            return self.load(context, load::of_path(path.to_owned()));
        }
        let size = path.metadata().map_or(0, |about| about.len());
        let read = || file.bytes().map_err(|why| format!("{why}: {name}"));
        match load::check_size(&name, size).and_then(|()| read()) {
            Ok(bytes) => self.open(context, &name, bytes),
            Err(why) => self.say(why),
        }
    }
}
