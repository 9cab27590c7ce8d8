//! Writes a large .glb of the kind that level editors export: 1.5 million triangles in 300 nodes, one mesh of them with
//! 280 thousand. `cargo run --release -p umbrage-scene --example large_gltf -- large.glb`

use glam::{Mat4, Vec2, Vec3};
use umbrage_scene::{Camera, Instance, Light, Material, Mesh, Primitive, Scene, to_glb};

/// Side of the square town, metres.
const SIDE: f32 = 1000.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("where to? give a path, as large.glb")?;
    let scene = town();
    std::fs::write(&path, to_glb(&scene)?)?;
    println!("{} triangles in {} nodes: {path}", scene.triangles(), scene.instances.len());
    Ok(())
}

/// A ground of 281,250 triangles, and 299 towers of 4,232 each, of 13 kinds.
pub fn town() -> Scene {
    let mut meshes =
        vec![Mesh::new("ground", &[sheet(375, |x, z| Vec3::new(x * SIDE, hills(x, z), z * SIDE))])];
    meshes.extend((0..13).map(|kind| Mesh::new(&format!("tower {kind}"), &[tower(kind as f32)])));
    let mut instances = vec![Instance::still(0, Mat4::IDENTITY)];
    for i in 0..299 {
        // The R2 sequence spreads towers evenly.
        let (x, z) = ((i as f32 * 0.754_877_7).fract(), (i as f32 * 0.569_840_3).fract());
        let place = Vec3::new(x * SIDE, hills(x, z) - 1.0, z * SIDE);
        instances.push(Instance::still(1 + i % 13, Mat4::from_translation(place)));
    }
    let eye = Vec3::new(0.1 * SIDE, 60.0, 0.1 * SIDE);
    let camera = Camera::looking("street", eye, Vec3::new(0.6 * SIDE, 0.0, 0.7 * SIDE), 1.0, 1.0, 500.0);
    Scene {
        name: "town".to_owned(),
        meshes,
        instances,
        materials: vec![Material::plain("plaster", 0.6, 0.57, 0.5)],
        cameras: vec![camera],
        lights: vec![Light::sun(Vec3::new(0.6, -0.7, 0.3), 3.0)],
        ..Scene::default()
    }
}

fn hills(x: f32, z: f32) -> f32 {
    12.0 * (x * 9.0).sin() * (z * 7.0).cos()
}

/// A round tower with waves on its walls, closed at the top.
fn tower(kind: f32) -> Primitive {
    let turn = std::f32::consts::TAU;
    sheet(46, |u, v| {
        let radius =
            (5.0 + 0.4 * (v * (20.0 + kind) + u * turn * 3.0).sin()) * if v > 0.98 { 0.0 } else { 1.0 };
        Vec3::new(radius * (u * turn).cos(), v * (20.0 + 3.0 * kind), -radius * (u * turn).sin())
    })
}

/// A grid of `cells` × `cells` quads over shares 0…1, bent by `place`, with normals from its own slopes.
fn sheet(cells: u32, place: impl Fn(f32, f32) -> Vec3) -> Primitive {
    let share = |i: u32| i as f32 / cells as f32;
    let mut sheet = Primitive::default();
    for j in 0..=cells {
        for i in 0..=cells {
            let (u, v) = (share(i), share(j));
            let step = 0.5 / cells as f32;
            let along_u = place(u + step, v) - place(u - step, v);
            let along_v = place(u, v + step) - place(u, v - step);
            sheet.positions.push(place(u, v));
            sheet.normals.push(along_v.cross(along_u).normalize_or(Vec3::Y));
            sheet.uvs.push(Vec2::new(u, v));
        }
    }
    let at = |i: u32, j: u32| j * (cells + 1) + i;
    for j in 0..cells {
        for i in 0..cells {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            sheet.indices.extend([a, d, b, b, d, c]);
        }
    }
    sheet
}
