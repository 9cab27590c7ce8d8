//! Why there is no result.

use std::path::{Path, PathBuf};

use umbrage_render::RenderError;
use umbrage_rivals::RivalError;
use umbrage_scene::SceneError;

use crate::merge::MergeError;
use crate::settings::WrongSettings;

/// An error between an experiment and its page.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LabError {
    /// The experiment cannot be run as it is written.
    #[error("line {line}, `{key}`: {wrong}, in {}", path.display())]
    Experiment {
        /// The line of the file, from 1.
        line: usize,
        /// The key at fault; dots part levels.
        key: String,
        /// What is wrong with the value, and what would be right.
        wrong: String,
        /// The file.
        path: PathBuf,
    },
    /// A file cannot be read or written.
    #[error("cannot {action} {}", path.display())]
    File {
        /// "read", "write" or "decode".
        action: &'static str,
        /// The path of the file.
        path: PathBuf,
        /// The reason that the system gives.
        source: std::io::Error,
    },
    /// No built-in world and no file has that name.
    #[error("no built-in world is called `{name}`, and there is no such file; there are {}", worlds())]
    World {
        /// The name or path that was asked for.
        name: String,
    },
    /// A setting does not exist, or its value is wrong.
    #[error(transparent)]
    Settings(#[from] WrongSettings),
    /// A world cannot be loaded.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A world lacks something that every measurement needs.
    #[error("the world {world} has no {what}")]
    Missing {
        /// What the world lacks.
        what: String,
        /// The world's name.
        world: String,
    },
    /// A picture cannot be drawn.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// A family of shadows cannot be used.
    #[error(transparent)]
    Rival(#[from] RivalError),
    /// Pictures of one view are of different sizes.
    #[error("{name} is {} x {} pixels, need {} x {}", got.0, got.1, wanted.0, wanted.1)]
    Sizes {
        /// The name of the picture.
        name: &'static str,
        /// The size of the view, or of `lit.png` beside it, in pixels.
        wanted: (u32, u32),
        /// The size of the picture, in pixels.
        got: (u32, u32),
    },
    /// A picture cannot be encoded.
    #[error("a picture cannot be encoded: {0}")]
    Encode(#[from] image::ImageError),
    /// A result cannot be written as JSON.
    #[error("a result cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// A plot cannot be drawn.
    #[error("a plot cannot be drawn: {0}")]
    Plot(String),
    /// Stores do not make an experiment whole.
    #[error(transparent)]
    Merge(#[from] MergeError),
    /// Whoever asked for runs asked to stop.
    #[error("stopped after {done} of {of} runs, which are kept")]
    Stopped {
        /// The number of runs that are done.
        done: usize,
        /// The number of all runs.
        of: usize,
    },
}

impl LabError {
    /// The error of a file that cannot be read.
    pub(crate) fn cannot_read(path: &Path, source: std::io::Error) -> Self {
        Self::File { action: "read", path: path.to_owned(), source }
    }
}

fn worlds() -> String {
    umbrage_scene::worlds::ALL.iter().map(|world| world.name).collect::<Vec<_>>().join(", ")
}
