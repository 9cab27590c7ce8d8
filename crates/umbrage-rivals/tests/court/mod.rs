//! A court: boxes, a thin wall and a plate on a ground of 20 m, anywhere in the world.

use std::sync::Arc;

use glam::{Mat4, Vec2, Vec3};
use umbrage_judge::{Eye, Tally, Truth, World};
use umbrage_render::Gpu;
use umbrage_rivals::{Left, Seen};
use umbrage_scene::{Camera, Instance, Light, Material, Mesh, Pose, Primitive, Scene};

pub const SIZE: [u32; 2] = [240, 160];

pub fn gpu() -> Gpu {
    Gpu::new(Some("vulkan")).expect("run scripts/setup")
}

/// A box of 1 m a side around the origin, with outward faces.
fn cube() -> Mesh {
    let mut cube = Primitive::default();
    for (axis, across, up) in
        [(Vec3::X, Vec3::Y, Vec3::Z), (Vec3::Y, Vec3::Z, Vec3::X), (Vec3::Z, Vec3::X, Vec3::Y)]
    {
        for side in [1.0, -1.0] {
            let first = cube.positions.len() as u32;
            for (u, v) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                cube.positions.push(0.5 * (side * axis + side * u * across + v * up));
                cube.normals.push(side * axis);
                cube.uvs.push(Vec2::ZERO);
            }
            cube.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
        }
    }
    Mesh::new("cube", &[cube])
}

/// Boxes of these middles and sizes, metres, at a place in the world.
pub fn boxes(place: Vec3, boxes: &[(Vec3, Vec3)]) -> Scene {
    let instances = boxes.iter().map(|(middle, size)| {
        Instance::still(0, Mat4::from_translation(place + *middle) * Mat4::from_scale(*size))
    });
    Scene {
        name: "court".to_owned(),
        meshes: vec![cube()],
        instances: instances.collect(),
        materials: vec![Material::plain("grey", 0.5, 0.5, 0.5)],
        ..Scene::default()
    }
}

/// The ground, three boxes that touch nothing but it, a wall of 10 cm, and a plate that floats.
pub fn court(place: Vec3) -> Scene {
    let scene = [
        (Vec3::new(0.0, -0.5, 0.0), Vec3::new(20.0, 1.0, 20.0)),
        (Vec3::new(-3.0, 1.0, 1.0), Vec3::new(1.5, 2.0, 1.5)),
        (Vec3::new(1.0, 0.5, 2.0), Vec3::new(1.0, 1.0, 1.0)),
        (Vec3::new(4.0, 1.5, -1.0), Vec3::new(1.0, 3.0, 2.0)),
        (Vec3::new(-0.5, 1.0, -2.0), Vec3::new(3.0, 2.0, 0.1)),
        (Vec3::new(-5.0, 2.5, -4.0), Vec3::new(2.0, 0.2, 2.0)),
    ];
    boxes(place, &scene)
}

/// The court from a height.
pub fn camera(place: Vec3) -> Camera {
    Camera::looking("court", place + Vec3::new(5.0, 8.0, 11.0), place, 0.9, 0.1, 60.0)
}

pub fn sun() -> Light {
    Light::sun(Vec3::new(0.5, -1.0, 0.35), 1e5)
}

pub fn lamp(place: Vec3) -> Light {
    Light::point("lamp", place + Vec3::new(0.0, 4.0, 4.5), 40.0, 1e3)
}

pub fn still() -> Arc<Pose> {
    Arc::new(Pose::default())
}

/// How wrong what was seen of a light is where it is known, in a world in which what is left casts nothing.
pub fn tally(scene: &Scene, left: &[Left], camera: &Camera, light: &Light, seen: &[Option<f32>]) -> Tally {
    let mut casting = scene.clone();
    left.iter().for_each(|left| casting.instances[left.instance].casts = false);
    let world = World::new(&casting, &Pose::default());
    let eye = Eye::new(camera, SIZE[0], SIZE[1]);
    let truth = Truth::new(&world, &eye, &umbrage_judge::Light::of(light), f64::INFINITY);
    let mut tally = Tally::default();
    for (pixel, seen) in truth.pixels.iter().zip(seen) {
        if let Some(seen) = seen {
            tally.count(Some(*pixel), *seen);
        }
    }
    tally
}

/// The pixel at which a point of the world is seen.
pub fn at(camera: &Camera, seen: &Seen, point: Vec3) -> Option<f32> {
    let (x, y, _) = Eye::new(camera, SIZE[0], SIZE[1]).project(point.as_dvec3()).expect("in sight");
    seen.visibility[0][y as usize * SIZE[0] as usize + x as usize]
}
