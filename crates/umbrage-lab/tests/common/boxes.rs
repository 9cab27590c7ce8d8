//! Scenes of boxes under one light.

use glam::{Mat4, Vec2, Vec3};
use umbrage_scene::{Camera, Instance, Light, Material, Mesh, Primitive, Scene};

/// Boxes, each between two corners, as one mesh at the origin.
pub fn scene_of(boxes: &[([f32; 3], [f32; 3])], light: Light, camera: Camera) -> Scene {
    let primitives: Vec<Primitive> =
        boxes.iter().map(|(low, high)| cuboid(Vec3::from(*low), Vec3::from(*high))).collect();
    Scene {
        name: "boxes".to_owned(),
        meshes: vec![Mesh::new("boxes", &primitives)],
        instances: vec![Instance::still(0, Mat4::IDENTITY)],
        materials: vec![Material::plain("grey", 0.5, 0.5, 0.5)],
        cameras: vec![camera],
        lights: vec![light],
        ..Scene::default()
    }
}

/// The axis-aligned box between two corners.
fn cuboid(low: Vec3, high: Vec3) -> Primitive {
    let mut primitive = Primitive::default();
    for axis in 0..3 {
        for side in [0, 1] {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let corner = |along_u: usize, along_v: usize| {
                let mut p = low;
                for (axis, far) in [(axis, side), (u, along_u), (v, along_v)] {
                    p[axis] = if far == 1 { high[axis] } else { low[axis] };
                }
                p
            };
            let mut quad = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
            if side == 0 {
                quad.swap(1, 3);
            }
            let base = primitive.positions.len() as u32;
            let normal = Vec3::AXES[axis] * if side == 1 { 1.0 } else { -1.0 };
            primitive.positions.extend(quad);
            primitive.normals.extend([normal; 4]);
            primitive.uvs.extend([Vec2::ZERO; 4]);
            primitive.indices.extend([0, 1, 2, 0, 2, 3].map(|i| base + i));
        }
    }
    primitive
}
