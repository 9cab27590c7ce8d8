//! Files that people choose in a dialog or drop on the window.

use eframe::egui;

use crate::event::Event;
use crate::load::{self, Source};
use crate::task::Task;
use crate::tasks::{Opening, Tasks};

/// Asks for a file of a world or of settings; the task gives nothing where none is chosen.
pub fn choose(context: &egui::Context) -> Opening {
    let kinds = [&load::WORLDS[..], &["toml"]].concat();
    let dialog = rfd::AsyncFileDialog::new().add_filter("worlds and settings", &kinds);
    Task::wait_for("choosing a file", context, async move {
        let Some(file) = dialog.pick_file().await else { return Ok(None) };
        let name = file.file_name();
        #[cfg(not(target_arch = "wasm32"))]
        if load::extension(file.path()) != "toml" {
            return Ok(Some(load::of_path(file.path().to_owned())));
        }
        #[cfg(not(target_arch = "wasm32"))]
        let size = file.path().metadata().map_or(0, |about| about.len());
        #[cfg(target_arch = "wasm32")]
        let size = file.inner().size() as u64;
        load::check_size(&name, size)?;
        Ok(Some(Source::Bytes { name, bytes: file.read().await }))
    })
}

/// Asks for a page that `umbrage report` has made, and opens it in the browser; the task gives nothing but an error.
#[cfg(not(target_arch = "wasm32"))]
pub fn choose_report(context: &egui::Context) -> Opening {
    let dialog = rfd::AsyncFileDialog::new().add_filter("pages", &["html"]);
    Task::wait_for("choosing a page", context, async move {
        let Some(file) = dialog.pick_file().await else { return Ok(None) };
        let path = file.path();
        open::that(path).map(|()| None).map_err(|why| format!("cannot open {}: {why}", path.display()))
    })
}

/// Opens the files that were dropped since the last frame. Of several the world is meant: what it refers to lies beside it.
pub fn take_dropped(context: &egui::Context, tasks: &mut Tasks) -> Vec<Event> {
    let mut dropped = context.input(|input| input.raw.dropped_files.clone());
    if let Some(world) = dropped.iter().position(|file| load::is_world(file.path())) {
        dropped = vec![dropped.swap_remove(world)];
    }
    take_all(context, tasks, dropped)
}

#[cfg(not(target_arch = "wasm32"))]
fn take_all(_context: &egui::Context, _tasks: &mut Tasks, files: Vec<egui::DroppedFileHandle>) -> Vec<Event> {
    let opened = |file: egui::DroppedFileHandle| read(&*file).map_or_else(Event::Failed, Event::Opened);
    files.into_iter().map(opened).collect()
}

#[cfg(target_arch = "wasm32")]
fn take_all(context: &egui::Context, tasks: &mut Tasks, files: Vec<egui::DroppedFileHandle>) -> Vec<Event> {
    for file in files {
        tasks.opening = Some(read(context, file));
    }
    Vec::new()
}

/// A file as what it is opened as. Worlds are loaded from where they lie, so that what they refer to is found.
#[cfg(not(target_arch = "wasm32"))]
fn read(file: &dyn egui::DroppedFile) -> Result<Source, String> {
    let path = file.path();
    if path.is_file() && load::extension(path) != "toml" {
        return Ok(load::of_path(path.to_owned()));
    }
    let name = path.to_string_lossy().into_owned();
    load::check_size(&name, path.metadata().map_or(0, |about| about.len()))?;
    let bytes = file.bytes().map_err(|why| format!("{why}: {name}"))?;
    Ok(Source::Bytes { name, bytes })
}

/// Reads a file that was dropped on the page. It is sent nowhere.
#[cfg(target_arch = "wasm32")]
fn read(context: &egui::Context, file: egui::DroppedFileHandle) -> Opening {
    Task::wait_for("reading the file", context, async move {
        let name = file.path().to_string_lossy().into_owned();
        let size = file.web_file().map_or(0.0, |file| file.size());
        load::check_size(&name, size as u64)?;
        let bytes = file.bytes_async().await.map_err(|why| format!("{why}: {name}"))?;
        Ok(Some(Source::Bytes { name, bytes }))
    })
}
