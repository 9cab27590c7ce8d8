//! Files and stdout. A file appears whole or not at all.

use std::io::Write as _;
use std::path::Path;

use anyhow::Context as _;
use image::{ExtendedColorType, ImageEncoder as _};
use serde::Serialize;

/// Writes bytes under a temporary name beside `path`, and renames.
pub fn write(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    let failed = || format!("cannot write {}", path.display());
    anyhow::ensure!(!path.is_dir(), "cannot write over a folder: {}", path.display());
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    // As any file a program makes; temporary files are otherwise for their owner alone.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
    let mut file = builder.tempfile_in(folder).with_context(failed)?;
    file.write_all(bytes).with_context(failed)?;
    file.persist(path).with_context(failed)?;
    Ok(())
}

/// Writes a picture as PNG.
pub fn write_png(
    path: &Path,
    width: u32,
    height: u32,
    pixels: &[u8],
    kind: ExtendedColorType,
) -> anyhow::Result<()> {
    let mut bytes = Vec::new();
    image::codecs::png::PngEncoder::new(&mut bytes).write_image(pixels, width, height, kind)?;
    write(path, &bytes)
}

/// Writes JSON to a file, or to stdout where the path is `-`.
pub fn write_json(path: &Path, value: &impl Serialize) -> anyhow::Result<()> {
    let mut text = serde_json::to_string_pretty(value)?;
    text.push('\n');
    if path.as_os_str() == "-" { print(&text) } else { write(path, text.as_bytes()) }
}

/// Prints to stdout. A reader that has gone away is no failure.
pub fn print(text: &str) -> anyhow::Result<()> {
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        result => result.context("cannot write to stdout"),
    }
}
