//! Which surfaces bound bodies that have an inside: closed meshes that face outward. Whether a point lies in one of them tells
//! what nobody sees from what is in shadow.

use umbrage_scene::{Mesh, Scene};

use super::unwrap::has_texels;

/// Whether each triangle of what stands still bounds a body that casts.
pub(super) fn bodies(scene: &Scene, closed: &[bool]) -> Vec<bool> {
    let faces_outward: Vec<bool> =
        scene.meshes.iter().zip(closed).map(|(mesh, closed)| *closed && has_volume(mesh)).collect();
    let standing = scene.instances.iter().filter(|instance| !instance.is_dynamic());
    standing
        .flat_map(|instance| {
            let mesh = &scene.meshes[instance.mesh];
            let is_upright = instance.world_from_mesh.determinant() > 0.0;
            let is_body = instance.casts && is_upright && faces_outward[instance.mesh];
            has_texels(scene, mesh).map(move |has| has && is_body)
        })
        .collect()
}

/// Whether a closed mesh faces outward, and is no sheet that was folded.
fn has_volume(mesh: &Mesh) -> bool {
    /// Of a ball's volume, for its area, a fiftieth.
    const LEAST: f64 = 0.002;
    let corner = |i: &u32| mesh.positions[*i as usize].as_dvec3();
    let (mut volume, mut area) = (0.0, 0.0);
    for triangle in mesh.indices.as_chunks::<3>().0 {
        let [a, b, c] = triangle.each_ref().map(corner);
        volume += a.dot(b.cross(c)) / 6.0;
        area += (b - a).cross(c - a).length() / 2.0;
    }
    volume > LEAST * area.powf(1.5)
}
