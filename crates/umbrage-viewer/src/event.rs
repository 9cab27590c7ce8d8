//! What comes to the program while it runs, beside input.

use umbrage_render::Picture;
use umbrage_scene::Imported;

use crate::load::Source;

/// One event.
#[derive(Debug)]
pub enum Event {
    /// A world was loaded.
    Loaded(Source, Box<Imported>),
    /// A world could not be loaded.
    NotLoaded(Source, String),
    /// A file was chosen or dropped: a world to load, or the bytes of a file.
    Opened(Source),
    /// A picture that is to be saved under a name was read back, or could not be.
    PictureRead(String, Result<Picture, String>),
    /// The device reported errors.
    DeviceErrors(Vec<String>),
    /// A task failed.
    Failed(String),
}
