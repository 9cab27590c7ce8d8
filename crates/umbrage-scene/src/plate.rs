//! A world small enough to know by heart, for tests.

use glam::{Mat4, Vec2, Vec3};

use crate::{Instance, Material, Mesh, Primitive, Scene};

/// Builds a square ground of `ground_metres` a side at height 0, and a square plate of 2 m a side, `height_metres` above its
/// middle: the shadow of the plate under any light is known in closed form. It has no cameras and no lights.
pub fn plate_over_ground(ground_metres: f32, height_metres: f32) -> Scene {
    let square = |half: f32, height: f32| Primitive {
        positions: [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)]
            .map(|(x, z)| Vec3::new(x * half, height, z * half))
            .to_vec(),
        normals: vec![Vec3::Y; 4],
        uvs: vec![Vec2::ZERO; 4],
        indices: vec![0, 1, 2, 0, 2, 3],
        ..Primitive::default()
    };
    Scene {
        name: "plate".to_owned(),
        meshes: vec![
            Mesh::new("ground", &[square(0.5 * ground_metres, 0.0)]),
            Mesh::new("plate", &[square(1.0, height_metres)]),
        ],
        instances: (0..2).map(|mesh| Instance::still(mesh, Mat4::IDENTITY)).collect(),
        materials: vec![Material::plain("grey", 0.5, 0.5, 0.5)],
        ..Scene::default()
    }
}
