//! What a frame costs before anything is drawn: moving boxes, planning and listing, of 50,000 things over kilometres, on one
//! thread. It needs no GPU. Times are medians with the least and the most of them.
//!
//! `cargo run --release -p umbrage-render --example lists -- [THINGS] [FRAMES]`

use std::time::Instant;

use glam::{Mat4, Vec2, Vec3};
use umbrage_render::draws::{DrawLists, PartTable};
use umbrage_render::umbrage::{Camera, CameraError, Light, Projection, Settings, ShadowPlan, plan};
use umbrage_scene::{Instance, Material, Mesh, Motion, Pose, Primitive, Scene};

/// The world is so large, metres.
const SIDE: f32 = 6000.0;
/// Frames come so many seconds after each other.
const STEP_SECONDS: f32 = 1.0 / 60.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let things: u32 = args.next().map_or(Ok(50_000), |count| count.parse())?;
    let frames: usize = args.next().map_or(Ok(60), |count| count.parse())?;
    println!("{things} things, {frames} frames, ms");
    println!("{:34}{:>24}{:>24}{:>24}{:>24}", "", "move", "plan", "lists", "all");
    for (lights, name) in [(sun()?, "a sun"), (points()?, "4 point lights")] {
        for moves in [Moves::None, Moves::OneInHundred, Moves::All, Moves::Shuffle] {
            measure(&format!("{name}, {}", moves.name()), &scene(things, moves), &lights, frames, -0.1)?;
        }
        measure(&format!("{name}, nothing in view"), &scene(things, Moves::None), &lights, frames, 4.0)?;
    }
    let mesh = of_meshes(vec![Mesh::new("ground", &[ground(1582)])], Vec::new());
    measure("a sun, a mesh of 5 M triangles", &mesh, &sun()?, frames, -0.1)?;
    let triangle = of(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![0, 1, 2]);
    let all = scene(things, Moves::None).instances;
    let all = all.into_iter().map(|instance| Instance { mesh: 0, ..instance }).collect();
    let triangles = of_meshes(vec![Mesh::new("triangle", &[triangle])], all);
    measure("a sun, instances of one triangle", &triangles, &sun()?, frames, -0.1)?;
    Ok(())
}

/// Flies over a scene, looking down or up by this slope, and prints what each frame took.
fn measure(
    name: &str,
    scene: &Scene,
    lights: &[Light],
    frames: usize,
    slope: f32,
) -> Result<(), Box<dyn std::error::Error>> {
    let mut table = PartTable::new(scene);
    let mut lists = DrawLists::default();
    let mut planned: ShadowPlan = plan(&camera(0, slope)?, lights, table.bounds(), &Settings::default())?;
    let mut times: [Vec<f64>; 4] = Default::default();
    for frame in 0..=frames {
        let camera = camera(frame, slope)?;
        let pose = Pose::at(frame as f32 * STEP_SECONDS);
        let start = Instant::now();
        table.move_to(&scene.instances, &pose);
        let moved = start.elapsed();
        planned.replan(&camera, lights, table.bounds(), &Settings::default())?;
        let after_plan = start.elapsed();
        table.list(&mut lists, &mut planned, &camera, true);
        let all = start.elapsed();
        // The first frame makes the room that the others use.
        if frame > 0 {
            for (times, time) in times.iter_mut().zip([moved, after_plan - moved, all - after_plan, all]) {
                times.push(time.as_secs_f64() * 1e3);
            }
        }
    }
    println!("{name:34}{}  {} instances drawn", times.map(spread).concat(), lists.instances().len());
    Ok(())
}

/// The camera of a frame: 30 m above the ground, at 30 m a second, in a slow turn.
fn camera(frame: usize, slope: f32) -> Result<Camera, CameraError> {
    let (sin, cos) = (0.004 * frame as f32).sin_cos();
    let eye = Vec3::new(-400.0 + 0.5 * frame as f32, 30.0, 0.2 * frame as f32);
    let projection = Projection::Perspective { fov_y: 0.9, aspect: 16.0 / 9.0 };
    Camera::looking(eye, eye + Vec3::new(cos, slope, sin), Vec3::Y, projection, 0.5, 3000.0)
}

