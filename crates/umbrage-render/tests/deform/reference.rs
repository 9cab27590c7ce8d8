//! What a pose makes of a mesh, in f64 and without a GPU; and the same scene with still meshes of that.

use glam::{DMat3, DMat4, DVec3, Mat4, Vec3};
use umbrage_scene::{Instance, Mesh, Pose, Primitive, Rig, Scene};

/// Positions and unit normals of an instance, relative to where it stands.
pub fn bent(scene: &Scene, instance: &Instance, pose: &Pose) -> Vec<(DVec3, DVec3)> {
    let mesh = &scene.meshes[instance.mesh];
    let weights = instance.node.map_or(&[][..], |node| pose.weights(node));
    let place = instance.world_from_mesh_in(pose).w_axis.truncate().as_dvec3();
    let joints: Option<Vec<DMat4>> = instance.skin.map(|skin| {
        let skin = &scene.rig.skins[skin];
        let here = DMat4::from_translation(-place);
        skin.joints.iter().map(|(node, bind)| here * pose.world_from_node(*node) * bind.as_dmat4()).collect()
    });
    let vertex = |i: usize| {
        let (mut position, mut normal) = (mesh.positions[i].as_dvec3(), mesh.normals[i].as_dvec3());
        for (target, weight) in mesh.targets.iter().zip(weights) {
            position += target.positions[i].as_dvec3() * f64::from(*weight);
            normal += target.normals[i].as_dvec3() * f64::from(*weight);
        }
        if let Some(joints) = joints.as_ref().filter(|_| !mesh.influences.is_empty()) {
            let blended = mesh
                .influences
                .of(i)
                .fold(DMat4::ZERO, |sum, (joint, weight)| sum + joints[joint] * f64::from(weight));
            position = (blended * position.extend(1.0)).truncate();
            normal = DMat3::from_mat4(blended).inverse().transpose() * normal;
        }
        (position, normal.normalize_or_zero())
    };
    (0..mesh.positions.len()).map(vertex).collect()
}

/// The scene as it stands in a pose, with nothing that moves or bends.
pub fn baked(scene: &Scene, pose: &Pose) -> Scene {
    let mut still = Scene { rig: Rig::default(), instances: Vec::new(), ..scene.clone() };
    for instance in scene.instances.iter().filter(|instance| instance.is_visible_in(pose)) {
        let world_from_mesh = instance.world_from_mesh_in(pose);
        let mut mesh = instance.mesh;
        if instance.is_deformed(&scene.meshes[mesh]) {
            let bent = bent(scene, instance, pose);
            let joints = instance.skin.map(|skin| pose.joints(&scene.rig, skin).collect::<Vec<Mat4>>());
            let is_mirrored = joints.is_some_and(|joints| joints[0].determinant() < 0.0);
            let old = &scene.meshes[mesh];
            let mut indices = old.indices.clone();
            if is_mirrored {
                indices.as_chunks_mut::<3>().0.iter_mut().for_each(|triangle| triangle.swap(1, 2));
            }
            let of = |pick: fn(&(DVec3, DVec3)) -> DVec3| -> Vec<Vec3> {
                bent.iter().map(|vertex| pick(vertex).as_vec3()).collect()
            };
            let primitive = Primitive {
                positions: of(|vertex| vertex.0),
                normals: of(|vertex| vertex.1),
                uvs: old.uvs.clone(),
                indices,
                material: old.parts[0].material,
                ..Primitive::default()
            };
            mesh = still.meshes.len();
            still.meshes.push(Mesh::new(&old.name, &[primitive]));
        }
        still.instances.push(Instance { casts: instance.casts, ..Instance::still(mesh, world_from_mesh) });
    }
    still
}
