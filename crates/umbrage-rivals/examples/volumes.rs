//! What a family of shadows does in built-in worlds: who is served, how much is wrong, how long it takes.
//!
//! `cargo run --release -p umbrage-rivals --example volumes -- [--pictures FOLDER] WORLD…`

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

use umbrage_judge::{Eye, Light as Shining, Truth, Verdict, World};
use umbrage_render::Gpu;
use umbrage_rivals::{Family, Left, Seen, View};
use umbrage_scene::{Scene, worlds};

const SIZE: [u32; 2] = [640, 360];

fn main() -> Result<(), Box<dyn Error>> {
    let mut worlds: Vec<String> = std::env::args().skip(1).collect();
    let pictures = match worlds.first().map(String::as_str) {
        Some("--pictures") if worlds.len() > 1 => worlds.drain(..2).next_back(),
        _ => None,
    };
    let gpu = Gpu::new(None)?;
    println!("{}", gpu.adapter);
    for name in worlds {
        measure(&gpu, &name, pictures.as_deref())?;
    }
    Ok(())
}

fn measure(gpu: &Gpu, name: &str, pictures: Option<&str>) -> Result<(), Box<dyn Error>> {
    let scene = worlds::build(name, 1).ok_or_else(|| format!("no world is called `{name}`"))?;
    let start = Instant::now();
    let mut rival = Family::Volumes {}.ready(gpu, &scene)?;
    let set_up = start.elapsed().as_secs_f64();
    let casting = scene.instances.iter().filter(|instance| instance.casts).count();
    let left = rival.left().to_vec();
    println!(
        "{name}: {} of {casting} instances served; {} triangles; set up in {set_up:.2} s",
        casting - left.len(),
        scene.triangles(),
    );
    why(&left);
    let pose = Arc::new(scene.pose(0.0));
    let lights: Vec<_> = scene.lights.iter().take(2).cloned().collect();
    let view = View { camera: &scene.cameras[0], lights: &lights, pose: &pose, size: SIZE };
    rival.see(&view)?;
    let seen = rival.see(&view)?;
    println!("  {:.1} ms a picture of {} lights, {} bytes", seen.milliseconds, lights.len(), rival.bytes());
    judge(&scene, &left, &view, &seen, pictures)
}

/// Says for how many instances each reason holds.
fn why(left: &[Left]) {
    let mut reasons: Vec<&str> = left.iter().map(|left| left.why.as_str()).collect();
    reasons.sort_unstable();
    for same in reasons.chunk_by(|a, b| a == b) {
        println!("  {} left: {}", same.len(), same[0]);
    }
}

/// Says how much is wrong where only what is served casts.
fn judge(
    scene: &Scene,
    left: &[Left],
    view: &View<'_>,
    seen: &Seen,
    pictures: Option<&str>,
) -> Result<(), Box<dyn Error>> {
    let mut served = scene.clone();
    left.iter().for_each(|left| served.instances[left.instance].casts = false);
    let world = World::new(&served, view.pose);
    let eye = Eye::new(view.camera, SIZE[0], SIZE[1]);
    for (light, seen) in view.lights.iter().zip(&seen.visibility) {
        let truth = Truth::new(&world, &eye, &Shining::at(light, view.pose), f64::INFINITY);
        let verdicts: Vec<_> = truth
            .pixels
            .iter()
            .zip(seen)
            .map(|(pixel, seen)| Verdict::new(Some(*pixel), seen.unwrap_or(1.0)))
            .collect();
        let count = |wanted: Verdict| verdicts.iter().filter(|verdict| **verdict == wanted).count();
        let (light_wrong, shadow_wrong) = (count(Verdict::FalseLight), count(Verdict::FalseShadow));
        let share = 100.0 * (light_wrong + shadow_wrong) as f64 / truth.judged().max(1) as f64;
        println!(
            "  {}: {share:.4} % of {} wrong, {light_wrong} falsely lit, {shadow_wrong} falsely in shadow; {} truly in shadow",
            light.name,
            truth.judged(),
            truth.count(umbrage_judge::Pixel::Shadowed),
        );
        if let Some(folder) = pictures {
            let picture = image::RgbImage::from_fn(SIZE[0], SIZE[1], |x, y| {
                let i = (y * SIZE[0] + x) as usize;
                let grey = (seen[i].unwrap_or(0.5) * 255.0) as u8;
                image::Rgb(if verdicts[i].is_wrong() { [255, grey / 2, 0] } else { [grey; 3] })
            });
            picture.save(format!("{folder}/{}-{}.png", scene.name, light.name))?;
        }
    }
    Ok(())
}
