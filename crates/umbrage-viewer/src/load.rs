//! Where worlds come from: a name, a path, an address, or the bytes of a file that was dropped or chosen.

use std::path::{Path, PathBuf};

use umbrage_scene::{Imported, Step};

use crate::link::one_line;

/// The largest file that is read as a whole, bytes: a page has 4 GiB in all, and a scene needs several times its file.
const MAX_BYTES: u64 = 512 << 20;

/// The extensions of files that hold a world.
pub const WORLDS: [&str; 3] = ["glb", "gltf", "obj"];

/// A place that a world can be loaded from.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// The name of a built-in world, or a path.
    Named(String),
    /// The address of a file that a page fetches.
    Address(String),
    /// A file's name and its bytes.
    Bytes {
        /// The file's name, with its extension.
        name: String,
        /// The whole file.
        bytes: Vec<u8>,
    },
}

impl Source {
    /// Returns the name or the path of it, for people.
    pub fn name(&self) -> &str {
        match self {
            Self::Named(name) | Self::Address(name) => name,
            Self::Bytes { name, .. } => name,
        }
    }

    /// Reads or generates the world, and tells how far it is.
    ///
    /// # Errors
    /// In one line: when there is no such world, or the file holds none.
    pub fn load(&self, tell: &dyn Fn(Step)) -> Result<Imported, String> {
        match self {
            Self::Named(name) => {
                umbrage_lab::files::load_world_telling(name, 0, tell).map_err(|why| why.to_string())
            }
            Self::Address(address) => {
                let address = one_line(address);
                Err(format!(
                    "`load={address}` is left out: the window reads no addresses; download the file, and open it or drop it here"
                ))
            }
            Self::Bytes { name, bytes } => of_bytes(name, bytes, tell),
        }
    }
}

/// Reads the world of a file's bytes, and tells how far it is.
///
/// # Errors
/// In one line: when they hold none.
pub fn of_bytes(name: &str, bytes: &[u8], tell: &dyn Fn(Step)) -> Result<Imported, String> {
    let path = Path::new(name);
    let stem = path.file_stem().map_or_else(|| name.to_owned(), |stem| stem.to_string_lossy().into_owned());
    let imported = match extension(path).as_str() {
        "glb" | "gltf" => umbrage_scene::load_glb_bytes_telling(bytes, &stem, tell),
        "obj" => umbrage_scene::load_obj_bytes(bytes, &stem),
        _ => return Err(format!("a world is a .glb, .gltf or .obj; got {name}")),
    };
    imported.map_err(|why| {
        let alone = why.to_string();
        // In a page a file comes alone.
        if alone.contains("only bytes") { format!("{alone}; put everything into one .glb") } else { alone }
    })
}

/// Returns the name of a file that was fetched from an address: the last of its path, with an extension by its content where
/// it has none of a world.
///
/// # Errors
/// When neither says that it is a world.
pub fn name_of(address: &str, bytes: &[u8]) -> Result<String, String> {
    let path = address.split(['?', '#']).next().unwrap_or(address);
    let name = path.rsplit('/').next().unwrap_or(path);
    if is_world(Path::new(name)) {
        return Ok(name.to_owned());
    }
    let is_json = bytes.trim_ascii_start().starts_with(b"{");
    match (bytes.starts_with(b"glTF"), is_json) {
        (true, _) => Ok(format!("{name}.glb")),
        (false, true) => Ok(format!("{name}.gltf")),
        (false, false) => Err("what is there is no .glb, .gltf or .obj".to_owned()),
    }
}

/// Checks the size of a file before it is read as a whole.
///
/// # Errors
/// When it is larger than 512 MiB.
pub fn check_size(name: &str, bytes: u64) -> Result<(), String> {
    if bytes <= MAX_BYTES {
        return Ok(());
    }
    Err(format!("a file may have {} MiB at most, and it has {}: {name}", MAX_BYTES >> 20, bytes >> 20))
}

/// Returns whether a file's extension is that of a world.
pub fn is_world(path: &Path) -> bool {
    WORLDS.contains(&extension(path).as_str())
}

/// Returns a path's extension in lower case; empty where it has none.
pub fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
}

/// Returns the world at a path.
pub fn of_path(path: PathBuf) -> Source {
    Source::Named(path.to_string_lossy().into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fetched_file_is_named_by_its_address_or_its_content() {
        let name = |address, bytes: &[u8]| name_of(address, bytes);
        assert_eq!(name("https://example.org/a/b.GLB?raw=1#x", b""), Ok("b.GLB".to_owned()));
        assert_eq!(name("models/helmet", b"glTF\x02"), Ok("helmet.glb".to_owned()));
        assert_eq!(name("https://example.org/get?id=7", b" {\"asset\":{}}"), Ok("get.gltf".to_owned()));
        let wrong = name("https://example.org/index.html", b"<!doctype html>").expect_err("a page");
        assert!(wrong.contains(".glb"), "{wrong}");
        let text = Source::Address("https://example.org/b.glb".to_owned())
            .load(&|_| ())
            .expect_err("no window fetches");
        assert!(text.contains("`load=https://example.org/b.glb`") && text.contains("download"), "{text}");
    }

    #[test]
    fn a_file_that_is_too_large_is_refused_with_its_size() {
        assert_eq!(check_size("a.glb", MAX_BYTES), Ok(()));
        let text = check_size("a.glb", 700 << 20).expect_err("too large");
        assert!(text.contains("512 MiB") && text.contains("700") && text.ends_with("a.glb"), "{text}");
    }

    #[test]
    fn built_in_worlds_and_bytes_are_loaded_and_anything_else_is_refused_in_a_line() {
        let world = Source::Named("primitives".to_owned()).load(&|_| ()).expect("a built-in world");
        let bytes = umbrage_scene::to_glb(&world.scene).expect("a file");
        let read = Source::Bytes { name: "a.GLB".to_owned(), bytes }.load(&|_| ()).expect("the same world");
        assert_eq!(read.scene.triangles(), world.scene.triangles());
        for (name, bytes) in [("a.glb", &b"glTF"[..]), ("a.obj", b""), ("a.png", b"x"), ("noextension", b"")]
        {
            let refused = Source::Bytes { name: name.to_owned(), bytes: bytes.to_vec() }.load(&|_| ());
            let text = refused.err().unwrap_or_else(|| panic!("{name} is no world"));
            assert!(!text.contains('\n') && !text.is_empty(), "{text}");
        }
        let gltf = r#"{"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"beside.bin"}],
            "bufferViews":[{"buffer":0,"byteLength":36}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,1]}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0}"#;
        let alone = Source::Bytes { name: "a.gltf".to_owned(), bytes: gltf.into() }.load(&|_| ());
        let text = alone.expect_err("its buffer is not there");
        assert!(text.contains("beside.bin") && text.contains("one .glb"), "{text}");
        assert!(Source::Named("nowhere".to_owned()).load(&|_| ()).is_err());
    }
}
