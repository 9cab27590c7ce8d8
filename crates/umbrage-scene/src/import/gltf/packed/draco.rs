//! Primitives that are compressed with Draco become primitives of plain accessors.
//!
//! Source: `KHR_draco_mesh_compression`. The decoder is that of the crate `draco-core`; a stream says what it holds, and
//! limits bound what it may make of itself.

use std::collections::BTreeMap;

use draco_core::{DecodeLimits, DecoderBuffer, Mesh, MeshDecoder};
use gltf::json::accessor::{ComponentType, GenericComponentType, Type};
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::Checked;
use gltf::json::{Accessor, Buffer, Index, Root, Value, buffer};

use super::column::{Column, column};
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::gltf::accessors::{Bytes, Data};
use crate::import::gltf::document::Document;
use crate::import::gltf::stand_in::StandIn as _;
use crate::import::progress::Progress;
use crate::import::warnings::Warnings;

const NAME: &str = "KHR_draco_mesh_compression";

/// The most bytes that the attributes of one stream may have when they are decoded, half a gibibyte: the decoder needs a
/// few times that.
const MOST_BYTES: usize = 1 << 29;

/// What a stream begins with, and the version that the extension demands.
const MARK: &[u8] = b"DRACO";
const VERSION: &[u8] = &[2, 2];

/// Where a primitive is: its mesh, and its number there.
type Place = (usize, usize);

/// Decompresses every primitive that says it is compressed; each stream once, whoever shares it.
pub(super) fn unpack(
    document: &mut Document,
    buffers: &mut Vec<Bytes<'_>>,
    budget: &mut Budget,
    progress: &Progress<'_>,
    warnings: &mut Warnings,
) {
    let mut streams: BTreeMap<Option<usize>, Vec<Place>> = BTreeMap::new();
    for (m, mesh) in document.root.meshes.iter().enumerate() {
        for (p, primitive) in mesh.primitives.iter().enumerate() {
            if let Some(said) = said(primitive) {
                let view = said.get("bufferView").and_then(Value::as_u64).map(|view| view as usize);
                streams.entry(view).or_default().push((m, p));
            }
        }
    }
    let of = streams.len();
    for (done, (view, places)) in streams.into_iter().enumerate() {
        progress.step("compressed primitives", done, of);
        let decoded = view
            .ok_or_else(|| Fault("\"bufferView\" is not a whole number".to_owned()))
            .and_then(|view| decode(document, buffers, view, budget, progress));
        let mut is_used = true;
        for place in places {
            let rewritten = match &decoded {
                Ok(decoded) => rewrite(document, buffers, place, decoded, budget, warnings),
                Err(Fault(why)) => Err(Fault(why.clone())),
            };
            if let Err(Fault(why)) = rewritten {
                is_used = false;
                give_up(document, place, &super::in_words(NAME, &why), warnings);
            }
        }
        // What is used is paid for there; but a file may have the same decoded for nothing, again and again.
        if let (Ok(mesh), false) = (&decoded, is_used) {
            // Whether there is room for more is asked by who wants more.
            let _ = budget.unpacked(size(mesh));
        }
    }
}

/// The bytes of a decoded mesh.
fn size(mesh: &Mesh) -> usize {
    let attributes = (0..mesh.num_attributes()).filter_map(|id| mesh.try_attribute(id).ok());
    12 * mesh.num_faces() + attributes.map(|attribute| attribute.buffer().data().len()).sum::<usize>()
}

/// What a primitive says of its compression.
fn said(primitive: &Primitive) -> Option<&Value> {
    primitive.extensions.as_ref()?.others.get(NAME)
}

