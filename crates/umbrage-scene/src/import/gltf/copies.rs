//! Nodes that place their mesh many times.
//!
//! Source: `EXT_mesh_gpu_instancing`: the node's transform comes after each instance's own.

use std::collections::BTreeMap;

use glam::{DMat4, Quat, Vec3};
use gltf::json::{Accessor, Index, Node, Value};

use super::accessors::Data;
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::warnings::Warnings;

/// An instance of a node's mesh, in the node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Copy {
    translation: Vec3,
    rotation: Quat,
    scale: Vec3,
}

/// The copies of those nodes that have such, by the nodes' numbers.
pub(super) type Copies = BTreeMap<usize, Vec<Copy>>;

impl Copy {
    const ONE: Self = Self { translation: Vec3::ZERO, rotation: Quat::IDENTITY, scale: Vec3::ONE };

    pub fn node_from_copy(&self) -> DMat4 {
        let Self { translation, rotation, scale } = self;
        DMat4::from_scale_rotation_translation(
            scale.as_dvec3(),
            rotation.as_dquat().normalize(),
            translation.as_dvec3(),
        )
    }
}

/// Reads the copies of all nodes. What of them cannot be read is left out; only more than the budget allows stops here.
pub(super) fn read(data: &Data<'_>, budget: &mut Budget, warnings: &mut Warnings) -> Result<Copies, Fault> {
    let mut copies = Copies::new();
    for (i, node) in data.root.nodes.iter().enumerate() {
        if let Some(attributes) = attributes(node) {
            let label = node.name.clone().unwrap_or_else(|| format!("node {i}"));
            let read = of_node(data, attributes, &label, budget, warnings);
            copies.insert(i, read.map_err(|Fault(why)| Fault(format!("{why}, {label}")))?);
        }
    }
    Ok(copies)
}

fn attributes(node: &Node) -> Option<&Value> {
    node.mesh?;
    node.extensions.as_ref()?.others.get("EXT_mesh_gpu_instancing")?.get("attributes")
}

fn of_node(
    data: &Data<'_>,
    attributes: &Value,
    label: &str,
    budget: &mut Budget,
    warnings: &mut Warnings,
) -> Result<Vec<Copy>, Fault> {
    let mut there = |name: &'static str| -> Option<(&'static str, Index<Accessor>, usize)> {
        let index = attributes.get(name)?.as_u64().and_then(|index| u32::try_from(index).ok());
        let index = index.map(Index::new).ok_or_else(|| Fault("it names no accessor".to_owned()));
        match index.and_then(|index| Ok((name, index, data.count(index)?))) {
            Ok(there) => Some(there),
            Err(why) => {
                note_unread((name, label), &why, warnings);
                None
            }
        }
    };
    let there = ["TRANSLATION", "ROTATION", "SCALE"].map(&mut there);
    let counts = || there.iter().flatten().map(|(_, _, count)| *count);
    let (Some(count), Some(most)) = (counts().min(), counts().max()) else {
        warnings.note("instances that nothing places are drawn once, where their node is", label);
        return Ok(vec![Copy::ONE]);
    };
    if count != most {
        let what = "instances whose attributes are not equally many are as many as the fewest";
        warnings.note(what, &format!("{count} and {most} of {label}"));
    }
    budget.instances(most)?;
    let [translation, rotation, scale] = there;
    let translations = rows::<3>(data, translation, label, warnings);
    let rotations = rows::<4>(data, rotation, label, warnings);
    let scales = rows::<3>(data, scale, label, warnings);
    let mut copies = vec![Copy::ONE; count];
    for (i, copy) in copies.iter_mut().enumerate() {
        let at = |rows: &Vec<[f32; 3]>| rows.get(i).map(|row| Vec3::from(*row));
        copy.translation = translations.as_ref().and_then(at).unwrap_or(copy.translation);
        copy.scale = scales.as_ref().and_then(at).unwrap_or(copy.scale);
        if let Some(rotation) = rotations.as_ref().and_then(|rows| rows.get(i)) {
            copy.rotation = Quat::from_array(*rotation);
        }
    }
    let is_usable = |copy: &Copy| {
        let Copy { translation, rotation, scale } = copy;
        translation.is_finite() && scale.is_finite() && rotation.length_squared().is_normal()
    };
    copies.retain(is_usable);
    let lost = count - copies.len();
    if lost > 0 {
        let what = "instances that stand nowhere are left out";
        warnings.note(what, &format!("{lost} of {count} of {label}, need finite numbers and unit rotations"));
    }
    Ok(copies)
}

/// The rows of an attribute; `None` where it is not there, or cannot be read.
fn rows<const N: usize>(
    data: &Data<'_>,
    there: Option<(&'static str, Index<Accessor>, usize)>,
    label: &str,
    warnings: &mut Warnings,
) -> Option<Vec<[f32; N]>> {
    let (name, index, _) = there?;
    data.vectors::<N>(index).map_err(|why| note_unread((name, label), &why, warnings)).ok()
}

fn note_unread((name, label): (&str, &str), Fault(why): &Fault, warnings: &mut Warnings) {
    let what = "attributes of instances that cannot be read are ignored";
    warnings.note(what, &format!("{name} of {label}, {why}"));
}
