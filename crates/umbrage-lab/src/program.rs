//! Who measures: a result belongs to the code that made it (`docs/decisions/0010-cells-and-programs.md`).

use std::path::Path;

use crate::{LabError, files};

/// A program is known by the hash of the file that holds its code: a build that changes the code has another.
///
/// Whoever opens a [`Store`](crate::Store) says which file that is, since only they know.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Program {
    hash: String,
}

impl Program {
    /// Identifies the program that runs, by its executable file.
    ///
    /// # Errors
    /// When that file cannot be read.
    pub fn running() -> Result<Self, LabError> {
        let own = Path::new("the program's own file");
        let path = std::env::current_exe().map_err(|why| LabError::cannot_read(own, why))?;
        Self::of_file(&path)
    }

    /// Identifies code that runs within another program, by the library that holds it: an interpreter's executable is the
    /// same whatever it has imported.
    ///
    /// # Errors
    /// When the file cannot be read.
    pub fn of_file(path: &Path) -> Result<Self, LabError> {
        let bytes = std::fs::read(path).map_err(|why| LabError::cannot_read(path, why))?;
        Ok(Self { hash: files::hash(&bytes) })
    }

    /// Returns the hash: SHA-256 in hexadecimal.
    pub fn hash(&self) -> &str {
        &self.hash
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_is_its_file_and_another_build_is_another_program() {
        assert_eq!(Program::running().unwrap(), Program::running().unwrap());
        let folder = tempfile::tempdir().unwrap();
        let library = folder.path().join("library.so");
        std::fs::write(&library, b"one build").unwrap();
        let first = Program::of_file(&library).unwrap();
        assert_ne!(first, Program::running().unwrap(), "whoever has loaded it");
        std::fs::write(&library, b"the next").unwrap();
        assert_ne!(first, Program::of_file(&library).unwrap());
        std::fs::remove_file(&library).unwrap();
        assert!(Program::of_file(&library).unwrap_err().to_string().contains("library.so"));
    }
}
