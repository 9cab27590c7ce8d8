//! What is under way: a world that is loaded, a file that is chosen, a picture that is read back.

use eframe::egui;
use umbrage_render::ComingPicture;
use umbrage_scene::Imported;

use crate::event::Event;
use crate::load::Source;
use crate::task::Task;

/// A file that was chosen or dropped: a world that is named by its path, or the bytes of a file.
pub type Opening = Task<Result<Option<Source>, String>>;

/// Everything that is under way. Of each kind one at a time; a new one replaces the old one.
#[derive(Debug, Default)]
pub struct Tasks {
    loading: Option<Task<(Source, Result<Imported, String>)>>,
    /// A file that is chosen in a dialog, or read.
    pub opening: Option<Opening>,
    /// A picture that will be saved.
    pub saving: Option<ComingPicture>,
}

impl Tasks {
    /// Starts to load a world.
    pub fn load(&mut self, context: &egui::Context, source: Source) {
        let what = format!("loading {}", source.name());
        let work = move || {
            let loaded = source.load();
            (source, loaded)
        };
        self.loading = Some(Task::run(what, context, work));
    }

    /// Returns whether a world is being loaded.
    pub fn is_loading(&self) -> bool {
        self.loading.is_some()
    }

    /// Returns what is being loaded, in words for people.
    pub fn loading(&self) -> Option<&str> {
        self.loading.as_ref().map(|task| task.what.as_str())
    }

    /// Returns whether the window must repaint until something is done, since nothing else wakes it.
    pub fn need_repaint(&self) -> bool {
        self.loading.is_some() || self.saving.is_some()
    }

    /// Returns what is done since the last call.
    pub fn poll(&mut self) -> Vec<Event> {
        let mut events = Vec::new();
        if let Some(done) = self.loading.as_ref().and_then(Task::poll) {
            self.loading = None;
            events.push(match done.and_then(|(source, loaded)| Ok((source, loaded?))) {
                Ok((source, imported)) => Event::Loaded(source, Box::new(imported)),
                Err(why) => Event::Failed(why),
            });
        }
        if let Some(done) = self.opening.as_ref().and_then(Task::poll) {
            self.opening = None;
            match done.and_then(|opened| opened) {
                Ok(opened) => events.extend(opened.map(Event::Opened)),
                Err(why) => events.push(Event::Failed(why)),
            }
        }
        if let Some(read) = self.saving.as_ref().and_then(ComingPicture::take) {
            self.saving = None;
            events.push(Event::PictureRead(read.map_err(|why| why.to_string())));
        }
        events
    }
}
