//! Buffer views that are compressed with meshopt become views of buffers that are not.
//!
//! Source: `EXT_meshopt_compression`; symbols as there. All lengths and offsets are bytes.

use gltf::json::{Buffer, Index, Value};

use super::stream::{Filter, Layout, Mode, decode};
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::gltf::accessors::{Bytes, part};
use crate::import::gltf::document::Document;
use crate::import::gltf::stand_in::StandIn as _;
use crate::import::progress::Progress;
use crate::import::warnings::Warnings;

/// Both names have the same members.
const NAMES: [&str; 2] = ["KHR_meshopt_compression", "EXT_meshopt_compression"];

/// Decompresses every view that says it is compressed.
pub(super) fn unpack(
    document: &mut Document,
    buffers: &mut Vec<Bytes<'_>>,
    budget: &mut Budget,
    progress: &Progress<'_>,
    warnings: &mut Warnings,
) {
    let views = &document.root.buffer_views;
    let compressed: Vec<(usize, &'static str, Value)> = (0..views.len())
        .filter_map(|i| {
            let others = &views[i].extensions.as_ref()?.others;
            NAMES.iter().find_map(|name| Some((i, *name, others.get(*name)?.clone())))
        })
        .collect();
    leave_fallbacks_empty(&document.root.buffers, buffers);
    let of = compressed.len();
    for (done, (i, name, stream)) in compressed.into_iter().enumerate() {
        progress.step("compressed buffer views", done, of);
        match bytes_of(&stream, buffers, budget) {
            Ok(bytes) => {
                let view = &mut document.root.buffer_views[i];
                view.buffer = Index::new(buffers.len() as u32);
                view.byte_offset = None;
                view.byte_length = bytes.len().into();
                view.extensions = None;
                buffers.push(Ok(bytes.into()));
                document.root.buffers.push(Buffer::stand_in());
            }
            Err(Fault(why)) => {
                let why = super::in_words(name, &why);
                let fallback = buffers.get(document.root.buffer_views[i].buffer.value());
                if matches!(fallback, Some(Ok(_))) {
                    let what = "what is compressed and cannot be read is read from the file's fallback";
                    warnings.note(what, &format!("buffer view {i}, {why}"));
                } else {
                    document.broken.insert(("bufferViews", i), why);
                }
            }
        }
    }
}

/// A buffer that only others read, and that has no bytes, has no right to those of the binary chunk.
fn leave_fallbacks_empty(declared: &[Buffer], buffers: &mut [Bytes<'_>]) {
    for (i, (buffer, bytes)) in declared.iter().zip(buffers).enumerate() {
        let others = buffer.extensions.as_ref().map(|extensions| &extensions.others);
        let is_fallback = NAMES.iter().any(|name| {
            let fallback = others.and_then(|others| others.get(*name)?.get("fallback")?.as_bool());
            fallback == Some(true)
        });
        if is_fallback && buffer.uri.is_none() {
            *bytes = Err(format!("buffer {i} is a fallback without bytes"));
        }
    }
}

fn bytes_of(stream: &Value, buffers: &[Bytes<'_>], budget: &mut Budget) -> Result<Vec<u8>, Fault> {
    let number = |name: &str| {
        let number = stream.get(name).and_then(Value::as_u64);
        number.ok_or_else(|| Fault(format!("{name:?} is not a whole number")))
    };
    let layout = Layout {
        count: usize::try_from(number("count")?).unwrap_or(usize::MAX),
        stride: usize::try_from(number("byteStride")?).unwrap_or(usize::MAX),
        mode: match stream.get("mode").and_then(Value::as_str) {
            Some("ATTRIBUTES") => Mode::Attributes,
            Some("TRIANGLES") => Mode::Triangles,
            Some("INDICES") => Mode::Indices,
            other => return Err(Fault(format!("mode {other:?}, need ATTRIBUTES, TRIANGLES or INDICES"))),
        },
        filter: match stream.get("filter").map_or(Some("NONE"), Value::as_str) {
            Some("NONE") => Filter::None,
            Some("OCTAHEDRAL") => Filter::Octahedral,
            Some("QUATERNION") => Filter::Quaternion,
            Some("EXPONENTIAL") => Filter::Exponential,
            Some("COLOR") => Filter::Colour,
            other => {
                let need = "need NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL or COLOR";
                return Err(Fault(format!("filter {other:?}, {need}")));
            }
        },
    };
    let number_of_buffer = number("buffer")? as usize;
    let buffer = match buffers.get(number_of_buffer) {
        Some(Ok(bytes)) => bytes,
        Some(Err(why)) => return Err(Fault(why.clone())),
        None => return Err(Fault(format!("buffer {number_of_buffer} of {} is not there", buffers.len()))),
    };
    let (length, start) =
        (number("byteLength")?, stream.get("byteOffset").and_then(Value::as_u64).unwrap_or(0));
    let bytes = part(buffer, start, length).ok_or_else(|| {
        Fault(format!("a stream of {length} bytes from {start}, in a buffer of {}", buffer.len()))
    })?;
    let room = layout.check(bytes.len())?;
    budget.unpacked(room)?;
    decode(bytes, &layout)
}
