//! Skins, and what bends the vertices of meshes, as glTF writes them.

use gltf::json::accessor::{ComponentType, Type};
use gltf::json::mesh::{MorphTarget, Semantic};
use gltf::json::validation::Checked::{self, Valid};
use gltf::json::{Accessor, Index, Skin};

use super::bytes::Document;
use super::rig::Tree;
use crate::error::Fault;
use crate::rig::Rig;
use crate::{Aabb, Influences, Mesh};

/// Joints of a vertex in one set.
const A_SET: usize = 4;

/// An attribute of a primitive.
type Attribute = (Checked<Semantic>, Index<Accessor>);

/// Adds the joints and weights of a mesh's vertices, in sets of four.
pub(super) fn influences(document: &mut Document, mesh: &Mesh) -> Result<Vec<Attribute>, Fault> {
    let Influences { per_vertex, joints, weights } = &mesh.influences;
    let (per_vertex, count) = (*per_vertex, mesh.positions.len());
    if joints.len() != per_vertex * count || weights.len() != per_vertex * count {
        let (joints, weights) = (joints.len(), weights.len());
        return Err(Fault(format!(
            "{count} vertices of {per_vertex} joints, {joints} joints and {weights} weights"
        )));
    }
    if !weights.iter().all(|weight| weight.is_finite()) {
        return Err(Fault("weights of joints that are not finite".to_owned()));
    }
    let mut attributes = Vec::new();
    for set in 0..per_vertex.div_ceil(A_SET) {
        let range = A_SET * set..per_vertex.min(A_SET * (set + 1));
        let rows =
            || (0..count).map(|vertex| vertex * per_vertex + range.start..vertex * per_vertex + range.end);
        let of = rows().flat_map(|row| padded(&joints[row], 0)).flat_map(u16::to_le_bytes);
        let view = document.view(of, Some(gltf::json::buffer::Target::ArrayBuffer));
        let of = document.accessor(view, 0, count, ComponentType::U16, Type::Vec4);
        let by = document.floats(Type::Vec4, rows().map(|row| padded(&weights[row], 0.0)));
        attributes.push((Valid(Semantic::Joints(set as u32)), of));
        attributes.push((Valid(Semantic::Weights(set as u32)), by));
    }
    Ok(attributes)
}

fn padded<T: Copy>(row: &[T], rest: T) -> [T; A_SET] {
    std::array::from_fn(|i| row.get(i).copied().unwrap_or(rest))
}

/// Adds the morph targets of a mesh; none where it has none.
pub(super) fn targets(document: &mut Document, mesh: &Mesh) -> Result<Option<Vec<MorphTarget>>, Fault> {
    let count = mesh.positions.len();
    let mut targets = Vec::with_capacity(mesh.targets.len());
    for (i, target) in mesh.targets.iter().enumerate() {
        let all = || target.positions.iter().chain(&target.normals);
        if target.positions.len() != count || target.normals.len() != count || !all().all(|v| v.is_finite()) {
            return Err(Fault(format!("morph target {i}, need {count} finite displacements and normals")));
        }
        let extent = Aabb::of_points(target.positions.iter().copied());
        let positions = document.floats(Type::Vec3, target.positions.iter().map(glam::Vec3::to_array));
        document.set_extent(positions, extent.min.to_array(), extent.max.to_array());
        let normals = document.floats(Type::Vec3, target.normals.iter().map(glam::Vec3::to_array));
        targets.push(MorphTarget { positions: Some(positions), normals: Some(normals), tangents: None });
    }
    Ok((!targets.is_empty()).then_some(targets))
}

/// Adds the skins of a rig, in order.
pub(super) fn skins(document: &mut Document, rig: &Rig, tree: &Tree<'_>) -> Result<Vec<Index<Skin>>, Fault> {
    let mut skins = Vec::with_capacity(rig.skins.len());
    for (i, skin) in rig.skins.iter().enumerate() {
        if !skin.joints.iter().all(|(_, matrix)| matrix.is_finite()) {
            return Err(Fault(format!("skin {i} has matrices that are not finite")));
        }
        let joints = skin.joints.iter().map(|(node, _)| tree.node(*node)).collect::<Result<_, _>>()?;
        let matrices = skin.joints.iter().map(|(_, matrix)| matrix.to_cols_array());
        let matrices = document.unbound_floats(Type::Mat4, matrices);
        skins.push(document.root.push(Skin {
            joints,
            inverse_bind_matrices: Some(matrices),
            name: None,
            skeleton: None,
            extensions: None,
            extras: None,
        }));
    }
    Ok(skins)
}
