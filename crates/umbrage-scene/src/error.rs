//! What can go wrong with a scene's file, each in one line that ends with the file.

use std::fmt::Display;
use std::path::Path;

use thiserror::Error;

/// The reason that a scene could not be read or written. Every message is one line.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SceneError {
    /// The operating system does not let the file be read.
    #[error("cannot read the file, {reason}: {path}")]
    Read {
        /// The reason that the operating system gives.
        reason: String,
        /// The path of the file.
        path: String,
    },
    /// The file's name does not end in one of the known formats.
    #[error("need a file that ends in .glb, .gltf or .obj: {path}")]
    UnknownKind {
        /// The path of the file.
        path: String,
    },
    /// The file's content is not a scene.
    #[error("{fault}: {path}")]
    Malformed {
        /// What is wrong, and what was needed.
        fault: String,
        /// The path of the file.
        path: String,
    },
    /// The scene cannot be written as glTF, because its values contradict each other or are not finite.
    #[error("{fault}, in scene {scene:?}")]
    Unwritable {
        /// What is wrong, and what was needed.
        fault: String,
        /// The name of the scene.
        scene: String,
    },
}

impl SceneError {
    pub(crate) fn read(reason: impl Display, path: &Path) -> Self {
        Self::Read { reason: one_line(reason), path: one_line(path.display()) }
    }
}

/// What is wrong with a file, by someone who does not know which file it is.
#[derive(Debug, PartialEq)]
pub(crate) struct Fault(pub String);

impl Fault {
    /// The same fault, in the file called `path`.
    pub fn in_file(self, path: impl Display) -> SceneError {
        SceneError::Malformed { fault: one_line(self.0), path: one_line(path) }
    }

    /// The same fault, in a scene that was to be written.
    pub fn in_scene(self, name: &str) -> SceneError {
        SceneError::Unwritable { fault: one_line(self.0), scene: one_line(name) }
    }
}

/// A length with three digits, written out where that is short.
pub(crate) fn short(metres: f64) -> String {
    if (1e-4..1e6).contains(&metres) {
        let digits = (2.0 - metres.log10().floor()).clamp(0.0, 7.0) as usize;
        let text = format!("{metres:.digits$}");
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        format!("{metres:.2e}")
    }
}

/// Enough for any message of ours; files may hold names as long as they like.
const MAX_CHARS: usize = 300;

/// The text without line breaks and other control characters, cut where it is absurdly long.
pub(crate) fn one_line(text: impl Display) -> String {
    let breaks = |c: char| c.is_control() || matches!(c, '\u{2028}' | '\u{2029}');
    let text = text.to_string();
    let mut chars = text.chars().map(|c| if breaks(c) { ' ' } else { c });
    let mut line: String = chars.by_ref().take(MAX_CHARS).collect();
    if chars.next().is_some() {
        line.push('…');
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fault_is_one_line_that_ends_with_the_file() {
        let error =
            Fault("index 9 of a mesh with 4 vertices,\nin mesh \"knight\"".to_owned()).in_file("bunny.glb");
        assert_eq!(error.to_string(), "index 9 of a mesh with 4 vertices, in mesh \"knight\": bunny.glb");
    }

    #[test]
    fn lengths_have_three_digits() {
        for (metres, text) in
            [(0.0625, "0.0625"), (0.0078125, "0.00781"), (8.0, "8"), (1234.5, "1234"), (5e-7, "5.00e-7")]
        {
            assert_eq!(short(metres), text);
        }
    }

    #[test]
    fn a_name_of_a_megabyte_is_cut() {
        let line = one_line("x".repeat(1 << 20));
        assert_eq!(line.chars().count(), MAX_CHARS + 1);
        assert!(line.ends_with('…'));
    }
}
