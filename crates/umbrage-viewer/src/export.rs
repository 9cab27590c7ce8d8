//! Pictures and experiments as files: beside the program, or as downloads of the browser.

use umbrage::Settings;
use umbrage_render::Picture;
use umbrage_scene::{Camera, Light, Pose, Scene};

use crate::edit;
use crate::load::Source;
use crate::view_state::ViewState;
use crate::world::World;

/// The name of the viewer's camera in the world of an experiment.
const CAMERA: &str = "viewer";

/// Saves a picture as a PNG file of a name without its extension, and returns where.
///
/// # Errors
/// When it has no pixels, or the file cannot be written.
pub fn save_picture(name: &str, picture: &Picture) -> Result<String, String> {
    save(&file_stem(name), "png", &png(picture)?)
}

/// The most pixels of a picture that is drawn to be saved: those of 7680 x 4320. With four samples each, and maps beside
/// them, they need about 2 GiB on the device.
const MOST_PIXELS: u64 = 7680 * 4320;

/// Checks the size of a picture before it is drawn to be saved.
///
/// # Errors
/// When it has more pixels than 7680 x 4320.
pub fn check_size([width, height]: [u32; 2]) -> Result<(), String> {
    let pixels = u64::from(width) * u64::from(height);
    if pixels <= MOST_PIXELS {
        return Ok(());
    }
    Err(format!(
        "{width} x {height} are {pixels} pixels, and a picture may have {MOST_PIXELS} at most, as 7680 x 4320; choose a smaller size"
    ))
}

/// A name as that of a file: without its extension, and not a path; `umbrage` where nothing is left.
fn file_stem(name: &str) -> String {
    let name = name.trim();
    let parts = name.len().checked_sub(4).and_then(|at| name.split_at_checked(at));
    let stem = match parts {
        Some((stem, extension)) if extension.eq_ignore_ascii_case(".png") => stem,
        _ => name,
    };
    let plain = |c: char| if c.is_control() || "/\\:*?\"<>|".contains(c) { '-' } else { c };
    let stem = stem.trim_start_matches('.');
    // File systems count bytes: most take 255.
    let stem: String = stem[..stem.floor_char_boundary(200)].chars().map(plain).collect();
    if stem.is_empty() { "umbrage".to_owned() } else { stem }
}

/// Saves an experiment of what the view shows, and a copy of the world where its name does not say enough: experiments are of
/// the start of time, so at any other the copy is a world that stands still as it does then. Returns where the experiment
/// is.
///
/// # Errors
/// When a file cannot be written.
pub fn save_experiment(world: &World, view: &ViewState) -> Result<String, String> {
    let is_at_start = view.seconds == 0.0 && view.animation == world.scene.rig.playing;
    let (camera, lights) = (view.camera(), view.lights(&world.scene));
    let experiment = Experiment {
        world: world.source.name(),
        scene: &world.scene,
        pose: (!is_at_start).then(|| view.pose(&world.scene)),
        camera: &camera,
        lights: &lights,
        settings: view.edited_settings(),
        size: [640, 360],
    };
    let has_name = matches!(world.source, Source::Named(_));
    let file = if experiment.camera_name().is_some() && has_name {
        None
    } else {
        Some(save("umbrage-experiment", "glb", &experiment.world_file()?)?)
    };
    save("umbrage-experiment", "toml", experiment.text(file.as_deref())?.as_bytes())
}

/// Writes a file whose name starts with `stem`, beside others of the kind, and returns where.
fn save(stem: &str, extension: &str, bytes: &[u8]) -> Result<String, String> {
    #[cfg(target_arch = "wasm32")]
    {
        let name = format!("{stem}.{extension}");
        crate::browser::download(&name, bytes)?;
        Ok(name)
    }
    #[cfg(not(target_arch = "wasm32"))]
    {
        let name =
            |i: u32| if i == 1 { format!("{stem}.{extension}") } else { format!("{stem}-{i}.{extension}") };
        let free = (1..10_000).map(name).find(|name| !std::path::Path::new(name).exists());
        let path = std::path::PathBuf::from(free.ok_or("there are too many such files here already")?);
        umbrage_lab::files::write(&path, bytes).map_err(|why| why.to_string())?;
        Ok(path.canonicalize().unwrap_or(path).display().to_string())
    }
}

