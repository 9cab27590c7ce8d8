//! Taking things away: files beside the program, or downloads of the browser.

use umbrage::Settings;
use umbrage_render::Picture;
use umbrage_scene::{Camera, Light, Scene};

use crate::edit;

/// What an experiment calls the camera that its world was given by the viewer.
const CAMERA: &str = "viewer";

/// Writes a file whose name begins so, beside others of the kind. Gives where it went.
///
/// # Errors
/// When the system, or the browser, does not let it.
pub fn save(stem: &str, extension: &str, bytes: &[u8]) -> Result<String, String> {
    #[cfg(target_arch = "wasm32")]
    {
        let name = format!("{stem}.{extension}");
        crate::web::download(&name, bytes)?;
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

/// A picture as a PNG file.
///
/// # Errors
/// When it has no pixels.
pub fn png(picture: &Picture) -> Result<Vec<u8>, String> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    let Picture { width, height, rgba } = picture;
    let kind = image::ExtendedColorType::Rgba8;
    image::write_buffer_with_format(&mut bytes, rgba, *width, *height, kind, image::ImageFormat::Png)
        .map_err(|why| why.to_string())?;
    Ok(bytes.into_inner())
}

/// What an experiment of one cell needs.
#[derive(Clone, Debug)]
pub struct Cell<'a> {
    /// The world's name, or the path that it came from.
    pub world: &'a str,
    /// What it is.
    pub scene: &'a Scene,
    /// From where, named as it is in the world.
    pub camera: &'a Camera,
    /// What shines.
    pub lights: &'a [Light],
    /// How shadows are made.
    pub settings: &'a Settings,
    /// Of the picture, pixels.
    pub size: [u32; 2],
}

impl Cell<'_> {
    /// The camera of the world that this one is, but for rounding, where the lights are the world's too: then names say
    /// enough.
    pub fn named(&self) -> Option<&str> {
        let Camera { world_from_camera, lens, near, far, .. } = self.camera;
        let is_same = |other: &&Camera| {
            let is_there = other.world_from_camera.abs_diff_eq(*world_from_camera, 1e-4);
            is_there && (other.lens, other.near, other.far) == (*lens, *near, *far)
        };
        let camera = self.scene.cameras.iter().find(is_same).filter(|_| self.scene.lights == self.lights)?;
        Some(&camera.name)
    }

    /// The world with the camera and the lights, for an experiment that its name does not say enough for.
    ///
    /// # Errors
    /// When the scene contradicts itself.
    pub fn world_file(&self) -> Result<Vec<u8>, String> {
        let camera = Camera { name: CAMERA.to_owned(), ..self.camera.clone() };
        let cameras = std::iter::once(camera).chain(self.scene.cameras.iter().cloned()).collect();
        let scene = Scene { cameras, lights: self.lights.to_vec(), ..self.scene.clone() };
        umbrage_scene::to_glb(&scene).map_err(|why| why.to_string())
    }

    /// The experiment, for `umbrage report`. `world_file` is where the world went, where it has a file of its own.
    ///
    /// # Errors
    /// Never for settings that are valid.
    pub fn experiment(&self, world_file: Option<&str>) -> Result<String, String> {
        let mut set = edit::file(self.settings).map_err(|why| why.to_string())?;
        set = set.replace("[shadows", "[variants.set");
        let (world, camera) = match world_file {
            Some(file) => (file, CAMERA),
            None => (self.world, self.named().unwrap_or(CAMERA)),
        };
        let [width, height] = self.size;
        let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
        Ok(format!(
            "# Run with: umbrage report THIS.toml -o DIR\n\
             title = {title}\nsource = \"this project\"\nreported = \"A cell saved from the viewer.\"\n\
             worlds = [{world}]\ncameras = [{camera}]\nsize = [{width}, {height}]\n\
             columns = [\"error.mis_shadowed\", \"error.false_shadow\", \"error.false_light\", \"error.edge_displacement_px\"]\n\n\
             [[variants]]\nname = \"viewer\"\n\n{set}",
            title = quoted(&format!("{} from the viewer", self.scene.name)),
            world = quoted(world),
            camera = quoted(camera),
        ))
    }
}

#[cfg(test)]
mod tests {
    use umbrage_lab::Experiment;

    use super::*;

    #[test]
    fn a_cell_is_an_experiment_that_the_lab_reads() {
        let scene = umbrage_scene::worlds::build("primitives", 0).expect("a built-in world");
        for preset in umbrage::PRESETS {
            let settings = (preset.settings)();
            // As the viewer has it: taken apart and put together.
            let camera = crate::flight::Flight::at(&scene.cameras[1], 10.0).camera();
            let cell = Cell {
                world: "primitives",
                scene: &scene,
                camera: &camera,
                lights: &scene.lights,
                settings: &settings,
                size: [320, 200],
            };
            assert_eq!(cell.named(), Some(scene.cameras[1].name.as_str()));
            let text = cell.experiment(None).expect("an experiment");
            let folder = tempfile::tempdir().expect("a folder");
            let path = folder.path().join("cell.toml");
            std::fs::write(&path, &text).expect("a file");
            let experiment = Experiment::read(&path).unwrap_or_else(|why| panic!("{why}: {text}"));
            assert_eq!((experiment.worlds, experiment.size), (vec!["primitives".to_owned()], [320, 200]));
            assert_eq!(experiment.ways.len(), 1, "{text}");
        }
    }

    #[test]
    fn a_camera_of_ones_own_goes_along_with_its_world() {
        let scene = umbrage_scene::worlds::build("primitives", 0).expect("a built-in world");
        let mut camera = scene.cameras[0].clone();
        camera.far *= 0.5;
        let cell = Cell {
            world: "primitives",
            scene: &scene,
            camera: &camera,
            lights: &scene.lights,
            settings: &Settings::default(),
            size: [64, 64],
        };
        assert_eq!(cell.named(), None);
        let bytes = cell.world_file().expect("a file");
        let read = umbrage_scene::load_glb_bytes(&bytes, "cell").expect("a world").scene;
        assert_eq!((read.cameras[0].name.as_str(), read.triangles()), ("viewer", scene.triangles()));
    }

    #[test]
    fn a_picture_is_a_png() {
        let picture = Picture { width: 2, height: 1, rgba: vec![1, 2, 3, 255, 4, 5, 6, 255] };
        let bytes = png(&picture).expect("a file");
        assert_eq!(image::load_from_memory(&bytes).expect("a picture").to_rgba8().into_raw(), picture.rgba);
    }
}
