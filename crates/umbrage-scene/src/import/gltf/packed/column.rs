//! One attribute of a decoded Draco mesh as the rows of an accessor, in the numbers that the file's accessor declares.

use draco_core::{DataType, Mesh, PointAttribute, PointIndex};
use gltf::json::Accessor;
use gltf::json::accessor::{ComponentType, Type};
use gltf::json::validation::Checked;

use crate::error::Fault;
use crate::import::budget::Budget;

/// Rows, tightly packed, and what an accessor says of them.
#[derive(Debug)]
pub(super) struct Column {
    pub component: ComponentType,
    pub kind: Type,
    pub normalized: bool,
    pub count: usize,
    pub bytes: Vec<u8>,
}

/// The attribute with a unique id, a row for each vertex.
pub(super) fn column(
    mesh: &Mesh,
    id: u64,
    declared: &Accessor,
    budget: &mut Budget,
) -> Result<Column, Fault> {
    let attribute = u32::try_from(id).ok().and_then(|id| mesh.attribute_by_unique_id(id));
    let attribute = attribute.ok_or_else(|| Fault(format!("its stream has no attribute {id}")))?;
    let parts = usize::from(attribute.num_components());
    let kind = match parts {
        1 => Type::Scalar,
        2 => Type::Vec2,
        3 => Type::Vec3,
        4 => Type::Vec4,
        _ => return Err(Fault(format!("attribute {id} of its stream has {parts} numbers a row"))),
    };
    let component = match declared.component_type {
        Checked::Valid(component) => component.0,
        Checked::Invalid => ComponentType::F32,
    };
    let count = mesh.num_points();
    // Numbers that change their kind are floats on the way.
    budget.unpacked(count.saturating_mul(parts).saturating_mul(4))?;
    let bytes = if stored(attribute.data_type()) == Some(component) {
        copied(attribute, count, parts * component.size())
            .ok_or_else(|| Fault(format!("attribute {id} of its stream has no value for a vertex")))?
    } else {
        converted(attribute, count, parts, component)
    };
    Ok(Column { component, kind, normalized: declared.normalized, count, bytes })
}

/// The kind of number that a file's accessor would have for those of a stream.
fn stored(kind: DataType) -> Option<ComponentType> {
    match kind {
        DataType::Int8 => Some(ComponentType::I8),
        DataType::Uint8 | DataType::Bool => Some(ComponentType::U8),
        DataType::Int16 => Some(ComponentType::I16),
        DataType::Uint16 => Some(ComponentType::U16),
        DataType::Uint32 => Some(ComponentType::U32),
        DataType::Float32 => Some(ComponentType::F32),
        DataType::Int32 | DataType::Int64 | DataType::Uint64 | DataType::Float64 | DataType::Invalid => None,
    }
}

/// Rows as they are stored.
fn copied(attribute: &PointAttribute, count: usize, size: usize) -> Option<Vec<u8>> {
    let stride = usize::try_from(attribute.byte_stride()).ok()?;
    let data = attribute.buffer().data();
    let mut bytes = Vec::with_capacity(count * size);
    for point in 0..count {
        let row = attribute.mapped_index(PointIndex(point as u32)).0 as usize;
        let start = row.checked_mul(stride)?;
        bytes.extend_from_slice(data.get(start..start.checked_add(size)?)?);
    }
    Some(bytes)
}

/// Rows of other numbers than are stored; those that the accessor's cannot hold become its nearest.
fn converted(attribute: &PointAttribute, count: usize, parts: usize, component: ComponentType) -> Vec<u8> {
    let values = attribute.read_f32s(count, parts);
    let most = match attribute.data_type() {
        DataType::Int8 => 127.0,
        DataType::Uint8 => 255.0,
        DataType::Int16 => 32767.0,
        DataType::Uint16 => 65535.0,
        DataType::Int32 => i32::MAX as f32,
        DataType::Uint32 => u32::MAX as f32,
        DataType::Int64
        | DataType::Uint64
        | DataType::Float32
        | DataType::Float64
        | DataType::Bool
        | DataType::Invalid => 1.0,
    };
    let values = values.into_iter();
    match component {
        ComponentType::F32 => {
            let unit = if attribute.normalized() { most } else { 1.0 };
            values.flat_map(|value| (value / unit).to_le_bytes()).collect()
        }
        ComponentType::I8 => values.flat_map(|value| (value as i8).to_le_bytes()).collect(),
        ComponentType::U8 => values.flat_map(|value| (value as u8).to_le_bytes()).collect(),
        ComponentType::I16 => values.flat_map(|value| (value as i16).to_le_bytes()).collect(),
        ComponentType::U16 => values.flat_map(|value| (value as u16).to_le_bytes()).collect(),
        ComponentType::U32 => values.flat_map(|value| (value as u32).to_le_bytes()).collect(),
    }
}
