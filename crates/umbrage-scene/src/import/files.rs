//! The bytes that a scene's file refers to: files beside it, and data that is written out in its URIs.

use std::borrow::Cow;
use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Fault;

/// Where relative URIs lead. `None` where there is no file, only bytes: then nothing outside them is read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Files<'a> {
    folder: Option<&'a Path>,
}

impl<'a> Files<'a> {
    /// Files beside the scene's own.
    pub fn beside(scene: &'a Path) -> Self {
        Self { folder: Some(scene.parent().unwrap_or(Path::new(""))) }
    }

    /// No files at all.
    pub fn none() -> Self {
        Self { folder: None }
    }

    /// What a glTF URI stands for: `data:` with base64, or a percent-encoded path relative to the scene's file.
    pub fn fetch(self, uri: &str) -> Result<Vec<u8>, Fault> {
        match uri.split_once(':') {
            Some(("data", data)) => {
                let (kind, text) = data.split_once(',').unwrap_or((data, ""));
                if !kind.ends_with(";base64") {
                    return Err(Fault("a data URI that is not base64".to_owned()));
                }
                base64(text).ok_or_else(|| Fault("a data URI with broken base64".to_owned()))
            }
            Some((scheme, _)) if scheme.len() > 1 && scheme.bytes().all(|b| b.is_ascii_alphanumeric()) => {
                Err(Fault(format!("cannot fetch {uri:?}, need a relative path or a data URI")))
            }
            _ => self.read(&percent_decoded(uri)),
        }
    }

    /// A file beside the scene's. Only regular files: a device or a pipe may never end.
    pub fn read(self, name: &str) -> Result<Vec<u8>, Fault> {
        let fault =
            |why: &dyn std::fmt::Display| Fault(format!("cannot read the file {name:?} it refers to, {why}"));
        let path: PathBuf = self.folder.ok_or_else(|| fault(&"there are only bytes, no folder"))?.join(name);
        let kind = fs::metadata(&path).map_err(|why| fault(&why))?;
        if !kind.is_file() {
            return Err(fault(&"it is not a regular file"));
        }
        fs::read(&path).map_err(|why| fault(&why))
    }
}

/// The text with each `%41` as the byte it stands for.
fn percent_decoded(uri: &str) -> Cow<'_, str> {
    if !uri.contains('%') {
        return uri.into();
    }
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, after @ ..] = rest {
        let hex = |i: usize| after.get(i).and_then(|&b| (b as char).to_digit(16));
        match (first, hex(0), hex(1)) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((high * 16 + low) as u8);
                rest = &after[2..];
            }
            _ => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned().into()
}

/// RFC 4648 base64, padded or not; `None` for any other character.
fn base64(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    let (mut bits, mut count) = (0u32, 0);
    for c in text.trim_end_matches('=').bytes() {
        let six = match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => return None,
        };
        bits = bits << 6 | u32::from(six);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_as_in_the_rfc() {
        for (text, bytes) in [("", ""), ("Zg==", "f"), ("Zm8=", "fo"), ("Zm9v", "foo"), ("Zm9vYmE", "fooba")]
        {
            assert_eq!(base64(text).unwrap(), bytes.as_bytes(), "{text}");
        }
        assert_eq!(base64("Zm9v!"), None);
    }

    #[test]
    fn percent_signs_stand_for_bytes() {
        assert_eq!(percent_decoded("a%20b%C3%A9.bin"), "a bé.bin");
        assert_eq!(percent_decoded("100%"), "100%");
    }

    #[test]
    fn only_relative_paths_and_base64_data_are_fetched() {
        let files = Files::none();
        assert_eq!(files.fetch("data:application/octet-stream;base64,AAEC").unwrap(), [0, 1, 2]);
        assert!(files.fetch("data:text/plain,hello").is_err(), "not base64");
        assert!(files.fetch("https://example.com/a.bin").is_err(), "the net");
        assert!(files.fetch("a.bin").is_err(), "no folder to look in");
    }
}
