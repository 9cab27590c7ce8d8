//! The bytes that a scene's file refers to: files beside it, and data that is written out in its URIs.

use std::fs;
use std::path::{Path, PathBuf};

use base64::alphabet;
use base64::engine::{DecodePaddingMode, Engine as _, GeneralPurpose, GeneralPurposeConfig};
use percent_encoding::percent_decode_str;

use crate::error::Fault;

/// Where relative URIs lead. `None` where there is no file, only bytes: then nothing outside them is read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Files<'a> {
    folder: Option<&'a Path>,
}

impl<'a> Files<'a> {
    /// Lets files beside the scene's own be read.
    pub fn beside(scene: &'a Path) -> Self {
        Self { folder: Some(scene.parent().unwrap_or(Path::new(""))) }
    }

    /// Lets no files be read.
    pub fn none() -> Self {
        Self { folder: None }
    }

    /// Fetches what a glTF URI stands for: `data:` with base64, or a percent-encoded path relative to the scene's file.
    pub fn fetch(self, uri: &str) -> Result<Vec<u8>, Fault> {
        match uri.split_once(':') {
            Some(("data", data)) => {
                let (kind, text) = data.split_once(',').unwrap_or((data, ""));
                if !kind.ends_with(";base64") {
                    return Err(Fault("a data URI that is not base64".to_owned()));
                }
                BASE64.decode(text).map_err(|why| Fault(format!("a data URI with broken base64: {why}")))
            }
            Some((scheme, _)) if scheme.len() > 1 && scheme.bytes().all(|b| b.is_ascii_alphanumeric()) => {
                Err(Fault(format!("cannot fetch {uri:?}, need a relative path or a data URI")))
            }
            _ => self.read(&percent_decode_str(uri).decode_utf8_lossy()),
        }
    }

    /// Reads a file beside the scene's. Only regular files are read: a device or a pipe may never end.
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

/// RFC 4648 base64, padded or not: files in the wild leave the padding out.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::Indifferent)
        .with_decode_allow_trailing_bits(true),
);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_as_in_the_rfc_with_or_without_padding() {
        let fetch = |text: &str| Files::none().fetch(&format!("data:application/octet-stream;base64,{text}"));
        for (text, bytes) in [("", ""), ("Zg==", "f"), ("Zm8=", "fo"), ("Zm9v", "foo"), ("Zm9vYmE", "fooba")]
        {
            assert_eq!(fetch(text).unwrap(), bytes.as_bytes(), "{text}");
        }
        assert!(fetch("Zm9v!").is_err(), "no letter of base64");
    }

    #[test]
    fn percent_signs_stand_for_bytes() {
        let folder = tempfile::tempdir().unwrap();
        for (uri, name) in [("a%20b%C3%A9.bin", "a bé.bin"), ("100%", "100%")] {
            fs::write(folder.path().join(name), name).unwrap();
            let files = Files::beside(&folder.path().join("scene.gltf")).fetch(uri).unwrap();
            assert_eq!(files, name.as_bytes());
        }
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
