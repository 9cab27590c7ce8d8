//! Files to scenes: glTF 2.0, text or binary, and Wavefront OBJ.
//!
//! A file is not trusted. Whatever it says, the answer is a scene or one line that tells what is wrong; it never panics,
//! and never takes much more memory than the file and the limits in `budget.rs` explain. Only what draws triangles can
//! stop a scene: all else is left out with a warning, and so are broken triangles where others are whole.
//!
//! A reader makes meshes and a draft, in f64; `recentre.rs` gives both origins near to what is drawn, `settle.rs` makes
//! the scene, and `finish.rs` adds what every scene has.

mod budget;
pub(crate) mod domes;
mod draft;
mod extent;
mod files;
mod finish;
mod flatten;
mod gltf;
mod normals;
mod obj;
mod pictures;
mod polygon;
mod progress;
mod recentre;
mod settle;
mod warnings;

use std::fs;
use std::path::Path;

use self::files::Files;
pub(crate) use self::gltf::{TRANSMISSION, UNLIT, VISIBILITY};
#[cfg(test)]
pub(crate) use self::pictures::ktx_file;
pub(crate) use self::pictures::{MAX_SIDE_PX, cube_faces};
use self::progress::Progress;
pub use self::progress::Step;
pub(crate) use self::recentre::{FARTHEST_ORIGIN, would_move};
use self::warnings::Warnings;
use crate::Scene;
use crate::error::{Fault, SceneError};

/// A scene that was read from a file, with warnings about what of the file is not in it.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The scene. It has triangles, cameras, lights and a camera path, even where the file has none.
    pub scene: Scene,
    /// The warnings about what was left out, one line for each kind.
    pub warnings: Vec<String>,
}

/// Reads a `.glb`, `.gltf` or `.obj` file, and the files it refers to.
///
/// Where the file has no camera, one that sees everything is added; where it has no light, a sun; where it has no
/// camera path, a quarter orbit that ends in the first camera's view.
///
/// Where the file's things stand far from its origin, the scene has an origin of its own amid them, [`Scene::origin`].
///
/// # Errors
///
/// When a file cannot be read, is of another kind, or has no triangles that can be read; then the error tells why each
/// was lost.
pub fn load(path: &Path) -> Result<Imported, SceneError> {
    load_telling(path, &|_| ())
}

/// Reads a file as [`load`] does, and tells how far it is.
///
/// # Errors
///
/// As [`load`].
pub fn load_telling(path: &Path, tell: &dyn Fn(Step)) -> Result<Imported, SceneError> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
    let read = match extension.as_deref() {
        Some("glb" | "gltf") => gltf::read,
        Some("obj") => read_obj,
        _ => return Err(SceneError::UnknownKind { path: crate::error::one_line(path.display()) }),
    };
    let kind = fs::metadata(path).map_err(|why| SceneError::read(why, path))?;
    if !kind.is_file() {
        return Err(SceneError::read("it is not a regular file", path));
    }
    if kind.len() > MAX_FILE_BYTES {
        let why = format!("it has {} bytes, and at most {MAX_FILE_BYTES} are read", kind.len());
        return Err(SceneError::read(why, path));
    }
    let bytes = fs::read(path).map_err(|why| SceneError::read(why, path))?;
    let name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    import(read, &bytes, &name, Files::beside(path), tell).map_err(|fault| fault.in_file(path.display()))
}

/// Reads the bytes of a `.glb` or `.gltf` file; its buffers and pictures must be inside, or in data URIs. `name`
/// becomes the scene's name, and stands for the file in errors.
///
/// # Errors
///
/// As [`load`], and when the bytes refer to a file.
pub fn load_glb_bytes(bytes: &[u8], name: &str) -> Result<Imported, SceneError> {
    load_glb_bytes_telling(bytes, name, &|_| ())
}

/// Reads the bytes of a file as [`load_glb_bytes`] does, and tells how far it is.
///
/// # Errors
///
/// As [`load_glb_bytes`].
pub fn load_glb_bytes_telling(bytes: &[u8], name: &str, tell: &dyn Fn(Step)) -> Result<Imported, SceneError> {
    import(gltf::read, bytes, name, Files::none(), tell).map_err(|fault| fault.in_file(name))
}

/// Reads the text of an `.obj` file; material libraries are left out with a warning. `name` becomes the scene's name,
/// and stands for the file in errors.
///
/// # Errors
///
/// As [`load`].
pub fn load_obj_bytes(bytes: &[u8], name: &str) -> Result<Imported, SceneError> {
    import(read_obj, bytes, name, Files::none(), &|_| ()).map_err(|fault| fault.in_file(name))
}

/// No file of the scenes that the budget lets in needs more: it is read as a whole.
const MAX_FILE_BYTES: u64 = 4 << 30;

/// A format's reader: the bytes of the file, the scene's name, the files around it, and who waits.
type Read = fn(&[u8], &str, Files<'_>, &Progress<'_>, &mut Warnings) -> Result<Scene, Fault>;

/// OBJ is read in one go, and tells nothing on the way.
fn read_obj(
    bytes: &[u8],
    name: &str,
    files: Files<'_>,
    _progress: &Progress<'_>,
    warnings: &mut Warnings,
) -> Result<Scene, Fault> {
    obj::read(bytes, name, files, warnings)
}

fn import(
    read: Read,
    bytes: &[u8],
    name: &str,
    files: Files<'_>,
    tell: &dyn Fn(Step),
) -> Result<Imported, Fault> {
    let mut warnings = Warnings::default();
    let mut scene = read(bytes, name, files, &Progress(tell), &mut warnings)?;
    if let Err(Fault(fault)) = finish::finish(&mut scene, &mut warnings) {
        // What was lost on the way is why nothing is left.
        let reasons = warnings.into_lines();
        return Err(Fault([&[fault], &reasons[..]].concat().join("; ")));
    }
    Ok(Imported { scene, warnings: warnings.into_lines() })
}
