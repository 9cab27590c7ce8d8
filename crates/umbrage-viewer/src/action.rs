//! What people ask the program for: by a key, a menu or a panel.

use umbrage::Settings;

use crate::bookmarks::Bookmark;
use crate::load::Source;

/// One request. Keys and panels return them, and [`crate::Viewer`] carries them out.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Moves to one of the world's cameras, counted from 0.
    GoToCamera(usize),
    /// Switches a part of the view's state.
    Toggle(Toggle),
    /// Shows two sides, or one.
    ToggleCompare,
    /// Draws the edited side with these settings.
    SetSettings(Box<Settings>),
    /// Goes back to the settings before the last change.
    Undo,
    /// Goes forth again to the settings that were undone.
    Redo,
    /// Saves the camera under a name.
    SaveBookmark(String),
    /// Moves to a saved camera.
    GoToBookmark(Bookmark),
    /// Deletes a saved camera.
    DeleteBookmark(Bookmark),
    /// Loads a world and shows it.
    Load(Source),
    /// Asks for a file of a world or of settings, and opens it.
    ChooseFile,
    /// Asks for a page that `umbrage report` has made, and opens it in the browser.
    #[cfg(not(target_arch = "wasm32"))]
    ChooseReport,
    /// Shows the lesson of this number, from 0.
    Learn(usize),
    /// Copies a link to what is shown.
    CopyLink,
    /// Copies the edited settings as TOML.
    CopyToml,
    /// Copies the edited settings as Rust.
    CopyRust,
    /// Saves the left side's picture.
    SavePicture(SavedPicture),
    /// Saves an experiment of this one picture.
    SaveExperiment,
    /// Shows a message.
    Say(String),
    /// Closes the message of this number.
    CloseMessage(usize),
    /// Closes all messages.
    CloseMessages,
}

/// A part of the view's state that has two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Toggle {
    /// Flying, or orbiting.
    Orbit,
    /// Whether time goes on.
    Animation,
    /// Whether the camera follows the world's path.
    Path,
    /// Whether shadows stay planned for the camera as it is now.
    FrozenCamera,
    /// Whether the picture is compared with ground truth.
    Truth,
    /// Whether the window of shadow maps is open.
    Maps,
    /// Whether the panels are shown.
    Panels,
    /// Whether the list of keys is open.
    Help,
    /// Whether a click asks why a pixel's shadow is as it is.
    Ask,
}

/// How a picture is saved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SavedPicture {
    /// The file's name without its extension.
    pub name: String,
    /// Width and height, pixels; as large as it is shown where absent.
    pub size: Option<[u32; 2]>,
}
