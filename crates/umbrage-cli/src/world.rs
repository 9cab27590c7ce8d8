//! Worlds, cameras and suns from the command line.

use std::path::Path;

use glam::Vec3;
use umbrage::{Camera, Light};
use umbrage_render::{Frame, Show};
use umbrage_scene::{Lens, Scene, worlds};

use crate::args::WorldArgs;
use crate::failure::{Failure, Outcome};

/// A built-in world, or one from a file. What the file's importer warns of goes to stderr.
pub fn load(name: &str, seed: u64) -> Outcome<Scene> {
    if let Some(scene) = worlds::build(name, seed) {
        return Ok(scene);
    }
    let path = Path::new(name);
    if path.extension().is_none() && !path.exists() {
        let names: Vec<_> = worlds::ALL.iter().map(|world| world.name).collect();
        return Err(Failure::words(format!(
            "no built-in world is called `{name}`, and there is no such file; there are {}",
            names.join(", ")
        )));
    }
    let imported = umbrage_scene::load(path)?;
    for warning in &imported.warnings {
        eprintln!("warning: {warning}");
    }
    Ok(imported.scene)
}

/// What the command line wants drawn of a scene.
pub fn frame(args: &WorldArgs, scene: &Scene, show: Show) -> Outcome<Frame> {
    let (width, height) = args.size;
    let camera = camera(args, scene, width as f32 / height as f32)?;
    let (sun, sun_colour) = match args.sun {
        Some(direction) => (Light::directional(direction).map_err(Failure::words)?, Vec3::ONE),
        None => umbrage_render::sun(scene).ok_or_else(|| {
            Failure::words("this world has no directional light; give one with --sun X,Y,Z")
        })?,
    };
    if !args.time.is_finite() {
        return Err(Failure::words(format!("--time must be finite, got {} s", args.time)));
    }
    Ok(Frame { camera, sun, sun_colour, seconds: args.time, width, height, samples: 4, show })
}

fn camera(args: &WorldArgs, scene: &Scene, aspect: f32) -> Outcome<Camera> {
    let chosen = choose(args.camera.as_deref(), &scene.cameras)?;
    let mut camera = chosen.clone();
    if let (Some(eye), Some(target)) = (args.eye, args.target) {
        if eye == target {
            return Err(Failure::words(format!("--eye and --target are the same point, {eye}")));
        }
        camera = umbrage_scene::Camera {
            lens: chosen.lens,
            ..umbrage_scene::Camera::looking("command line", eye, target, 1.0, chosen.near, chosen.far)
        };
    }
    if let Some(degrees) = args.fov {
        camera.lens = Lens::Perspective { fov_y: degrees.to_radians() };
    }
    camera.near = args.near.unwrap_or(camera.near);
    camera.far = args.far.unwrap_or(camera.far);
    umbrage_render::camera(&camera, aspect).map_err(Failure::words)
}

/// A camera by number or by name; the first where neither is given.
fn choose<'a>(
    wanted: Option<&str>,
    cameras: &'a [umbrage_scene::Camera],
) -> Outcome<&'a umbrage_scene::Camera> {
    let by_number = |wanted: &str| wanted.parse::<usize>().ok().and_then(|number| cameras.get(number));
    let by_name = |wanted: &str| cameras.iter().find(|camera| camera.name == wanted);
    let wanted = wanted.unwrap_or("0");
    by_number(wanted).or_else(|| by_name(wanted)).ok_or_else(|| {
        let names = cameras.iter().enumerate().map(|(i, camera)| format!("{i} ({})", camera.name));
        Failure::words(format!("no camera `{wanted}`; there are {}", names.collect::<Vec<_>>().join(", ")))
    })
}
