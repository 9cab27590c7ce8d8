//! Compressed geometry to plain geometry. What is compressed is decompressed once, before anything is read, and the
//! document is rewritten as if it had been written without compression; so no other reader knows of it.
//!
//! Source: `EXT_meshopt_compression`, `KHR_meshopt_compression` (the same members, and newer streams) and
//! `KHR_draco_mesh_compression`. Quantised numbers, `KHR_mesh_quantization`, are accessors like others.
//!
//! What cannot be decompressed is read from the fallback that the file may hold. Where there is none, the reason is kept
//! among what is broken, and told by whoever needs it.

mod column;
mod draco;
mod meshopt;
mod stream;

use super::accessors::Bytes;
use super::document::Document;
use crate::import::budget::Budget;
use crate::import::progress::Progress;
use crate::import::warnings::Warnings;

/// Decompresses buffer views, and then primitives, whose streams may lie in such views.
pub(super) fn unpack(
    document: &mut Document,
    buffers: &mut Vec<Bytes<'_>>,
    budget: &mut Budget,
    progress: &Progress<'_>,
    warnings: &mut Warnings,
) {
    meshopt::unpack(document, buffers, budget, progress, warnings);
    draco::unpack(document, buffers, budget, progress, warnings);
}

/// What to do where compressed data cannot be read.
fn in_words(extension: &str, why: &str) -> String {
    format!("{extension}, {why}; compress the file again, or write it without compression")
}
