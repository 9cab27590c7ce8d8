//! What holes and moves cost: the stages of a world's frames as it is, with nothing that moves, and with every surface solid,
//! frame by frame in turns, as medians with the least and the most.
//!
//! `cargo run --release -p umbrage-render --example stages -- [WORLD] [FRAMES]`

use std::sync::Arc;

use umbrage_render::umbrage::Settings;
use umbrage_render::{Frame, FrameTimes, Gpu, Renderer, Show};
use umbrage_scene::{Alpha, Scene, worlds};

/// The size of a picture, pixels.
const SIZE: [u32; 2] = [960, 540];

/// Frames come so many seconds after each other.
const STEP_SECONDS: f32 = 1.0 / 30.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let world = args.next().unwrap_or_else(|| "grove".to_owned());
    let frames: usize = args.next().map_or(Ok(11), |count| count.parse())?;
    let scene = worlds::build(&world, 0).ok_or_else(|| format!("no world is called {world}"))?;
    let gpu = Gpu::new(None)?;
    let variants = [("as it is", scene.clone()), ("still", still(&scene)), ("all solid", solid(&scene))];
    println!("{world}, {} x {}, {}, {frames} frames of each, ms", SIZE[0], SIZE[1], gpu.adapter);
    let mut renderers = Vec::new();
    for (_, scene) in &variants {
        renderers.push(Renderer::new(&gpu, scene, Settings::default())?);
    }
    let mut times: Vec<Vec<FrameTimes>> = vec![Vec::new(); variants.len()];
    for frame in 0..=frames {
        for (((_, scene), renderer), times) in variants.iter().zip(&mut renderers).zip(&mut times) {
            let pose = Arc::new(scene.pose(frame as f32 * STEP_SECONDS));
            let frame_of = Frame::of(&scene.cameras[0], &scene.lights[..1], &pose, SIZE, Show::World)?;
            let rendered = renderer.render(&frame_of)?;
            // The first frame makes what the others need.
            if frame > 0 {
                times.push(rendered.times);
            }
        }
    }
    println!("{:12}{:>22}{:>22}{:>22}{:>22}", "", "bending", "casters", "shading", "frame");
    for ((name, _), times) in variants.iter().zip(&times) {
        let stages: [fn(&FrameTimes) -> f64; 4] = [|t| t.deform, |t| t.casters, |t| t.shade, |t| t.frame];
        let cells: Vec<String> =
            stages.iter().map(|stage| spread(times.iter().map(stage).collect())).collect();
        println!("{name:12}{}", cells.concat());
    }
    Ok(())
}

/// The scene with no animation.
fn still(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.rig.playing = None;
    scene
}

/// The scene with neither masks nor glass.
fn solid(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    for material in &mut scene.materials {
        (material.alpha, material.transmission) = (Alpha::Opaque, 0.0);
    }
    scene
}

/// The median of some times, with the least and the most.
fn spread(mut times: Vec<f64>) -> String {
    times.sort_by(f64::total_cmp);
    let at = |share: usize| times.get((times.len() - 1) * share / 2).copied().unwrap_or(f64::NAN);
    format!("{:>8.1} {:>13}", at(1), format!("({:.1}-{:.1})", at(0), at(2)))
}
