//! Scenes of cards: a ground, and flat things above it that cover all or some of their place.

use glam::{Mat4, Vec2, Vec3, Vec4};
use umbrage_scene::{Alpha, Instance, Material, Mesh, Primitive, Scene, Texture};

/// A square of two triangles about the origin, level, `half` to each side, with the whole picture on it.
pub fn square(half: f32, material: usize) -> Primitive {
    let corner = |x: f32, z: f32| Vec3::new(x, 0.0, z) * half;
    Primitive {
        positions: vec![corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)],
        normals: vec![Vec3::Y; 4],
        uvs: vec![Vec2::ZERO, Vec2::Y, Vec2::ONE, Vec2::X],
        indices: vec![0, 1, 2, 0, 2, 3],
        material,
        ..Primitive::default()
    }
}

/// A ground of 40 m, and things above it: each a square of 4 m, its material and where it stands.
pub fn scene(things: Vec<(Primitive, Material, Mat4)>, textures: Vec<Texture>) -> Scene {
    let mut scene = Scene {
        meshes: vec![Mesh::new("ground", &[square(20.0, 0)])],
        instances: vec![Instance::still(0, Mat4::IDENTITY)],
        materials: vec![Material::plain("ground", 0.8, 0.8, 0.8)],
        textures,
        ..Scene::default()
    };
    for (primitive, material, place) in things {
        scene.meshes.push(Mesh::new("card", &[Primitive { material: scene.materials.len(), ..primitive }]));
        scene.materials.push(material);
        scene.instances.push(Instance::still(scene.meshes.len() - 1, place));
    }
    scene
}

/// A material whose base colour has an alpha, and perhaps a texture.
pub fn material(alpha: Alpha, factor: f32, texture: Option<usize>) -> Material {
    let plain = Material::plain("m", 1.0, 1.0, 1.0);
    Material { alpha, texture, base_colour: Vec4::new(1.0, 1.0, 1.0, factor), ..plain }
}
