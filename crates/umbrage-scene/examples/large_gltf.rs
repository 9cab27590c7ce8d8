//! Writes a large .glb of the kind that level editors export: 1.5 million triangles in 300 nodes, one mesh of them with
//! 280 thousand. `cargo run --release -p umbrage-scene --example large_gltf -- large.glb`

#[path = "sheet/mod.rs"]
mod sheet;

use glam::{Mat4, Vec3};
use sheet::sheet;
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
