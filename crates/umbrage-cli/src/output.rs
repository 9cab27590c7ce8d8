//! Files and stdout. A file appears whole or not at all.

use std::io::Write as _;
use std::path::Path;

use anyhow::Context as _;
use image::{ExtendedColorType, ImageEncoder as _};
use serde::Serialize;
use umbrage_lab::files::write;

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
    Ok(write(path, &bytes)?)
}

/// A value as JSON, with a line's end behind it.
pub fn json(value: &impl Serialize) -> anyhow::Result<String> {
    Ok(serde_json::to_string_pretty(value)? + "\n")
}

/// Writes JSON to a file, or to stdout where the path is `-`.
pub fn write_json(path: &Path, value: &impl Serialize) -> anyhow::Result<()> {
    write_text(path, &json(value)?)
}

/// Writes a text to a file, or to stdout where the path is `-`.
pub fn write_text(path: &Path, text: &str) -> anyhow::Result<()> {
    if path.as_os_str() == "-" { print(text) } else { Ok(write(path, text.as_bytes())?) }
}

/// Prints to stdout. A reader that has gone away is no failure.
pub fn print(text: &str) -> anyhow::Result<()> {
    print_bytes(text.as_bytes())
}

/// Prints as [`print`] does what is text, and comes as bytes.
pub fn print_bytes(text: &[u8]) -> anyhow::Result<()> {
    match std::io::stdout().lock().write_all(text) {
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        result => result.context("cannot write to stdout"),
    }
}
