//! What the program remembers from one time to the next: texts under names. In a window they are files in the user's own folder
//! of data; in a page they stay in the browser.

/// Returns the text that is kept under a name; `None` where there is none.
///
/// # Errors
/// In one line, when it is there and cannot be read.
pub fn read(name: &str) -> Result<Option<String>, String> {
    #[cfg(target_arch = "wasm32")]
    {
        crate::browser::kept(name)
    }
    #[cfg(not(target_arch = "wasm32"))]
    {
        let path = folder()?.join(name);
        match std::fs::read_to_string(&path) {
            Ok(text) => Ok(Some(text)),
            Err(why) if why.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(why) => Err(format!("cannot read {}: {why}", path.display())),
        }
    }
}

/// Keeps a text under a name.
///
/// # Errors
/// In one line, when it cannot be written.
pub fn write(name: &str, text: &str) -> Result<(), String> {
    #[cfg(target_arch = "wasm32")]
    {
        crate::browser::keep(name, text)
    }
    #[cfg(not(target_arch = "wasm32"))]
    {
        let folder = folder()?;
        umbrage_lab::files::make_folder(&folder).map_err(|why| why.to_string())?;
        umbrage_lab::files::write(&folder.join(name), text.as_bytes()).map_err(|why| why.to_string())
    }
}

/// Returns where a text is kept under a name, for people.
pub fn place(name: &str) -> String {
    #[cfg(target_arch = "wasm32")]
    {
        format!("{name} in the browser's local storage")
    }
    #[cfg(not(target_arch = "wasm32"))]
    {
        folder().map_or_else(|_| name.to_owned(), |folder| folder.join(name).display().to_string())
    }
}

/// The folder of data, by the conventions of each system.
#[cfg(not(target_arch = "wasm32"))]
fn folder() -> Result<std::path::PathBuf, String> {
    let of =
        |name: &str| std::env::var_os(name).filter(|value| !value.is_empty()).map(std::path::PathBuf::from);
    let home = |below: &str| of("HOME").map(|home| home.join(below));
    let data = if cfg!(windows) {
        of("APPDATA")
    } else if cfg!(target_os = "macos") {
        home("Library/Application Support")
    } else {
        of("XDG_DATA_HOME").or_else(|| home(".local/share"))
    };
    let unknown =
        || "this system names no folder for a user's data (HOME, XDG_DATA_HOME or APPDATA)".to_owned();
    data.map(|data| data.join("umbrage")).ok_or_else(unknown)
}
