//! Worlds, cameras and lights from the command line.

use umbrage_lab::{LabError, Shot};
use umbrage_render::{Frame, Show};
use umbrage_scene::{Camera, Lens, Light, Scene, load_environment};

use crate::args::{LookArgs, WorldArgs};
use crate::failure::{Failure, Outcome};

/// A built-in world, or one from a file. What the file's importer warns of goes to stderr.
pub fn load(name: &str, seed: u64) -> Outcome<Scene> {
    let imported = umbrage_lab::files::load_world(name, seed).map_err(|why| match why {
        LabError::World { .. } => Failure::usage(why),
        why => Failure::Work(why.into()),
    })?;
    for warning in &imported.warnings {
        eprintln!("warning: {warning}");
    }
    Ok(imported.scene)
}

/// The same, with what the command line says lies around it.
pub fn load_with(name: &str, seed: u64, look: &LookArgs) -> Outcome<Scene> {
    let environment =
        look.environment.as_deref().map(load_environment).transpose().map_err(Failure::usage)?;
    Ok(Scene { environment, ..load(name, seed)? })
}

/// As bright as the sun of the built-in worlds, lux.
const SUN_LUX: f32 = 3.0;

/// Size of a picture where the command line does not say, pixels.
pub const PICTURE: (u32, u32) = (1280, 720);

/// What the command line wants drawn of a scene.
pub fn frame(args: &WorldArgs, scene: &Scene, show: Show) -> Outcome<Frame> {
    let frame = shot(args, scene, PICTURE)?.frame(show).map_err(Failure::usage)?;
    Ok(Frame { samples: 4, ..frame })
}

/// What the command line wants a picture of, `size` pixels large where it does not say.
pub fn shot(args: &WorldArgs, scene: &Scene, size: (u32, u32)) -> Outcome<Shot> {
    let (width, height) = args.size.unwrap_or(size);
    if !args.time.is_finite() {
        return Err(Failure::usage(format!("--time must be finite, got {} s", args.time)));
    }
    let (camera, lights) = (camera(args, scene)?, lights(args, scene)?);
    let shot = Shot { camera, lights, seconds: args.time, width, height };
    // Whatever cannot be drawn is refused here, before any work is done.
    shot.frame(Show::World).map_err(Failure::usage)?;
    Ok(shot)
}

/// The lights that shine: a sun from the command line, or those of the world that it names, or all of them.
fn lights(args: &WorldArgs, scene: &Scene) -> Outcome<Vec<Light>> {
    if let Some(direction) = args.sun {
        // It is refused here, by the words that were given.
        umbrage::Light::directional(direction).map_err(Failure::usage)?;
        return Ok(vec![Light::sun(direction, SUN_LUX)]);
    }
    let lights: Vec<Light> = match args.light[..] {
        [] => scene.lights.clone(),
        _ => args.light.iter().map(|wanted| choose_light(wanted, &scene.lights)).collect::<Outcome<_>>()?,
    };
    match lights.len() {
        0 => Err(Failure::usage("this world has no light; give one with --sun X,Y,Z")),
        1..=umbrage::MAX_LIGHTS => Ok(lights),
        many => Err(Failure::usage(format!(
            "{many} lights are too many, at most {} shine at once; choose with --light",
            umbrage::MAX_LIGHTS
        ))),
    }
}

fn choose_light(wanted: &str, lights: &[Light]) -> Outcome<Light> {
    let by_number = wanted.parse::<usize>().ok().and_then(|number| lights.get(number));
    let light = by_number.or_else(|| lights.iter().find(|light| light.name == wanted));
    light.cloned().ok_or_else(|| {
        let names = lights.iter().enumerate().map(|(i, light)| format!("{i} ({})", light.name));
        Failure::usage(format!("no light `{wanted}`; there are {}", names.collect::<Vec<_>>().join(", ")))
    })
}

fn camera(args: &WorldArgs, scene: &Scene) -> Outcome<Camera> {
    let chosen = choose(args.place.camera.as_deref(), &scene.cameras)?;
    let mut camera = chosen.clone();
    if let (Some(eye), Some(target)) = (args.place.eye, args.place.target) {
        if eye == target {
            return Err(Failure::usage(format!("--eye and --target are the same point, {eye}")));
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
        Failure::usage(format!("no camera `{wanted}`; there are {}", names.collect::<Vec<_>>().join(", ")))
    })
}
