//! What a family of shadows does in built-in worlds: who is served, how much is wrong where only those cast, how long it takes.
//!
//! `cargo run --release -p umbrage-rivals --example volumes -- [--family FAMILY] [--seconds T] [--pictures FOLDER] WORLD…`

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

use umbrage_judge::{Eye, Light as Shining, Pixel, Truth, Verdict, World};
use umbrage_render::Gpu;
use umbrage_rivals::{Family, Left, Seen, View};
use umbrage_scene::{Scene, worlds};

const SIZE: [u32; 2] = [640, 360];

fn main() -> Result<(), Box<dyn Error>> {
    let (mut worlds, mut pictures, mut family) = (Vec::new(), None, "volumes".to_owned());
    let mut seconds = 0.0;
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--pictures" => pictures = words.next(),
            "--seconds" => seconds = words.next().unwrap_or_default().parse()?,
            "--family" => family = words.next().unwrap_or_default(),
            _ => worlds.push(word),
        }
    }
    let gpu = Gpu::new(None)?;
    println!("{family} on {}", gpu.adapter);
    let family = match family.as_str() {
        "blobs" => Family::Blobs { soft: 0.0 },
        "plateaus" => Family::Plateaus { degrees: 0.53 },
        "planar" => Family::Planar {},
        "volumes" => Family::Volumes {},
        other => return Err(format!("no family is called `{other}`").into()),
    };
    for name in worlds {
        measure(&gpu, family, &name, seconds, pictures.as_deref())?;
    }
    Ok(())
}

fn measure(
    gpu: &Gpu,
    family: Family,
    name: &str,
    seconds: f32,
    pictures: Option<&str>,
) -> Result<(), Box<dyn Error>> {
    let scene = worlds::build(name, 1).ok_or_else(|| format!("no world is called `{name}`"))?;
    let start = Instant::now();
    let mut rival = family.ready(gpu, &scene)?;
    let set_up = start.elapsed().as_secs_f64();
    let casting = scene.instances.iter().filter(|instance| instance.casts).count();
    let left = rival.left().to_vec();
    println!(
        "{name}: {} of {casting} instances served whole; {} triangles; set up in {set_up:.2} s",
        casting - left.len(),
        scene.triangles(),
    );
    why(&left);
    let pose = Arc::new(scene.pose(seconds));
    let lights: Vec<_> = scene.lights.iter().take(2).cloned().collect();
    let view = View { camera: &scene.cameras[0], lights: &lights, pose: &pose, size: SIZE };
    rival.see(&view)?;
    let seen = rival.see(&view)?;
    println!(
        "  {:.1} ms a picture of {} lights, {:.1} ms to list it, {} bytes",
        seen.milliseconds,
        lights.len(),
        seen.listing_milliseconds,
        rival.bytes()
    );
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
    let [served, _] = Left::split(scene, left);
    let world = World::new(&served, view.pose);
    let eye = Eye::new(view.camera, SIZE[0], SIZE[1]);
    for (light, seen) in view.lights.iter().zip(&seen.visibility) {
        let truth = Truth::new(&world, &eye, &Shining::at(light, view.pose), f64::INFINITY);
        let pixels = truth.pixels.iter().zip(seen);
        let verdict =
            |(pixel, seen): (&Pixel, &Option<f32>)| seen.map(|seen| Verdict::new(Some(*pixel), seen));
        let verdicts: Vec<Option<Verdict>> = pixels.clone().map(verdict).collect();
        let judged = pixels.filter(|(pixel, seen)| pixel.is_judged() && seen.is_some()).count();
        let count = |wanted: Verdict| verdicts.iter().filter(|verdict| **verdict == Some(wanted)).count();
        let (light_wrong, shadow_wrong) = (count(Verdict::FalseLight), count(Verdict::FalseShadow));
        println!(
            "  {}: {:.4} % wrong of {judged} that are known of {} judged, {light_wrong} falsely lit, {shadow_wrong} falsely in \
             shadow; {} truly in shadow",
            light.name,
            100.0 * (light_wrong + shadow_wrong) as f64 / judged.max(1) as f64,
            truth.judged(),
            truth.count(Pixel::Shadowed),
        );
        if let Some(folder) = pictures {
            let picture = image::RgbImage::from_fn(SIZE[0], SIZE[1], |x, y| {
                let i = (y * SIZE[0] + x) as usize;
                let grey = seen[i].map(|seen| (seen * 255.0) as u8);
                let is_wrong = verdicts[i].is_some_and(Verdict::is_wrong);
                image::Rgb(
                    grey.map_or([0, 0, 160], |grey| if is_wrong { [255, grey / 2, 0] } else { [grey; 3] }),
                )
            });
            picture.save(format!("{folder}/{}-{}.png", scene.name, light.name))?;
        }
    }
    Ok(())
}
