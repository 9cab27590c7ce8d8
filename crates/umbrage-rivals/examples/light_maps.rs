//! Bakes light maps of a world, and says how wrong they are where they know something.
//!
//! `cargo run --release -p umbrage-rivals --example light_maps -- WORLD [MiB] [LIGHTS] [FOLDER] [PICTURE.png] [RAYS]`
//!
//! WORLD is a built-in world or a glTF file; LIGHTS is how many of its lights are baked, the brightest first, 1 by default;
//! FOLDER is where what is baked is kept (`-` for nowhere, as for PICTURE); RAYS is how many a texel has at most, 16 by
//! default. What moves casts nothing in the truth, as in light maps.

use std::path::Path;
use std::sync::{Arc, Mutex};
use std::time::Instant;

use umbrage_judge::{Eye, Pixel, Tally, Truth, Verdict, World};
use umbrage_render::Gpu;
use umbrage_rivals::{BakeProgress, BakeStep, Left, LightMapOptions, LightMaps, Rival as _, Seen, View};
use umbrage_scene::{Light, Scene, worlds};

type Failure = Box<dyn std::error::Error>;

const SIZE: [u32; 2] = [480, 270];

fn main() -> Result<(), Failure> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let word = |i: usize| words.get(i).map(String::as_str);
    let scene = scene(word(0).ok_or("which world?")?)?;
    let mebibytes: u64 = word(1).unwrap_or("16").parse()?;
    let options = LightMapOptions { bytes: mebibytes << 20, rays: word(5).unwrap_or("16").parse()? };
    let lights = brightest(&scene, word(2).unwrap_or("1").parse()?);
    let folder = word(3).filter(|folder| *folder != "-").map(Path::new);

    let (gpu, pose) = (Gpu::new(None)?, Arc::new(scene.pose(0.0)));
    let (start, unwrapped) = (Instant::now(), Mutex::new(0.0));
    let tell = |progress: BakeProgress| {
        if let (BakeStep::Trace, 0, Ok(mut seconds)) = (progress.step, progress.done, unwrapped.lock()) {
            *seconds = start.elapsed().as_secs_f64();
        }
        true
    };
    let mut maps = LightMaps::bake(&gpu, &scene, (&lights, &pose), options, folder, &tell)?;
    let baked = start.elapsed().as_secs_f64();
    let unwrapped = unwrapped.into_inner().unwrap_or_default();
    let ([width, height], pages) = maps.pages();
    println!("{}: {} triangles, {} lights", scene.name, scene.triangles(), lights.len());
    println!("texels per metre      {:.2}", maps.texels_per_metre());
    println!("pages a light         {pages} of {width} x {height}");
    println!("charts                {}", maps.charts());
    println!("unwrapping and BVH    {unwrapped:.1} s");
    println!("baking                {:.1} s, {} rays", baked - unwrapped, maps.rays());
    println!("bytes                 {:.2} MiB", maps.bytes() as f64 / f64::from(1 << 20));
    println!(
        "instances             {} stand still or cast nothing, {} left",
        scene.instances.len() - maps.left().len(),
        maps.left().len()
    );

    let camera = &scene.cameras[0];
    let view = View { camera, lights: &lights, pose: &pose, size: SIZE };
    maps.see(&view)?;
    let seen = maps.see(&view)?;
    println!("a picture             {:.2} ms on {}", seen.milliseconds, gpu.adapter);
    println!("to list it            {:.2} ms", seen.listing_milliseconds);
    let truth = judge(&scene, &maps, &view, &seen);
    if let Some(path) = word(4).filter(|path| *path != "-") {
        save(&seen, &truth, Path::new(path))?;
    }
    Ok(())
}

fn scene(name: &str) -> Result<Scene, Failure> {
    match worlds::build(name, 0) {
        Some(scene) => Ok(scene),
        None => Ok(umbrage_scene::load(Path::new(name))?.scene),
    }
}

/// The lights that stand still and shine most: suns by their lux, others by theirs at one metre.
fn brightest(scene: &Scene, count: usize) -> Vec<Light> {
    let mut lights = scene.lights.clone();
    let is_sun = |light: &Light| light.kind == umbrage_scene::LightKind::Directional;
    lights.sort_by(|a, b| is_sun(b).cmp(&is_sun(a)).then(b.intensity.total_cmp(&a.intensity)));
    lights.truncate(count);
    lights
}

/// Says how many of the judged pixels that light maps know are wrong, and returns what is true of the first light's.
fn judge(scene: &Scene, maps: &LightMaps, view: &View<'_>, seen: &Seen) -> Vec<Pixel> {
    let [still, _] = Left::split(scene, maps.left());
    let world = World::new(&still, view.pose);
    let eye = Eye::new(view.camera, SIZE[0], SIZE[1]);
    let mut first = None;
    for (light, visibility) in view.lights.iter().zip(&seen.visibility) {
        let truth = Truth::new(&world, &eye, &umbrage_judge::Light::at(light, view.pose), f64::INFINITY);
        let mut tally = Tally::default();
        for (pixel, seen) in truth.pixels.iter().zip(visibility) {
            seen.iter().for_each(|seen| tally.count(Some(*pixel), *seen));
        }
        println!(
            "{:<21} {:.3} % mis-shadowed ({:.3} falsely shadowed, {:.3} falsely lit) of {} known pixels of {} judged",
            light.name,
            100.0 * tally.mis_shadowed(),
            100.0 * tally.false_shadow_share(),
            100.0 * tally.false_light_share(),
            tally.judged,
            truth.judged(),
        );
        first.get_or_insert(truth.pixels);
    }
    first.unwrap_or_default()
}

/// Writes the first light's visibility in grey; brown where it is not known, red where it is falsely shadowed, and blue where
/// it is falsely lit.
fn save(seen: &Seen, truth: &[Pixel], path: &Path) -> Result<(), Failure> {
    let colour = |(share, truth): (&Option<f32>, &Pixel)| {
        let Some(share) = *share else { return [100, 60, 20] };
        match Verdict::new(Some(*truth), share) {
            Verdict::FalseShadow => [255, 0, 0],
            Verdict::FalseLight => [0, 80, 255],
            Verdict::NotTraced | Verdict::NotJudged | Verdict::Right => [(255.0 * share).round() as u8; 3],
        }
    };
    let pixels = seen.visibility.first().into_iter().flatten().zip(truth);
    let bytes = pixels.flat_map(colour).collect();
    let picture = image::RgbImage::from_raw(SIZE[0], SIZE[1], bytes).ok_or("no light was baked")?;
    Ok(picture.save(path)?)
}
