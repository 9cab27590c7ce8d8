//! Files: written whole or not at all, and known by their hashes.

use std::io::{Error, ErrorKind, Write as _};
use std::path::Path;

use sha2::{Digest as _, Sha256};
use umbrage_scene::{Imported, Scene, Step, worlds};

use crate::LabError;

/// Writes bytes under a temporary name beside `path`, and renames that file. A link is followed. A device or a pipe is
/// written into: a file in its place would be a surprise.
///
/// # Errors
/// When the system does not let it, or `path` is a folder. A file that was there stays as it was.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), LabError> {
    replace(path, bytes).map_err(|source| LabError::File { action: "write", path: path.to_owned(), source })
}

fn replace(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let target = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    if target.is_dir() {
        return Err(Error::new(ErrorKind::IsADirectory, "it is a folder"));
    }
    if target.exists() && !target.is_file() {
        return std::fs::OpenOptions::new().write(true).open(target)?.write_all(bytes);
    }
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut file = temporary(folder)?;
    file.write_all(bytes)?;
    file.persist(target)?;
    Ok(())
}

/// Makes a folder, and those that it lies in, where they are not there.
///
/// # Errors
/// When the system does not let it.
pub fn make_folder(folder: &Path) -> Result<(), LabError> {
    let failed = |source| LabError::File { action: "write", path: folder.to_owned(), source };
    std::fs::create_dir_all(folder).map_err(failed)
}

/// Checks whether files can be made in a folder: it makes one, and removes it.
///
/// # Errors
/// When the system does not let it.
pub fn check_writable(folder: &Path) -> Result<(), LabError> {
    let made = temporary(folder).and_then(|mut file| file.write_all(b"whether there is room"));
    made.map_err(|source| LabError::File { action: "write", path: folder.to_owned(), source })
}

fn temporary(folder: &Path) -> std::io::Result<tempfile::NamedTempFile> {
    #[cfg_attr(not(unix), expect(unused_mut, reason = "only Unix has permissions to set"))]
    let mut builder = tempfile::Builder::new();
    // As any file a program makes; temporary files are otherwise for their owner alone.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
    builder.tempfile_in(folder)
}

/// Loads a built-in world by its name, or a world from a file by its path. `seed` is what a built-in world is made from.
///
/// # Errors
/// When there is no such world, or its file cannot be read.
pub fn load_world(name: &str, seed: u64) -> Result<Imported, LabError> {
    load_world_telling(name, seed, &|_| ())
}

/// Loads a world as [`load_world`] does, and tells how far the reading of a file is.
///
/// # Errors
/// As [`load_world`].
pub fn load_world_telling(name: &str, seed: u64, tell: &dyn Fn(Step)) -> Result<Imported, LabError> {
    if let Some(scene) = worlds::build(name, seed) {
        return Ok(Imported { scene, warnings: Vec::new() });
    }
    let path = Path::new(name);
    if path.extension().is_none() && !path.exists() {
        return Err(LabError::World { name: name.to_owned() });
    }
    Ok(umbrage_scene::load_telling(path, tell)?)
}

/// Computes the SHA-256 of some bytes, in hexadecimal.
pub fn hash(bytes: &[u8]) -> String {
    format!("{:x}", Sha256::digest(bytes))
}

/// Computes the hash of everything in a scene.
///
/// # Errors
/// When the scene contradicts itself, so that it cannot be exported.
pub fn scene_hash(scene: &Scene) -> Result<String, LabError> {
    Ok(hash(&umbrage_scene::to_glb(scene)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_sha_256() {
        // FIPS 180-2, appendix B.1.
        assert_eq!(hash(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }

    #[test]
    fn what_is_in_a_scene_has_a_hash() {
        let world = |seed| scene_hash(&load_world("primitives", seed).unwrap().scene).unwrap();
        assert_eq!(world(0), world(0));
        let mut moved = load_world("primitives", 0).unwrap().scene;
        moved.cameras[0].far += 1.0;
        assert_ne!(scene_hash(&moved).unwrap(), world(0));
    }

    #[test]
    fn a_world_that_is_not_there_is_named() {
        let text = load_world("atlantis", 0).unwrap_err().to_string();
        assert!(text.contains("`atlantis`") && text.contains("mining-terrain"), "{text}");
        assert!(matches!(load_world("no/such/file.glb", 0), Err(LabError::Scene(_))));
    }

    #[test]
    fn a_file_is_replaced_whole_or_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        write(&path, b"old").unwrap();
        write(&path, b"new").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"new");
        assert!(matches!(write(folder.path(), b"x"), Err(LabError::File { action: "write", .. })));
        assert!(matches!(write(&path.join("below a file"), b"x"), Err(LabError::File { .. })));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is left over");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            let mode = |path| std::fs::metadata(path).unwrap().permissions().mode() & 0o777;
            let plain = folder.path().join("plain");
            std::fs::write(&plain, b"").unwrap();
            assert_eq!(mode(&path), mode(&plain) & 0o644, "readable for whom any file is");
        }
    }

    #[cfg(unix)]
    #[test]
    fn pipes_are_written_into_and_links_followed() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        assert!(std::process::Command::new("mkfifo").arg(at("pipe")).status().unwrap().success(), "mkfifo");
        let reader = std::thread::spawn({
            let pipe = at("pipe");
            move || std::fs::read(pipe).unwrap()
        });
        write(&at("pipe"), b"through").unwrap();
        assert_eq!(reader.join().unwrap(), b"through");
        assert!(!at("pipe").is_file(), "the pipe is still one");
        write(&at("far"), b"old").unwrap();
        std::os::unix::fs::symlink("far", at("near")).unwrap();
        write(&at("near"), b"new").unwrap();
        assert_eq!(std::fs::read(at("far")).unwrap(), b"new");
        assert!(at("near").is_symlink(), "the link is still one");
    }
}