fn png(picture: &Picture) -> Result<Vec<u8>, String> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    let Picture { width, height, rgba } = picture;
    let kind = image::ExtendedColorType::Rgba8;
    image::write_buffer_with_format(&mut bytes, rgba, *width, *height, kind, image::ImageFormat::Png)
        .map_err(|why| why.to_string())?;
    Ok(bytes.into_inner())
}

/// An experiment of one picture.
#[derive(Clone, Debug)]
struct Experiment<'a> {
    /// The world's name, or the path that it came from.
    world: &'a str,
    scene: &'a Scene,
    /// How the world stands, where that is not as it is at the start of time.
    pose: Option<Pose>,
    camera: &'a Camera,
    lights: &'a [Light],
    settings: &'a Settings,
    /// Size of the picture, pixels.
    size: [u32; 2],
}

impl Experiment<'_> {
    /// The name of the world's camera that this one is but for rounding; `None` where it is none of them, or the lights are
    /// not the world's, or it has moved.
    fn camera_name(&self) -> Option<&str> {
        if self.pose.is_some() {
            return None;
        }
        let Camera { world_from_camera, lens, near, far, .. } = self.camera;
        let is_same = |other: &&Camera| {
            let is_there = other.world_from_camera.abs_diff_eq(*world_from_camera, 1e-4);
            is_there && (other.lens, other.near, other.far) == (*lens, *near, *far)
        };
        let camera = self.scene.cameras.iter().find(is_same).filter(|_| self.scene.lights == self.lights)?;
        Some(&camera.name)
    }

    /// The world with the camera and the lights, as a GLB file.
    fn world_file(&self) -> Result<Vec<u8>, String> {
        let camera = Camera { name: CAMERA.to_owned(), ..self.camera.clone() };
        let cameras = std::iter::once(camera).chain(self.scene.cameras.iter().cloned()).collect();
        let scene = Scene { cameras, lights: self.lights.to_vec(), ..self.scene.clone() };
        let scene = self.pose.as_ref().map_or_else(|| scene.clone(), |pose| scene.baked(pose));
        umbrage_scene::to_glb(&scene).map_err(|why| why.to_string())
    }

    /// The experiment as `umbrage report` reads it. `world_file` is where the world was saved, where it was.
    fn text(&self, world_file: Option<&str>) -> Result<String, String> {
        let mut set = edit::file(self.settings).map_err(|why| why.to_string())?;
        set = set.replace("[shadows", "[variants.set");
        let (world, camera) = match world_file {
            Some(file) => (file, CAMERA),
            None => (self.world, self.camera_name().unwrap_or(CAMERA)),
        };
        let [width, height] = self.size;
        let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
        Ok(format!(
            "# Run with: umbrage report THIS.toml -o DIR\n\
             title = {title}\nsource = \"this project\"\nreported = \"A picture saved from the viewer.\"\n\
             worlds = [{world}]\ncameras = [{camera}]\nsize = [{width}, {height}]\n\
             columns = [\"error.mis_shadowed\", \"error.mae\", \"error.false_shadow\", \"error.false_light\", \"error.edge_displacement_px\"]\n\n\
             [[variants]]\nname = \"viewer\"\n\n{set}",
            title = quoted(&format!("{} from the viewer", self.scene.name)),
            world = quoted(world),
            camera = quoted(camera),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_experiment_is_one_that_the_lab_reads() {
        let scene = umbrage_scene::worlds::build("primitives", 0).expect("a built-in world");
        for preset in umbrage::PRESETS {
            let settings = (preset.settings)();
            // As the viewer has it: taken apart and put together.
            let camera = crate::flight::Flight::at(&scene.cameras[1], 10.0).camera();
            let experiment = Experiment {
                world: "primitives",
                scene: &scene,
                pose: None,
                camera: &camera,
                lights: &scene.lights,
                settings: &settings,
                size: [320, 200],
            };
            assert_eq!(experiment.camera_name(), Some(scene.cameras[1].name.as_str()));
            let text = experiment.text(None).expect("an experiment");
            let folder = tempfile::tempdir().expect("a folder");
            let path = folder.path().join("experiment.toml");
            std::fs::write(&path, &text).expect("a file");
            let read = umbrage_lab::Experiment::read(&path).unwrap_or_else(|why| panic!("{why}: {text}"));
            assert_eq!((read.worlds, read.size), (vec!["primitives".to_owned()], [320, 200]));
            assert_eq!(read.variants.len(), 1, "{text}");
        }
    }

    #[test]
    fn a_camera_of_ones_own_goes_along_with_its_world() {
        let scene = umbrage_scene::worlds::build("primitives", 0).expect("a built-in world");
        let mut camera = scene.cameras[0].clone();
        camera.far *= 0.5;
        let experiment = Experiment {
            world: "primitives",
            scene: &scene,
            pose: None,
            camera: &camera,
            lights: &scene.lights,
            settings: &Settings::default(),
            size: [64, 64],
        };
        assert_eq!(experiment.camera_name(), None);
        let bytes = experiment.world_file().expect("a file");
        let read = umbrage_scene::load_glb_bytes(&bytes, "experiment").expect("a world").scene;
        assert_eq!((read.cameras[0].name.as_str(), read.triangles()), ("viewer", scene.triangles()));
    }

    #[test]
    fn a_world_that_has_moved_goes_along_as_it_stands() {
        let mut scene = umbrage_scene::worlds::build("night-chessboard", 0).expect("a built-in world");
        let axis = glam::Vec3::Y;
        scene.instances[0].motion =
            umbrage_scene::Motion::Rotation { centre: glam::Vec3::ZERO, axis, radians_per_second: 1.0 };
        let pose = scene.pose(1.5);
        let want = scene.instances[0].world_from_mesh_in(&pose);
        let (camera, lights) = (scene.cameras[0].clone(), scene.lights.clone());
        let experiment = Experiment {
            world: "night-chessboard",
            scene: &scene,
            pose: Some(pose),
            camera: &camera,
            lights: &lights,
            settings: &Settings::default(),
            size: [64, 64],
        };
        assert_eq!(experiment.camera_name(), None);
        let bytes = experiment.world_file().expect("a file");
        let read = umbrage_scene::load_glb_bytes(&bytes, "experiment").expect("a world").scene;
        assert_eq!(read.instances[0].world_from_mesh_in(&read.pose(9.0)), want, "it stands still");
    }

    #[test]
    fn a_name_becomes_that_of_a_file_in_this_folder() {
        for (name, stem) in [
            ("", "umbrage"),
            (" knights.png ", "knights"),
            ("../../etc/x", "-..-etc-x"),
            ("a:b?", "a-b-"),
            (".png", "umbrage"),
            ("knights.PNG", "knights"),
            ("é.pn", "é.pn"),
        ] {
            assert_eq!(file_stem(name), stem, "{name}");
        }
        assert_eq!(file_stem(&"影".repeat(100)), "影".repeat(66), "as many bytes as file systems take");
    }

    #[test]
    fn a_picture_that_is_too_large_is_refused_with_its_size() {
        assert_eq!(check_size([7680, 4320]), Ok(()));
        let why = check_size([16384, 16384]).expect_err("too large");
        assert!(why.contains("16384 x 16384 are 268435456 pixels"), "{why}");
        assert!(check_size([u32::MAX, u32::MAX]).is_err());
    }

    #[test]
    fn a_picture_is_a_png() {
        let picture = Picture { width: 2, height: 1, rgba: vec![1, 2, 3, 255, 4, 5, 6, 255] };
        let bytes = png(&picture).expect("a file");
        assert_eq!(image::load_from_memory(&bytes).expect("a picture").to_rgba8().into_raw(), picture.rgba);
    }
}
