//! Bands that are baked, in files: so that a bake which was cut off goes on where it was.
//!
//! A band lies in `KEY-BAND.lightmap`, where KEY is the SHA-256 of all that it depends on (what stands still, where it lies in
//! the atlas, the light, the rays a texel) in hexadecimal, and BAND its number. The file is
//!
//! | bytes | what |
//! |---|---|
//! | 20 | `umbrage light map 1` and a line feed |
//! | 32 | KEY |
//! | 4 × 4 | little-endian: the page, its first row, the number of rows, their width in texels |
//! | rows × width | the texels row by row: 0 shows nothing, n is a visibility of (n − 1) / 254 |
//! | 32 | the SHA-256 of everything before |
//!
//! A file that is anything else is as if it were not there, and is replaced. Files are written under a temporary name and
//! renamed, so that they are whole or not there.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use sha2::{Digest as _, Sha256};

use super::texels::Band;
use crate::error::RivalError;

/// What files begin with. The number is another whenever texels come to be computed otherwise.
const MAGIC: &[u8; 20] = b"umbrage light map 1\n";

/// A SHA-256.
pub(super) type Key = [u8; 32];

/// The SHA-256 of some bytes after each other.
pub(super) fn hash(parts: &[&[u8]]) -> Key {
    let mut hash = Sha256::new();
    for part in parts {
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part);
    }
    hash.finalize().into()
}

/// A folder of bands.
#[derive(Debug)]
pub(super) struct Store<'a> {
    folder: &'a Path,
}

impl<'a> Store<'a> {
    /// Opens a folder, which is made where it is not there.
    ///
    /// # Errors
    /// When it cannot be made, or no file can be made in it.
    pub fn open(folder: &'a Path) -> Result<Self, RivalError> {
        let failed = |source| RivalError::File { path: folder.to_owned(), source };
        std::fs::create_dir_all(folder).map_err(failed)?;
        let made = tempfile::tempfile_in(folder).and_then(|mut file| file.write_all(MAGIC));
        made.map_err(failed)?;
        Ok(Self { folder })
    }

    /// The texels of a band; `None` where they were not baked, or their file is not as it was written.
    pub fn get(&self, key: &Key, (number, band): (usize, &Band), width: u32) -> Option<Vec<u8>> {
        let bytes = std::fs::read(self.path(key, number)).ok()?;
        let (rest, checksum) = bytes.split_last_chunk::<32>()?;
        let texels = rest.strip_prefix(head(key, band, width).as_slice())?;
        let is_whole = texels.len() == band.rows.len() * width as usize;
        (is_whole && Key::from(Sha256::digest(rest)) == *checksum).then(|| texels.to_vec())
    }

    /// Writes a band.
    ///
    /// # Errors
    /// When the system does not let it; then there is no file, or the one that was there.
    pub fn put(
        &self,
        key: &Key,
        (number, band): (usize, &Band),
        width: u32,
        texels: &[u8],
    ) -> Result<(), RivalError> {
        let mut bytes = head(key, band, width);
        bytes.extend_from_slice(texels);
        bytes.extend_from_slice(&Sha256::digest(&bytes));
        let path = self.path(key, number);
        let written = temporary(self.folder).and_then(|mut file| {
            file.write_all(&bytes)?;
            Ok(file.persist(&path)?)
        });
        written.map(drop).map_err(|source| RivalError::File { path, source })
    }

    fn path(&self, key: &Key, number: usize) -> PathBuf {
        let key: String = key.iter().map(|byte| format!("{byte:02x}")).collect();
        self.folder.join(format!("{key}-{number}.lightmap"))
    }
}

fn temporary(folder: &Path) -> std::io::Result<tempfile::NamedTempFile> {
    #[cfg_attr(not(unix), expect(unused_mut, reason = "only Unix has permissions to set"))]
    let mut builder = tempfile::Builder::new();
    // As any file a program makes; temporary files are otherwise for their owner alone.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
    builder.tempfile_in(folder)
}

/// What a band's file begins with.
fn head(key: &Key, band: &Band, width: u32) -> Vec<u8> {
    let numbers = [band.page, band.rows.start, band.rows.len() as u32, width];
    let numbers = numbers.iter().flat_map(|number| number.to_le_bytes());
    MAGIC.iter().chain(key).copied().chain(numbers).collect()
}
