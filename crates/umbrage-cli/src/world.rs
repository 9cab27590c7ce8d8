//! Worlds, cameras and suns from the command line.

use glam::Vec3;
use umbrage_lab::{LabError, Shot};
use umbrage_render::{Frame, Show};
use umbrage_scene::{Camera, Lens, LightKind, Scene};

use crate::args::WorldArgs;
use crate::failure::{Failure, Outcome};

/// A built-in world, or one from a file. What the file's importer warns of goes to stderr.
pub fn load(name: &str, seed: u64) -> Outcome<Scene> {
    let imported = umbrage_lab::files::load_world(name, seed).map_err(|why| match why {
        LabError::World { .. } => Failure::words(why),
        why => Failure::Work(why.into()),
    })?;
    for warning in &imported.warnings {
        eprintln!("warning: {warning}");
    }
    Ok(imported.scene)
}

/// Size of a picture where the command line does not say, pixels.
const PICTURE: (u32, u32) = (1280, 720);

/// What the command line wants drawn of a scene.
pub fn frame(args: &WorldArgs, scene: &Scene, show: Show) -> Outcome<Frame> {
    let frame = shot(args, scene, PICTURE)?.frame(show).map_err(Failure::words)?;
    Ok(Frame { samples: 4, ..frame })
}

/// What the command line wants a picture of, `size` pixels large where it does not say.
pub fn shot(args: &WorldArgs, scene: &Scene, size: (u32, u32)) -> Outcome<Shot> {
    let (width, height) = args.size.unwrap_or(size);
    let (sun, sun_colour) = match args.sun {
        Some(direction) => (direction, Vec3::ONE),
        None => sun(scene)?,
    };
    if !args.time.is_finite() {
        return Err(Failure::words(format!("--time must be finite, got {} s", args.time)));
    }
    let shot = Shot { camera: camera(args, scene)?, sun, sun_colour, seconds: args.time, width, height };
    // Whatever cannot be drawn is refused here, before any work is done.
    shot.frame(Show::World).map_err(Failure::words)?;
    Ok(shot)
}

/// The way the scene's sunlight travels, and its colour.
fn sun(scene: &Scene) -> Outcome<(Vec3, Vec3)> {
    let suns = scene.lights.iter().filter(|light| light.kind == LightKind::Directional);
    suns.map(|sun| (sun.direction(), sun.colour))
        .next()
        .ok_or_else(|| Failure::words("this world has no directional light; give one with --sun X,Y,Z"))
}

fn camera(args: &WorldArgs, scene: &Scene) -> Outcome<Camera> {
    let chosen = choose(args.camera.as_deref(), &scene.cameras)?;
    let mut camera = chosen.clone();
    if let (Some(eye), Some(target)) = (args.eye, args.target) {
        if eye == target {
            return Err(Failure::words(format!("--eye and --target are the same point, {eye}")));
        }
        let looking = Camera::looking("command line", eye, target, 1.0, chosen.near, chosen.far);
        camera = Camera { lens: chosen.lens, ..looking };
    }
    if let Some(degrees) = args.fov {
        camera.lens = Lens::Perspective { fov_y: degrees.to_radians() };
    }
    camera.near = args.near.unwrap_or(camera.near);
    camera.far = args.far.unwrap_or(camera.far);
    Ok(camera)
}

/// A camera by number or by name; the first where neither is given.
fn choose<'a>(wanted: Option<&str>, cameras: &'a [Camera]) -> Outcome<&'a Camera> {
    let by_number = |wanted: &str| wanted.parse::<usize>().ok().and_then(|number| cameras.get(number));
    let by_name = |wanted: &str| cameras.iter().find(|camera| camera.name == wanted);
    let wanted = wanted.unwrap_or("0");
    by_number(wanted).or_else(|| by_name(wanted)).ok_or_else(|| {
        let names = cameras.iter().enumerate().map(|(i, camera)| format!("{i} ({})", camera.name));
        Failure::words(format!("no camera `{wanted}`; there are {}", names.collect::<Vec<_>>().join(", ")))
    })
}
