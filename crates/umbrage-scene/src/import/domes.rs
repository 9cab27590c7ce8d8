//! Which meshes are skies: unlit, and around everything. What encloses the world would shadow all of it.
//!
//! An instance is a dome where all its materials are unlit, and its box contains the boxes of all instances but other
//! domes. A sky may be several domes, one inside the other. Where nothing is left inside, there is no dome: a scan whose
//! light is in its textures is unlit too, and is the world itself.
//!
//! Space: world space, metres.

use super::warnings::Warnings;
use crate::{Aabb, Material, Mesh, Scene};

/// Lets domes cast nothing, and warns of each. `said_to_cast` says of each instance whether the file itself says that it
/// casts shadows, which goes before.
pub(super) fn let_cast_nothing(scene: &mut Scene, said_to_cast: &[bool], warnings: &mut Warnings) {
    for dome in domes(scene) {
        let mesh = &scene.meshes[scene.instances[dome].mesh];
        let instance = &mut scene.instances[dome];
        if instance.casts && !said_to_cast.get(dome).is_some_and(|said| *said) {
            instance.casts = false;
            let name = if instance.name.is_empty() { &mesh.name } else { &instance.name };
            warnings.note(WARNING, name);
        }
    }
}

/// How the user gets shadows of a dome after all.
const WARNING: &str = "unlit meshes around everything cast no shadows (--cast NAME, or \"umbrage\": {\"cast\": true} in the extras of the node, lets them)";

/// Whether a mesh has triangles, and all its surfaces are unlit.
pub(crate) fn is_unlit(mesh: &Mesh, materials: &[Material]) -> bool {
    let is_unlit = |material: usize| materials.get(material).is_some_and(|material| material.unlit);
    !mesh.parts.is_empty() && mesh.parts.iter().all(|part| is_unlit(part.material))
}

/// The indices of all domes: the largest unlit instances, each around all that is smaller.
fn domes(scene: &Scene) -> Vec<usize> {
    let boxes: Vec<Aabb> = scene
        .instances
        .iter()
        .map(|of| scene.meshes[of.mesh].bounds.transformed(&of.world_from_mesh))
        .collect();
    let unlit: Vec<bool> = scene.meshes.iter().map(|mesh| is_unlit(mesh, &scene.materials)).collect();
    let is_unlit = |i: usize| unlit[scene.instances[i].mesh];
    // From the smallest on, so that each is compared with all that may lie inside it.
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|a, b| volume(boxes[*a]).total_cmp(&volume(boxes[*b])));
    let mut inside = Vec::with_capacity(order.len());
    let mut sum = Aabb::EMPTY;
    for i in &order {
        inside.push(sum);
        sum = sum.union(boxes[*i]);
    }
    let mut domes = Vec::new();
    for (i, inside) in order.into_iter().zip(inside).rev() {
        if !(is_unlit(i) && !inside.is_empty() && contains(boxes[i], inside)) {
            break;
        }
        domes.push(i);
    }
    domes
}

fn volume(of: Aabb) -> f64 {
    let size = of.size().as_dvec3();
    size.x * size.y * size.z
}

fn contains(outer: Aabb, inner: Aabb) -> bool {
    outer.min.cmple(inner.min).all() && outer.max.cmpge(inner.max).all()
}
