//! What is under way: a world that is loaded, a file that is chosen, a picture that is read back.

use eframe::egui;
use umbrage_render::ComingPicture;
use umbrage_scene::Imported;

use crate::event::Event;
#[cfg(target_arch = "wasm32")]
use crate::link::one_line;
use crate::load::Source;
use crate::said::Said;
use crate::task::Task;

/// A file that was chosen or dropped: a world that is named by its path, or the bytes of a file.
pub type Opening = Task<Result<Option<Source>, String>>;

/// Everything that is under way. Of each kind one at a time; a new one replaces the old one.
#[derive(Debug, Default)]
pub struct Tasks {
    loading: Option<Task<(Source, Result<Imported, String>)>>,
    /// How far the loading is.
    said: Said,
    /// A file that is chosen in a dialog, or read.
    pub opening: Option<Opening>,
    /// A picture that will be saved, and the name of its file.
    pub saving: Option<(String, ComingPicture)>,
}

impl Tasks {
    /// Starts to load a world.
    pub fn load(&mut self, context: &egui::Context, source: Source) {
        let what = format!("loading {}", source.name());
        self.said = Said::default();
        let said = self.said.clone();
        self.loading = Some(Task::wait_for(what, context, async move {
            let loaded = load(&source, &said).await;
            (source, loaded)
        }));
    }

    /// Returns whether a world is being loaded.
    pub fn is_loading(&self) -> bool {
        self.loading.is_some()
    }

    /// Returns what is being loaded and how far it is, in words for people.
    pub fn loading(&self) -> Option<String> {
        let what = &self.loading.as_ref()?.what;
        let said = self.said.last();
        Some(if said.is_empty() { what.clone() } else { format!("{what}: {said}") })
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
            events.push(match done {
                Ok((source, Ok(imported))) => Event::Loaded(source, Box::new(imported)),
                Ok((source, Err(why))) => Event::NotLoaded(source, why),
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
        if let Some(read) = self.saving.as_ref().and_then(|(_, coming)| coming.take()) {
            let name = self.saving.take().map(|(name, _)| name).unwrap_or_default();
            events.push(Event::PictureRead(name, read.map_err(|why| why.to_string())));
        }
        events
    }
}

/// Loads a world on the thread that waits for it; in a page it reads files in a worker.
async fn load(source: &Source, said: &Said) -> Result<Imported, String> {
    #[cfg(target_arch = "wasm32")]
    {
        crate::browser::next_moment().await;
        match source {
            Source::Named(_) => {}
            Source::Address(address) => return fetch(address, said).await,
            Source::Bytes { name, bytes } => {
                return crate::browser::jobs::read_world_beside(name, bytes, said).await;
            }
        }
    }
    source.load(&|step| said.say(step.to_string()))
}

/// Fetches the file of a world, and reads it in a worker.
#[cfg(target_arch = "wasm32")]
async fn fetch(address: &str, said: &Said) -> Result<Imported, String> {
    let failed = |why: String| one_line(&format!("`load={address}` is left out: {why}"));
    said.say("waiting for the file");
    let bytes = crate::browser::fetch(address).await.map_err(failed)?;
    let name = crate::load::name_of(address, &bytes).map_err(failed)?;
    crate::browser::jobs::read_world_beside(&name, &bytes, said).await.map_err(failed)
}
