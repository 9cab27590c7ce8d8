//! Writes a landscape that no setting was chosen by: 1.5 million triangles in 557 nodes, hills in tiles, boulders and posts,
//! seen from three places. `cargo run --release -p umbrage-scene --example landscape_gltf -- landscape.glb`

use glam::{Mat4, Quat, Vec2, Vec3};
use umbrage_scene::{Camera, Instance, Light, Material, Mesh, Primitive, Scene, to_glb};

/// Side of the square, metres; tiles a side; cells a side of a tile.
const SIDE: f32 = 1200.0;
const TILES: u32 = 12;
const CELLS: u32 = 64;
/// Boulders of some kinds, and posts.
const KINDS: usize = 4;
const BOULDERS: usize = 260;
const POSTS: usize = 153;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("where to? give a path, as landscape.glb")?;
    let scene = landscape();
    std::fs::write(&path, to_glb(&scene)?)?;
    println!("{} triangles in {} nodes: {path}", scene.triangles(), scene.instances.len());
    Ok(())
}

fn landscape() -> Scene {
    let mut meshes: Vec<Mesh> = (0..TILES * TILES).map(|i| tile(i % TILES, i / TILES)).collect();
    let mut instances: Vec<Instance> =
        (0..meshes.len()).map(|i| Instance::still(i, Mat4::IDENTITY)).collect();
    let boulders = meshes.len();
    meshes.extend((0..KINDS).map(|kind| Mesh::new("boulder", &[boulder(kind as f32)])));
    let post = meshes.len();
    meshes.push(Mesh::new("post", &[of_material(2, sheet(8, |u, v| on_tube(0.25, 9.0, u, v)))]));
    for i in 0..BOULDERS + POSTS {
        // The R2 sequence spreads them evenly.
        let (x, z) = ((i as f32 * 0.754_877_7).fract() * SIDE, (i as f32 * 0.569_840_3).fract() * SIDE);
        let place = Mat4::from_translation(Vec3::new(x, height(x, z), z));
        let turned = place * Mat4::from_quat(Quat::from_rotation_y(i as f32));
        let size = 1.5 + 5.0 * hash(i as i32, 7);
        let mesh = if i < BOULDERS { boulders + i % KINDS } else { post };
        let scale = if i < BOULDERS { Mat4::from_scale(Vec3::splat(size)) } else { Mat4::IDENTITY };
        instances.push(Instance::still(mesh, turned * scale));
    }
    let camera = |name: &str, from: [f32; 3], to: [f32; 2]| {
        let eye = Vec3::new(from[0], height(from[0], from[2]) + from[1], from[2]);
        let target = Vec3::new(to[0], height(to[0], to[1]), to[1]);
        Camera::looking(name, eye, target, 60f32.to_radians(), 1.0, 1000.0)
    };
    Scene {
        name: "landscape".to_owned(),
        meshes,
        instances,
        materials: vec![
            Material::plain("grass", 0.30, 0.36, 0.18),
            Material::plain("rock", 0.45, 0.43, 0.40),
            Material::plain("wood", 0.40, 0.28, 0.17),
        ],
        cameras: vec![
            camera("valley", [180.0, 5.0, 210.0], [640.0, 700.0]),
            camera("ridge", [900.0, 40.0, 160.0], [420.0, 800.0]),
            camera("above", [600.0, 160.0, 1180.0], [600.0, 500.0]),
        ],
        lights: vec![Light::sun(Vec3::new(-0.8, -0.34, 0.35), 3.0)],
        ..Scene::default()
    }
}

/// A square of ground, whose vertices are where its neighbours' are.
fn tile(column: u32, row: u32) -> Mesh {
    let side = SIDE / TILES as f32;
    let place = |u: f32, v: f32| {
        let (x, z) = ((column as f32 + u) * side, (row as f32 + v) * side);
        Vec3::new(x, height(x, z), z)
    };
    Mesh::new(&format!("ground {column} {row}"), &[sheet(CELLS, place)])
}

/// Hills of six octaves, sharpest where they are highest, metres.
fn height(x: f32, z: f32) -> f32 {
    let (mut sum, mut amplitude, mut wavelength) = (0.0, 45.0, 420.0);
    for octave in 0..6 {
        sum += amplitude * (1.0 - (2.0 * noise(x / wavelength, z / wavelength, octave) - 1.0).abs());
        (amplitude, wavelength) = (0.45 * amplitude, 0.5 * wavelength);
    }
    sum
}

/// Values of a grid, smoothly between, 0 to 1.
fn noise(x: f32, z: f32, octave: i32) -> f32 {
    let (column, row) = (x.floor(), z.floor());
    let smooth = |t: f32| t * t * (3.0 - 2.0 * t);
    let (u, v) = (smooth(x - column), smooth(z - row));
    let at = |i: i32, j: i32| hash(column as i32 + i + 31 * octave, row as i32 + j - 17 * octave);
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    mix(mix(at(0, 0), at(1, 0), u), mix(at(0, 1), at(1, 1), u), v)
}

/// Of two whole numbers, one between 0 and 1.
fn hash(a: i32, b: i32) -> f32 {
    let mut bits = (a as u32).wrapping_mul(0x9E37_79B1) ^ (b as u32).wrapping_mul(0x85EB_CA77);
    bits = (bits ^ (bits >> 15)).wrapping_mul(0x2C1B_3C6D);
    bits = (bits ^ (bits >> 12)).wrapping_mul(0x297A_2D39);
    (bits ^ (bits >> 15)) as f32 / u32::MAX as f32
}

/// A dented ball of radius 1, 1152 triangles, half in the ground.
fn boulder(kind: f32) -> Primitive {
    let turn = std::f32::consts::TAU;
    let place = |u: f32, v: f32| {
        let dents = 0.18 * (3.0 * turn * u + kind).sin() * (7.0 * v + 2.0 * kind).cos();
        let (radius, along) = (1.0 + dents * (std::f32::consts::PI * v).sin(), std::f32::consts::PI * v);
        let ring = radius * along.sin();
        Vec3::new(ring * (turn * u).cos(), 0.3 - 0.8 * radius * along.cos(), -ring * (turn * u).sin())
    };
    of_material(1, sheet(24, place))
}

/// A tube that stands on the ground.
fn on_tube(radius: f32, height: f32, u: f32, v: f32) -> Vec3 {
    let angle = std::f32::consts::TAU * u;
    Vec3::new(radius * angle.cos(), height * v - 1.0, -radius * angle.sin())
}

fn of_material(material: usize, primitive: Primitive) -> Primitive {
    Primitive { material, ..primitive }
}

/// A grid of `cells` × `cells` quads over shares 0…1, bent by `place`, with normals from its own slopes.
fn sheet(cells: u32, place: impl Fn(f32, f32) -> Vec3) -> Primitive {
    let mut sheet = Primitive::default();
    let step = 0.5 / cells as f32;
    for j in 0..=cells {
        for i in 0..=cells {
            let (u, v) = (i as f32 / cells as f32, j as f32 / cells as f32);
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
