//! What a world of sixteen times the triangles costs: a built-in world as it is, and with every triangle cut in sixteen and
//! made rough, each with levels of detail of casters and without, frame by frame in turns. Times of caster passes are medians
//! with the least and the most, ms.
//!
//! `cargo run --release -p umbrage-render --example finer -- [WORLD] [FRAMES] [ROUGHNESS]`

use std::sync::Arc;
use std::time::Instant;

use glam::Vec3;
use umbrage_render::umbrage::Settings;
use umbrage_render::{Frame, Gpu, Renderer, Show};
use umbrage_scene::{Mesh, Primitive, Scene, worlds};

/// The size of a picture, pixels.
const SIZE: [u32; 2] = [640, 360];
/// Each side of a triangle is cut in so many.
const CUTS: u32 = 4;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let world = args.next().unwrap_or_else(|| "grove".to_owned());
    let frames: usize = args.next().map_or(Ok(7), |count| count.parse())?;
    // New corners are moved by this share of the side that they lie on.
    let roughness: f32 = args.next().map_or(Ok(0.002), |share| share.parse())?;
    let scene = worlds::build(&world, 0).ok_or_else(|| format!("no world is called {world}"))?;
    let gpu = Gpu::new(None)?;
    println!("{world}, {} x {}, {}, {frames} frames of each", SIZE[0], SIZE[1], gpu.adapter);
    let mut rows = Vec::new();
    for (name, scene) in [("as it is", scene.clone()), ("sixteen times", finer(&scene, roughness))] {
        let start = Instant::now();
        let mut first = None::<Renderer>;
        for (detail, caster_error) in [("levels", 0.25), ("none", 0.0)] {
            let settings = Settings { caster_error, ..Settings::default() };
            let mut renderer = match &first {
                None => Renderer::new(&gpu, &scene, settings)?,
                Some(first) => first.beside(settings)?,
            };
            renderer.keep_tiles = false;
            renderer.render(&frame_of(&scene)?)?;
            if first.is_none() {
                println!(
                    "{name}: {} triangles, first picture after {:.2?}",
                    scene.triangles(),
                    start.elapsed()
                );
                first = Some(renderer);
            } else {
                rows.push((format!("{name}, {detail}"), scene.clone(), renderer, Vec::new()));
            }
        }
        rows.extend(first.map(|renderer| (format!("{name}, levels"), scene.clone(), renderer, Vec::new())));
    }
    for _ in 0..frames {
        for (_, scene, renderer, times) in &mut rows {
            times.push(renderer.render(&frame_of(scene)?)?.times.casters);
        }
    }
    for (name, scene, mut renderer, mut times) in rows {
        let rendered = renderer.render(&frame_of(&scene)?)?;
        let triangles: u64 = rendered.drawn.loads().iter().map(|load| load.triangles).sum();
        times.sort_by(f64::total_cmp);
        let (least, median, most) = (times[0], times[times.len() / 2], times[times.len() - 1]);
        println!("{name:24}{triangles:>12} triangles{median:>9.1} ms ({least:.1} to {most:.1})");
    }
    Ok(())
}

fn frame_of(scene: &Scene) -> Result<Frame, Box<dyn std::error::Error>> {
    let pose = Arc::new(scene.pose(0.0));
    Ok(Frame::of(&scene.cameras[0], &scene.lights[..1], &pose, SIZE, Show::World)?)
}

/// The scene with every triangle cut in sixteen.
fn finer(scene: &Scene, roughness: f32) -> Scene {
    let meshes = scene.meshes.iter().map(|mesh| finer_mesh(mesh, roughness)).collect();
    Scene { meshes, ..scene.clone() }
}

fn finer_mesh(mesh: &Mesh, roughness: f32) -> Mesh {
    let primitives = mesh.parts.iter().map(|part| {
        let mut finer = Primitive { material: part.material, ..Primitive::default() };
        let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
        for corners in indices.as_chunks::<3>().0 {
            cut(mesh, corners.map(|corner| corner as usize), roughness, &mut finer);
        }
        finer
    });
    Mesh::new(&mesh.name, &primitives.collect::<Vec<_>>())
}

/// Adds the sixteen pieces of a triangle.
fn cut(mesh: &Mesh, corners: [usize; 3], roughness: f32, finer: &mut Primitive) {
    let first = finer.positions.len() as u32;
    for row in 0..=CUTS {
        for column in 0..=CUTS - row {
            let shares = [CUTS - row - column, column, row];
            let vertex = |of: &dyn Fn(usize) -> Vec3| mixed(corners.map(of), shares);
            finer.positions.push(moved(corners.map(|corner| mesh.positions[corner]), shares, roughness));
            finer.normals.push(vertex(&|corner| mesh.normals[corner]).normalize_or(Vec3::Y));
            finer.uvs.push(vertex(&|corner| mesh.uvs[corner].extend(0.0)).truncate());
        }
    }
    let number = |row: u32, column: u32| first + row * (CUTS + 1) - row * row.saturating_sub(1) / 2 + column;
    for row in 0..CUTS {
        for column in 0..CUTS - row {
            let (here, up) = (number(row, column), number(row + 1, column));
            finer.indices.extend([here, here + 1, up]);
            if column + 1 < CUTS - row {
                finer.indices.extend([here + 1, up + 1, up]);
            }
        }
    }
}

/// The mean of the corners, weighted in an order that is the same whichever triangle asks.
fn mixed(corners: [Vec3; 3], shares: [u32; 3]) -> Vec3 {
    let mut parts = [0, 1, 2].map(|i| (corners[i].to_array().map(f32::to_bits), corners[i], shares[i]));
    parts.sort_by_key(|(bits, ..)| *bits);
    parts
        .iter()
        .filter(|(.., share)| *share > 0)
        .map(|(_, corner, share)| *corner * *share as f32)
        .sum::<Vec3>()
        / CUTS as f32
}

/// The same, moved a little, by its place alone.
fn moved(corners: [Vec3; 3], shares: [u32; 3], roughness: f32) -> Vec3 {
    let place = mixed(corners, shares);
    if shares.contains(&CUTS) {
        return place;
    }
    let [a, b, c] = corners;
    // Where an edge is shared its length is too; inside, any will do.
    let side = match shares {
        [0, ..] => b.distance(c),
        [_, 0, _] => a.distance(c),
        [_, _, 0] => a.distance(b),
        _ => a.distance(b),
    };
    let noise = |seed: f32| (place.dot(Vec3::new(12.9898, 78.233, 37.719)) + seed).sin() * 43758.547 % 1.0;
    place + Vec3::new(noise(0.0), noise(1.0), noise(2.0)) * side * roughness
}