fn decode(
    document: &Document,
    buffers: &[Bytes<'_>],
    view: usize,
    budget: &Budget,
    progress: &Progress<'_>,
) -> Result<Mesh, Fault> {
    let data = Data { root: &document.root, buffers, broken: &document.broken, progress };
    let bytes = data.view(Index::new(u32::try_from(view).unwrap_or(u32::MAX)))?;
    if let Some(version) = bytes.get(MARK.len()..MARK.len() + 2).filter(|_| bytes.starts_with(MARK))
        && version != VERSION
    {
        return Err(Fault(format!("a stream of version {}.{}, need 2.2", version[0], version[1])));
    }
    let limits = DecodeLimits::default()
        .with_max_points(Budget::VERTICES as u64)
        .with_max_faces(Budget::CORNERS as u64 / 3)
        .with_max_decoded_bytes(budget.unpacked_left().min(MOST_BYTES) as u64);
    let mut mesh = Mesh::new();
    MeshDecoder::new()
        .decode(&mut DecoderBuffer::new(bytes).with_limits(limits), &mut mesh)
        .map_err(|why| Fault(format!("a stream of {} bytes: {}", bytes.len(), why.message())))?;
    if mesh.num_points() > Budget::VERTICES {
        return Err(Fault(format!("a stream with {} vertices", mesh.num_points())));
    }
    Ok(mesh)
}

/// Gives a primitive plain accessors.
fn rewrite(
    document: &mut Document,
    buffers: &mut Vec<Bytes<'_>>,
    (m, p): Place,
    decoded: &Mesh,
    budget: &mut Budget,
    warnings: &mut Warnings,
) -> Result<(), Fault> {
    let root = &document.root;
    let primitive = &root.meshes[m].primitives[p];
    let ids = said(primitive).and_then(|said| said.get("attributes"));
    let id = |semantic: &Checked<Semantic>| match semantic {
        // An id that is no number is that of no attribute.
        Checked::Valid(semantic) => Some(ids?.get(semantic.to_string())?.as_u64().unwrap_or(u64::MAX)),
        Checked::Invalid => None,
    };
    let mut columns = Vec::new();
    for (semantic, index) in &primitive.attributes {
        let Some(id) = id(semantic) else { continue };
        let Some(accessor) = root.accessors.get(index.value()) else { continue };
        match column(decoded, id, accessor, budget) {
            Ok(Column { kind, .. })
                if kind != Type::Vec3 && *semantic == Checked::Valid(Semantic::Positions) =>
            {
                let parts = kind.multiplicity();
                return Err(Fault(format!(
                    "positions are attribute {id} of its stream, with {parts} numbers a row"
                )));
            }
            Ok(column) => {
                if accessor.count.0 != decoded.num_points() as u64 {
                    let (said, there) = (accessor.count.0, decoded.num_points());
                    let subject = format!("accessor {index} says {said}, its stream has {there}");
                    warnings.note("compressed vertices are as many as their stream has", &subject);
                }
                columns.push((semantic.clone(), column));
            }
            Err(why) if *semantic == Checked::Valid(Semantic::Positions) => return Err(why),
            Err(Fault(why)) => {
                let mesh = root.meshes[m].name.as_deref().unwrap_or_default();
                let subject = format!("accessor {index}, {why}, in primitive {p} of mesh {m} {mesh:?}");
                warnings.note("compressed attributes that cannot be read are left out", &subject);
            }
        }
    }
    let count = decoded.num_faces().saturating_mul(3);
    budget.unpacked(count.saturating_mul(4))?;
    let corners = decoded.faces().iter().flatten().flat_map(|point| point.0.to_le_bytes()).collect();
    let indices = Column {
        component: ComponentType::U32,
        kind: Type::Scalar,
        normalized: false,
        count,
        bytes: corners,
    };

    let unread: Vec<_> =
        primitive.attributes.keys().filter(|semantic| id(semantic).is_some()).cloned().collect();
    let indices = push(&mut document.root, buffers, indices);
    let columns: Vec<_> = columns
        .into_iter()
        .map(|(semantic, column)| (semantic, push(&mut document.root, buffers, column)))
        .collect();
    let primitive = &mut document.root.meshes[m].primitives[p];
    primitive.attributes.retain(|semantic, _| !unread.contains(semantic));
    primitive.attributes.extend(columns);
    primitive.indices = Some(indices);
    primitive.mode = Checked::Valid(Mode::Triangles);
    if let Some(extensions) = &mut primitive.extensions {
        extensions.others.remove(NAME);
    }
    Ok(())
}

/// An accessor of its own view of its own buffer.
fn push(root: &mut Root, buffers: &mut Vec<Bytes<'_>>, column: Column) -> Index<Accessor> {
    let Column { component, kind, normalized, count, bytes } = column;
    let view = buffer::View {
        buffer: Index::new(buffers.len() as u32),
        byte_length: bytes.len().into(),
        ..buffer::View::stand_in()
    };
    buffers.push(Ok(bytes.into()));
    root.buffers.push(Buffer::stand_in());
    root.buffer_views.push(view);
    root.accessors.push(Accessor {
        buffer_view: Some(Index::new(root.buffer_views.len() as u32 - 1)),
        count: count.into(),
        component_type: Checked::Valid(GenericComponentType(component)),
        type_: Checked::Valid(kind),
        normalized,
        ..Accessor::stand_in()
    });
    Index::new(root.accessors.len() as u32 - 1)
}

/// Leaves a primitive to its fallback, if it has one; else whoever reads its positions is told why there are none.
fn give_up(document: &mut Document, (m, p): Place, why: &str, warnings: &mut Warnings) {
    let primitive = &document.root.meshes[m].primitives[p];
    let Some(positions) = primitive.attributes.get(&Checked::Valid(Semantic::Positions)) else {
        return;
    };
    let has_bytes = |index: &Index<Accessor>| {
        document.root.accessors.get(index.value()).is_some_and(|accessor| accessor.buffer_view.is_some())
    };
    if has_bytes(positions) && primitive.indices.as_ref().is_none_or(has_bytes) {
        let what = "what is compressed and cannot be read is read from the file's fallback";
        warnings.note(what, &format!("primitive {p} of mesh {m}, {why}"));
    } else {
        document.broken.insert(("accessors", positions.value()), format!("primitive {p} of mesh {m}, {why}"));
    }
}
