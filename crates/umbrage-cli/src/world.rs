//! Worlds, cameras and lights from the command line.

use std::sync::Arc;

use umbrage_lab::{LabError, Shot};
use umbrage_render::{Frame, Show};
use umbrage_scene::{
    Camera, Environment, Lens, Light, Motion, NoSuchName, Pose, Scene, Shining, load_environment,
};

use crate::args::{CastArgs, LookArgs, TimeArgs, WorldArgs};
use crate::failure::{Failure, Outcome};

/// A built-in world, or one from a file. What the file's importer warns of goes to stderr.
pub fn load(name: &str, seed: u64) -> Outcome<Scene> {
    let imported = umbrage_lab::files::load_world(name, seed).map_err(|why| match why {
        LabError::World { .. } => Failure::usage(why),
        why => Failure::Work(why.into()),
    })?;
    warn(&imported.warnings);
    Ok(imported.scene)
}

/// The world that the command line names, in which casts shadows what it wants to.
pub fn open(args: &WorldArgs) -> Outcome<Scene> {
    let mut scene = match &args.scene {
        Some(scene) => Scene::clone(scene),
        None => load(&args.world, args.seed)?,
    };
    let_cast(&mut scene, &args.casting)?;
    play(&mut scene, &args.when)?;
    Ok(scene)
}

/// Lets the animation play that the command line wants, and suns go around where it wants that.
pub fn play(scene: &mut Scene, when: &TimeArgs) -> Outcome {
    if let Some(seconds) = when.day {
        scene.let_suns_go_around(seconds);
    }
    let Some(wanted) = &when.animation else {
        return Ok(());
    };
    if scene.rig.play(wanted) {
        return Ok(());
    }
    let names = scene.rig.animations.iter().map(|animation| animation.name.as_str());
    let there = if names.len() > 0 {
        format!("there are {}, or none", listed(names))
    } else {
        "there is none here".to_owned()
    };
    Err(Failure::usage(format!("no animation `{wanted}`; {there}")))
}

/// Takes the pose of a scene that the command line asks for.
pub fn pose(scene: &Scene, when: &TimeArgs) -> Outcome<Pose> {
    if when.time.is_finite() {
        Ok(scene.pose(when.time))
    } else {
        Err(Failure::usage(format!("--time must be finite, got {} s", when.time)))
    }
}

/// Lets cast shadows what the command line wants to, and nothing that it does not.
pub fn let_cast(scene: &mut Scene, CastArgs { no_cast, cast }: &CastArgs) -> Outcome {
    let wanted = cast.iter().map(|name| (name, true)).chain(no_cast.iter().map(|name| (name, false)));
    for (name, casts) in wanted {
        scene.set_casts(name, casts).map_err(|NoSuchName { wanted, near }| {
            let near = if near.is_empty() { "nothing here has a name".to_owned() } else { near.join(", ") };
            Failure::usage(format!("no node, mesh or material is called `{wanted}`; most like it: {near}"))
        })?;
    }
    Ok(())
}

/// Says on stderr what one would want to know.
pub fn warn(warnings: &[String]) {
    for warning in warnings {
        eprintln!("warning: {warning}");
    }
}

/// The same as [`open`], with what the command line says lies around it.
pub fn open_with(args: &WorldArgs, look: &LookArgs) -> Outcome<Scene> {
    let environment = environment(look)?;
    Ok(Scene { environment, ..open(args)? })
}

/// What the command line says lies around a world.
pub fn environment(look: &LookArgs) -> Outcome<Option<Environment>> {
    look.environment.as_deref().map(load_environment).transpose().map_err(Failure::usage)
}

/// As bright as the sun of the built-in worlds, lux.
const SUN_LUX: f32 = 3.0;

/// Size of a picture where the command line does not say, pixels.
pub const PICTURE: (u32, u32) = (1280, 720);

/// What a shot shows, drawn for people.
pub fn frame(shot: &Shot, show: Show) -> Outcome<Frame> {
    Ok(Frame { samples: 4, ..shot.frame(show).map_err(Failure::usage)? })
}

/// What the command line wants a picture of, `size` pixels large where it does not say. Lights that are left out are named
/// on stderr.
pub fn shot(args: &WorldArgs, scene: &Scene, size: (u32, u32)) -> Outcome<Shot> {
    let (width, height) = args.size.unwrap_or(size);
    let camera = camera(args, scene)?;
    let pose = Arc::new(pose(scene, &args.when)?);
    let lights = lights(args, scene, &camera, &pose)?;
    let shot = Shot { camera, lights, pose, width, height };
    // Whatever cannot be drawn is refused here, before any work is done.
    shot.frame(Show::World).map_err(Failure::usage)?;
    Ok(shot)
}

/// The lights that shine: a sun from the command line, or those of the world that it names, or all of them; the brightest
/// where they are too many.
fn lights(args: &WorldArgs, scene: &Scene, camera: &Camera, pose: &Pose) -> Outcome<Vec<Light>> {
    if let Some(direction) = args.sun {
        // It is refused here, by the words that were given.
        umbrage::Light::directional(direction).map_err(Failure::usage)?;
        let motion = args.when.day.map_or(Motion::Still, Motion::of_sun);
        return Ok(vec![Light { motion, ..Light::sun(direction, SUN_LUX) }]);
    }
    let wanted: Vec<&Light> = match args.light[..] {
        [] => scene.lights.iter().collect(),
        _ => args.light.iter().map(|wanted| choose_light(wanted, &scene.lights)).collect::<Outcome<_>>()?,
    };
    let Shining { mut lights, warnings } = Shining::choose(wanted, camera, pose, umbrage::MAX_LIGHTS);
    if lights.is_empty() {
        return Err(Failure::usage("this world has no light; give one with --sun X,Y,Z"));
    }
    warn(&warnings);
    for light in &mut lights {
        light.near = args.near_light.unwrap_or(light.near);
    }
    Ok(lights)
}

fn choose_light<'a>(wanted: &str, lights: &'a [Light]) -> Outcome<&'a Light> {
    let by_number = wanted.parse::<usize>().ok().and_then(|number| lights.get(number));
    let light = by_number.or_else(|| lights.iter().find(|light| light.name == wanted));
    light.ok_or_else(|| {
        let names = lights.iter().map(|light| light.name.as_str());
        Failure::usage(format!("no light `{wanted}`; there are {}", listed(names)))
    })
}

/// Names with their numbers, the first few of them.
fn listed<'a>(names: impl ExactSizeIterator<Item = &'a str>) -> String {
    /// As many as fill a few lines.
    const LISTED: usize = 32;
    let more = names.len().saturating_sub(LISTED);
    let listed: Vec<String> =
        names.take(LISTED).enumerate().map(|(i, name)| format!("{i} ({name})")).collect();
    let listed = listed.join(", ");
    if more > 0 { format!("{listed} and {more} more") } else { listed }
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
        let names = cameras.iter().map(|camera| camera.name.as_str());
        Failure::usage(format!("no camera `{wanted}`; there are {}", listed(names)))
    })
}
