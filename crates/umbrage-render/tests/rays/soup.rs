//! Worlds of triangles that lie anyhow: solid, masked and of glass, instanced, turned, stretched and mirrored.

use glam::{Mat4, Quat, Vec2, Vec3, Vec4};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng as _, SeedableRng as _};
use umbrage_scene::{Alpha, Instance, Light, Material, Mesh, Primitive, Scene, Texture};

/// How far from the middle things stand, metres.
const REACH: f32 = 8.0;

/// Places that are asked for each light.
const PLACES: usize = 1500;

struct Chance(Pcg64Mcg);

impl Chance {
    fn number(&mut self, from: f32, to: f32) -> f32 {
        from + (to - from) * (self.0.next_u32() as f32 / u32::MAX as f32)
    }

    fn vector(&mut self, reach: f32) -> Vec3 {
        Vec3::from_array([(); 3].map(|()| self.number(-reach, reach)))
    }
}

/// A world around a point, and places in it.
pub fn of(seed: u64, centre: Vec3) -> (Scene, Vec<Vec3>) {
    let mut chance = Chance(Pcg64Mcg::seed_from_u64(seed));
    let textures = vec![picture(&mut chance), picture(&mut chance)];
    let meshes = (0..3).map(|i| mesh(&mut chance, &format!("soup {i}"))).collect();
    let mut instances: Vec<Instance> = (0..9).map(|i| instance(&mut chance, i % 3, centre)).collect();
    // The same once more, on top of itself.
    instances.push(instances[0].clone());
    let places = (0..PLACES).map(|_| centre + chance.vector(REACH)).collect();
    let lamp = Light { near: 0.25, ..Light::point("point", centre + chance.vector(2.0), 1000.0, 1.0) };
    let eye = centre + 12.0 * (chance.vector(1.0) + 1.5 * Vec3::Y);
    let lights = vec![
        Light::sun(chance.vector(1.0) - 0.5 * Vec3::Y, 1.0),
        Light::spot("spot", eye, centre, 0.4, 0.8, 1000.0, 1.0),
        lamp,
    ];
    let scene = Scene { meshes, instances, materials: materials(), textures, lights, ..Scene::default() };
    (scene, places)
}

/// Solid, masks with a picture and without, glass with a picture and without, and what lets light through its mask.
fn materials() -> Vec<Material> {
    let plain = |name: &str| Material::plain(name, 0.5, 0.5, 0.5);
    let mask = |cutoff| Alpha::Mask { cutoff };
    vec![
        plain("solid"),
        Material { alpha: mask(0.5), texture: Some(0), ..plain("mask") },
        Material { alpha: mask(0.4), base_colour: Vec4::new(1.0, 1.0, 1.0, 0.9), ..plain("mask of corners") },
        Material { alpha: Alpha::Blend, texture: Some(1), ..plain("glass with a picture") },
        Material { alpha: Alpha::Blend, base_colour: Vec4::new(1.0, 1.0, 1.0, 0.6), ..plain("glass") },
        Material { alpha: mask(0.5), texture: Some(1), transmission: 0.3, ..plain("tinted mask") },
    ]
}

/// Alpha that leaps from pixel to pixel. Its sides are no powers of two.
fn picture(chance: &mut Chance) -> Texture {
    let (width, height) = (7, 5);
    let pixels = (0..width * height).flat_map(|_| [255, 255, 255, (chance.0.next_u32() & 255) as u8]);
    Texture { name: "alpha".to_owned(), width, height, rgba: pixels.collect() }
}

/// Triangles of all materials, most of them solid.
fn mesh(chance: &mut Chance, name: &str) -> Mesh {
    let primitives = [12, 12, 12, 12, 12, 12].into_iter().enumerate();
    let primitives = primitives.map(|(material, triangles)| {
        let mut all = Primitive { material, ..Primitive::default() };
        for _ in 0..triangles {
            let middle = chance.vector(1.5);
            for _ in 0..3 {
                all.indices.push(all.positions.len() as u32);
                all.positions.push(middle + chance.vector(0.8));
                all.normals.push(Vec3::Y);
                all.uvs.push(Vec2::new(chance.number(-2.0, 2.0), chance.number(-2.0, 2.0)));
                all.colours.push(Vec4::new(1.0, 1.0, 1.0, chance.number(0.3, 1.0)));
            }
        }
        all
    });
    Mesh::new(name, &primitives.collect::<Vec<_>>())
}

/// Anywhere around a point, turned anyhow, each axis stretched or squeezed, one in three mirrored.
fn instance(chance: &mut Chance, mesh: usize, centre: Vec3) -> Instance {
    let turn = Quat::from_scaled_axis(chance.vector(3.0));
    let mut scale = Vec3::from_array([(); 3].map(|()| chance.number(0.4, 2.0)));
    scale.x *= if chance.number(0.0, 3.0) < 1.0 { -1.0 } else { 1.0 };
    let place = Mat4::from_scale_rotation_translation(scale, turn, centre + chance.vector(6.0));
    Instance::still(mesh, place * Mat4::from_quat(Quat::from_scaled_axis(chance.vector(3.0))))
}
