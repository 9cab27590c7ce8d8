//! A world small enough to know by heart: a plate over a ground, seen from straight above under the plate.

use glam::{Mat4, Vec3};
use umbrage_render::{Frame, Gpu, Show};
use umbrage_scene::{Camera, Instance, Lens, Light, Material, Mesh, Primitive, Scene};

/// Side of the picture, pixels, and of what it shows of the ground, metres.
pub const PIXELS: u32 = 64;
pub const METRES: f32 = 6.4;

pub fn gpu() -> Gpu {
    Gpu::new(Some("vulkan")).expect("run scripts/setup")
}

/// A ground of 60 m a side at height 0, and a plate of 2 m a side, 4 m above its middle.
pub fn plate_over_ground() -> Scene {
    let square = |half: f32, height: f32| Primitive {
        positions: [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)]
            .map(|(x, z)| Vec3::new(x * half, height, z * half))
            .to_vec(),
        normals: vec![Vec3::Y; 4],
        uvs: vec![glam::Vec2::ZERO; 4],
        indices: vec![0, 1, 2, 0, 2, 3],
        material: 0,
    };
    Scene {
        name: "plate".to_owned(),
        meshes: vec![Mesh::new("ground", &[square(30.0, 0.0)]), Mesh::new("plate", &[square(1.0, 4.0)])],
        instances: (0..2).map(|mesh| Instance::still(mesh, Mat4::IDENTITY)).collect(),
        materials: vec![Material::plain("grey", 0.5, 0.5, 0.5)],
        ..Scene::default()
    }
}

/// The ground from straight above, so far aside of the plate's middle; every pixel shows ground.
pub fn from_above(light: &Light, show: Show) -> Frame {
    let eye = Vec3::new(0.3, 2.0, -0.2);
    let lens = Lens::Orthographic { half_height: 0.5 * METRES };
    let camera = Camera { lens, ..Camera::looking("down", eye, eye - Vec3::Y, 1.0, 0.5, 3.0) };
    Frame {
        camera: umbrage_render::camera(&camera, 1.0).expect("a good camera"),
        lamps: vec![umbrage_render::lamp(light, 0.0).expect("a good light")],
        planned_for: None,
        seconds: 0.0,
        width: PIXELS,
        height: PIXELS,
        samples: 1,
        show,
    }
}