fn sun() -> Result<Vec<Light>, Box<dyn std::error::Error>> {
    Ok(vec![Light::directional(Vec3::new(0.5, -1.0, 0.3))?])
}

fn points() -> Result<Vec<Light>, Box<dyn std::error::Error>> {
    let at = |x: f32, z: f32| Light::point(Vec3::new(x, 40.0, z), 300.0);
    Ok(vec![at(0.0, 0.0)?, at(0.0, 400.0)?, at(-200.0, -300.0)?, at(900.0, 100.0)?])
}

/// Which things move from frame to frame.
#[derive(Clone, Copy)]
enum Moves {
    None,
    OneInHundred,
    All,
    /// All, to somewhere else in the world.
    Shuffle,
}

impl Moves {
    fn name(self) -> &'static str {
        match self {
            Self::None => "nothing moves",
            Self::OneInHundred => "1 in 100 moves",
            Self::All => "all move",
            Self::Shuffle => "all are shuffled",
        }
    }

    /// The motion of a thing around a place.
    fn motion(self, thing: u32, centre: Vec3) -> Motion {
        let turn =
            |centre, radians_per_second| Motion::Rotation { centre, axis: Vec3::Y, radians_per_second };
        match self {
            Self::OneInHundred if thing.is_multiple_of(100) => turn(centre, 1.0),
            Self::None | Self::OneInHundred => Motion::Still,
            Self::All => turn(centre, 1.0),
            Self::Shuffle => turn(Vec3::ZERO, (thing % 997) as f32),
        }
    }
}

/// Things of five meshes on a ground in one mesh.
fn scene(things: u32, moves: Moves) -> Scene {
    let mut meshes: Vec<Mesh> = (0..5).map(|i| Mesh::new("thing", &[tetrahedron(1.0 + i as f32)])).collect();
    meshes.push(Mesh::new("ground", &[ground(400)]));
    let mut random = 1u32;
    let mut share = || {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (random >> 8) as f32 / (1u32 << 24) as f32
    };
    let instances = (0..things).map(|i| {
        let centre = Vec3::new(share() - 0.5, 0.005 * share(), share() - 0.5) * SIDE;
        let still = Instance::still(i as usize % 5, Mat4::from_translation(centre));
        Instance { motion: moves.motion(i, centre), ..still }
    });
    of_meshes(meshes, instances.collect())
}

/// Instances of meshes, and one of the last of these.
fn of_meshes(meshes: Vec<Mesh>, mut instances: Vec<Instance>) -> Scene {
    instances.push(Instance::still(meshes.len() - 1, Mat4::IDENTITY));
    let materials = vec![Material::plain("grey", 0.5, 0.5, 0.5)];
    Scene { meshes, instances, materials, ..Scene::default() }
}

fn tetrahedron(size: f32) -> Primitive {
    let positions = vec![Vec3::ZERO, Vec3::X * size, Vec3::Y * size, Vec3::Z * size];
    of(positions, vec![0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2])
}

/// A lattice of so many quads a side.
fn ground(quads: u32) -> Primitive {
    let row = quads + 1;
    let at = |i: u32| {
        let [x, z] = [i % row, i / row].map(|k| (k as f32 / quads as f32 - 0.5) * SIDE);
        Vec3::new(x, 0.0, z)
    };
    let firsts = (0..quads * quads).map(|i| i % quads + i / quads * row);
    let indices = firsts.flat_map(|a| [a, a + row, a + 1, a + 1, a + row, a + row + 1]).collect();
    of((0..row * row).map(at).collect(), indices)
}

fn of(positions: Vec<Vec3>, indices: Vec<u32>) -> Primitive {
    let (normals, uvs) = (vec![Vec3::Y; positions.len()], vec![Vec2::ZERO; positions.len()]);
    Primitive { positions, normals, uvs, indices, ..Primitive::default() }
}

/// The median of times, the least and the most.
fn spread(mut times: Vec<f64>) -> String {
    times.sort_by(f64::total_cmp);
    let [least, median, most] = [0, times.len() / 2, times.len().saturating_sub(1)].map(|i| times[i]);
    format!("{median:9.3} ({least:.3} to {most:.3})")
}
