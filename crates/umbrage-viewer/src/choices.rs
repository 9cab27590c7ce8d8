//! What people have chosen: all that the picture depends on, and all that outlives a lost device.

use umbrage::Settings;
use umbrage_render::{MapLook, Mark, Show};
use umbrage_scene::{Camera, Light, LightKind, Scene};

use crate::flight::Flight;
use crate::lines::Chosen;
use crate::sky;

/// What is drawn with shadows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shown {
    /// The world with its shadows.
    #[default]
    Shadows,
    /// The world without.
    Unshadowed,
    /// Something about the maps, on the world's surfaces.
    Marked(Mark),
}

impl Shown {
    /// For the renderer.
    pub fn show(self) -> Show {
        match self {
            Self::Shadows => Show::World,
            Self::Unshadowed => Show::Unshadowed,
            Self::Marked(mark) => Show::Marked(mark),
        }
    }
}

/// All of it.
#[derive(Clone, Debug)]
pub struct Choices {
    /// How shadows are made, left and right.
    pub settings: [Settings; 2],
    /// Whether there is a right side.
    pub compare: bool,
    /// Which side the panel of settings is about.
    pub edited: usize,
    /// Where the right side begins, as a share of the picture's width.
    pub divider: f32,
    /// What is drawn.
    pub shown: Shown,
    /// What of the plan is drawn as lines.
    pub lines: Chosen,
    /// For which camera shadows are planned, where it is frozen.
    pub frozen: Option<Camera>,
    /// Whether it is shown how wrong the picture is.
    pub overlay: bool,
    /// Whether the maps are shown, and how.
    pub maps: bool,
    /// How.
    pub look: MapLook,
    /// The hour of the day, where it is not the world's own sun.
    pub hour: Option<f32>,
    /// When, for things that move, seconds.
    pub seconds: f32,
    /// Whether they move.
    pub playing: bool,
    /// Where on the world's path the camera is, where it is.
    pub path: Option<OnPath>,
    /// Whether edges are smooth: four samples a pixel.
    pub smooth: bool,
    /// From where.
    pub flight: Flight,
    /// Whether there are panels.
    pub panels: bool,
    /// Whether there is the window that says which keys there are.
    pub help: bool,
}

/// Where on a path a camera is. It begins at the start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OnPath {
    /// Share of the path, 0 to 1.
    pub along: f32,
    /// Whether it stays there.
    pub held: bool,
}

impl Choices {
    /// A world as it is first seen.
    pub fn new(scene: &Scene, settings: Settings, camera: Option<&Camera>) -> Self {
        Self {
            settings: [settings.clone(), settings],
            compare: false,
            edited: 0,
            divider: 0.5,
            shown: Shown::Shadows,
            lines: Chosen::default(),
            frozen: None,
            overlay: false,
            maps: false,
            // What is drawn lies within a few hundredths of the range, where all greys are alike.
            look: MapLook { stretch: true, ..MapLook::default() },
            hour: None,
            seconds: 0.0,
            playing: false,
            path: None,
            smooth: true,
            flight: flight(scene, camera),
            panels: true,
            help: false,
        }
    }

    /// The same choices in another world: what belongs to a place is forgotten.
    pub fn moved_to(&mut self, scene: &Scene) {
        let flight = self.flight.moved_to(flight(scene, None));
        *self = Self { flight, frozen: None, hour: None, seconds: 0.0, path: None, ..self.clone() };
    }

    /// The settings of each side.
    pub fn sides(&self) -> &[Settings] {
        &self.settings[..if self.compare { 2 } else { 1 }]
    }

    /// What shines, 16 at most: the world's lights, its sun at the chosen hour.
    pub fn lights(&self, scene: &Scene) -> Vec<Light> {
        let mut lights: Vec<Light> = scene.lights.iter().take(umbrage::MAX_LIGHTS).cloned().collect();
        if let (Some(hour), Some(sun)) = (self.hour, lights.iter_mut().find(|light| is_sun(light))) {
            sun.world_from_light = Light::sun(sky::sunlight(hour), 1.0).world_from_light;
        }
        lights
    }

    /// Whether the camera flies along the path.
    pub fn flies(&self) -> bool {
        self.path.is_some_and(|path| !path.held)
    }

    /// From where the picture is seen.
    pub fn camera(&self) -> Camera {
        self.flight.camera()
    }
}

/// Whether a light is a sun.
pub fn is_sun(light: &Light) -> bool {
    light.kind == LightKind::Directional
}

/// At a camera of a scene, the first where none is given, looking as far as to the middle of the scene.
fn flight(scene: &Scene, camera: Option<&Camera>) -> Flight {
    let bounds = scene.bounds_at(0.0);
    let middle = (bounds.min + bounds.max) * 0.5;
    let fallback = Camera::looking("camera", bounds.max, middle, 1.0, 0.1, 1000.0);
    let camera = camera.or(scene.cameras.first()).unwrap_or(&fallback);
    let size = (bounds.max - bounds.min).max_element().max(1e-3);
    let ahead = (middle - camera.eye()).dot(camera.forward());
    Flight::at(camera, ahead.clamp(0.02 * size, 0.5 * size))
}
