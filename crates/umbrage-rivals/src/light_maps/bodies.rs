//! Which surfaces bound bodies that have an inside: closed meshes, which face outward. Whether a point lies in one of them tells
//! what nobody sees from what is in shadow.

use umbrage_scene::Scene;

use super::unwrap::has_texels;

/// Whether each triangle of what stands still bounds a body that casts.
pub(super) fn bodies(scene: &Scene, closed: &[bool]) -> Vec<bool> {
    let standing = scene.instances.iter().filter(|instance| !instance.is_dynamic());
    standing
        .flat_map(|instance| {
            let mesh = &scene.meshes[instance.mesh];
            let is_upright = instance.world_from_mesh.determinant() > 0.0;
            let is_body = instance.casts && is_upright && closed[instance.mesh];
            has_texels(scene, mesh).map(move |has| has && is_body)
        })
        .collect()
}
