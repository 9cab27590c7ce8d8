//! What the picture depends on beside the world: camera, time, settings and what is drawn. It outlives a lost device.

use std::sync::Arc;

use umbrage::Settings;
use umbrage_render::{Exposure, Frame, MapLook, Mark, RenderError, Show};
use umbrage_scene::{Camera, Light, LightKind, Pose, Scene, Shining};

use crate::flight::Flight;
use crate::lines::PlanLines;
use crate::moved_lights::{MovedLight, MovedLights};
use crate::sky;

/// What the picture shows of the world's surfaces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PictureMode {
    /// The world with its shadows.
    #[default]
    Shadows,
    /// The world without shadows.
    Unshadowed,
    /// The world with a property of its shadow maps drawn onto it.
    Marked(Mark),
}

impl PictureMode {
    /// Returns the renderer's word for it.
    pub fn show(self) -> Show {
        match self {
            Self::Shadows => Show::World,
            Self::Unshadowed => Show::Unshadowed,
            Self::Marked(mark) => Show::Marked(mark),
        }
    }
}

/// The state of the view: everything that widgets, keys and the pointer change.
#[derive(Clone, Debug)]
pub struct ViewState {
    /// Shadow settings of the left and of the right side.
    pub settings: [Settings; 2],
    /// Whether two sides are compared; the left one is shown alone where not.
    pub compare: bool,
    /// The side that the panel of settings edits: 0 is the left one, 1 the right one.
    pub edited: usize,
    /// Where the right side begins, as a share of the picture's width, 0 to 1.
    pub divider: f32,
    /// What the picture shows.
    pub mode: PictureMode,
    /// Which parts of the shadow plan are drawn as lines.
    pub lines: PlanLines,
    /// The camera that shadows stay planned for; the picture's own where absent.
    pub frozen_camera: Option<Camera>,
    /// Whether the picture is compared with ray-traced ground truth.
    pub truth: bool,
    /// Whether the window of shadow maps is open.
    pub maps: bool,
    /// How the shadow maps are shown.
    pub map_look: MapLook,
    /// The hour of the day that places the sun, local solar time; the world's own sun where absent.
    pub hour: Option<f32>,
    /// The lights that were moved.
    pub moved_lights: MovedLights,
    /// Whether lights have handles in the picture.
    pub handles: bool,
    /// Time of the animation, seconds from its start.
    pub seconds: f32,
    /// The index of the world's animation that is shown; absent where everything stands as it is at rest.
    pub animation: Option<usize>,
    /// Whether time goes on.
    pub playing: bool,
    /// The camera's position on the world's path; absent where it flies freely.
    pub path: Option<PathPosition>,
    /// Whether a pixel has four samples (MSAA) instead of one.
    pub multisampled: bool,
    /// How bright the picture is.
    pub exposure: Exposure,
    /// Whether haze takes colour from what is far.
    pub haze: bool,
    /// The camera, and how it answers the pointer.
    pub flight: Flight,
    /// Whether the panels are shown.
    pub panels: bool,
    /// Whether the window that lists the keys is open.
    pub help: bool,
    /// Whether a click on the picture asks why its shadow is as it is there.
    pub asks: bool,
}

/// A position on a camera path. The default is its start, in motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PathPosition {
    /// The share of the path that lies behind the camera, 0 to 1.
    pub along: f32,
    /// Whether the camera stays there.
    pub held: bool,
}

impl ViewState {
    /// Returns the view of a world that is shown for the first time, from `camera` or the world's first one.
    pub fn new(scene: &Scene, settings: Settings, camera: Option<&Camera>) -> Self {
        Self {
            settings: [settings.clone(), settings],
            compare: false,
            edited: 0,
            divider: 0.5,
            mode: PictureMode::Shadows,
            lines: PlanLines::default(),
            frozen_camera: None,
            truth: false,
            maps: false,
            // What is drawn lies within a few hundredths of the range, where all greys are alike.
            map_look: MapLook { stretch: true, ..MapLook::default() },
            hour: None,
            moved_lights: MovedLights::new(),
            handles: false,
            seconds: 0.0,
            animation: scene.rig.playing,
            playing: false,
            path: None,
            multisampled: true,
            exposure: Exposure::default(),
            haze: true,
            flight: flight_at(scene, camera),
            panels: true,
            help: false,
            asks: false,
        }
    }

    /// Returns the same view of another world: what belongs to a place or a time starts anew.
    #[must_use]
    pub fn moved_to(&self, scene: &Scene) -> Self {
        let flight = self.flight.moved_to(flight_at(scene, None));
        // What one world's light is exposed for is night or noon in another.
        let exposure = Exposure { lux: None, ..self.exposure };
        Self {
            flight,
            exposure,
            frozen_camera: None,
            hour: None,
            moved_lights: MovedLights::new(),
            seconds: 0.0,
            animation: scene.rig.playing,
            path: None,
            ..self.clone()
        }
    }

    /// Moves to a camera of the scene, and leaves the path.
    pub fn go_to(&mut self, scene: &Scene, camera: &Camera) {
        self.flight = self.flight.moved_to(flight_at(scene, Some(camera)));
        self.path = None;
    }

    /// Returns the settings of each side that is shown: one, or two.
    pub fn sides(&self) -> &[Settings] {
        &self.settings[..if self.compare { 2 } else { 1 }]
    }

    /// Returns the settings that the panel edits.
    pub fn edited_settings(&self) -> &Settings {
        &self.settings[self.edited]
    }

    /// Returns how the world stands at the time that is shown.
    pub fn pose(&self, scene: &Scene) -> Pose {
        scene.rig.pose_of(self.animation, self.seconds)
    }

    /// Returns which of the world's lights shine, at most [`umbrage::MAX_LIGHTS`], and what is to be said about the others.
    pub fn shining(&self, scene: &Scene) -> Shining {
        Shining::choose(&self.all_lights(scene), &self.camera(), &self.pose(scene), umbrage::MAX_LIGHTS)
    }

    /// All lights of the world, as they were moved, and its first sun where the chosen hour puts it.
    fn all_lights(&self, scene: &Scene) -> Vec<Light> {
        let pose = self.pose(scene);
        let moved = |(number, light): (usize, &Light)| match self.moved_lights.get(&number) {
            Some(moved) => moved.of(light, &pose),
            None => light.clone(),
        };
        let mut lights: Vec<Light> = scene.lights.iter().enumerate().map(moved).collect();
        let shines =
            |light: &&mut Light| is_sun(light) && light.intensity > 0.0 && light.is_visible_in(&pose);
        if let (Some(hour), Some(sun)) = (self.hour, lights.iter_mut().find(shines)) {
            *sun = MovedLight { position: None, direction: Some(sky::sunlight(hour)) }.of(sun, &pose);
        }
        lights
    }

    /// Returns the lights that shine.
    pub fn lights(&self, scene: &Scene) -> Vec<Light> {
        self.shining(scene).lights
    }

    /// Returns the lights that shine as they stand at the time that is shown, with their numbers in the scene.
    pub fn numbered_lights(&self, scene: &Scene) -> Vec<(usize, Light)> {
        let pose = self.pose(scene);
        // They are in the order of the scene.
        let mut shining = self.shining(scene).lights.into_iter().peekable();
        let mut all: Vec<(usize, Light)> = self.all_lights(scene).into_iter().enumerate().collect();
        all.retain(|(_, light)| shining.next_if_eq(light).is_some());
        all.into_iter().map(|(number, light)| (number, MovedLight::default().of(&light, &pose))).collect()
    }

    /// Returns whether the camera moves along the path.
    pub fn follows_path(&self) -> bool {
        self.path.is_some_and(|path| !path.held)
    }

    /// Returns whether the picture is compared with ground truth now. A picture planned for another camera is not.
    pub fn compares_with_truth(&self) -> bool {
        self.truth && self.frozen_camera.is_none()
    }

    /// Returns the camera that the picture is seen from.
    pub fn camera(&self) -> Camera {
        self.flight.camera()
    }

    /// Returns the frame that the renderer draws for a picture of `width` by `height` pixels, shaded with shadows whatever
    /// [`Self::mode`] is.
    ///
    /// # Errors
    /// When a camera or a light cannot be one of the renderer's.
    pub fn frame(&self, scene: &Scene, [width, height]: [u32; 2]) -> Result<Frame, RenderError> {
        let lights = self.lights(scene);
        let frame =
            Frame::of(&self.camera(), &lights, &Arc::new(self.pose(scene)), [width, height], Show::World)?;
        let frozen = self.frozen_camera.as_ref();
        let planned_for =
            frozen.map(|camera| umbrage_render::camera(camera, width as f32 / height as f32)).transpose()?;
        let samples = if self.multisampled { 4 } else { 1 };
        Ok(Frame { planned_for, samples, exposure: self.exposure, haze: self.haze, ..frame })
    }
}

/// Returns whether a light is directional.
pub fn is_sun(light: &Light) -> bool {
    light.kind == LightKind::Directional
}

/// A flight that starts at a camera, the scene's first where none is given, and looks as far as the scene's middle.
fn flight_at(scene: &Scene, camera: Option<&Camera>) -> Flight {
    let bounds = scene.bounds_in(&scene.pose(0.0));
    let middle = (bounds.min + bounds.max) * 0.5;
    let fallback = Camera::looking("camera", bounds.max, middle, 1.0, 0.1, 1000.0);
    let camera = camera.or(scene.cameras.first()).unwrap_or(&fallback);
    let size = (bounds.max - bounds.min).max_element().max(1e-3);
    let ahead = (middle - camera.eye()).dot(camera.forward());
    Flight::at(camera, ahead.clamp(0.02 * size, 0.5 * size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_many_lights_the_brightest_at_the_camera_shine_and_the_others_are_named() {
        let mut scene = umbrage_scene::worlds::build("primitives", 0).expect("a built-in world");
        let eye = scene.cameras[0].eye();
        let lamp =
            |i: u8| Light::point(&format!("lamp {i}"), eye + glam::Vec3::Y * f32::from(i + 1), 50.0, 9.0);
        scene.lights = (0..20).rev().map(lamp).collect();
        let view = ViewState::new(&scene, Settings::default(), None);
        let names: Vec<String> = view.lights(&scene).into_iter().map(|light| light.name).collect();
        assert_eq!(names, (0..16).rev().map(|i| format!("lamp {i}")).collect::<Vec<_>>());
        let warnings = view.shining(&scene).warnings;
        assert!(warnings.len() == 1 && warnings[0].contains("\"lamp 16\""), "{warnings:?}");
        let numbers: Vec<usize> =
            view.numbered_lights(&scene).into_iter().map(|(number, _)| number).collect();
        assert_eq!(numbers, (4..20).collect::<Vec<_>>(), "handles are of those that shine");
    }

    #[test]
    fn numbered_lights_are_where_the_hour_and_the_time_put_them() {
        let mut scene = umbrage_scene::worlds::build("primitives", 0).expect("a built-in world");
        let centre = glam::Vec3::new(0.0, 3.0, 0.0);
        let lamp = Light::point("lamp", centre + glam::Vec3::X, 50.0, 9.0);
        let motion = umbrage_scene::Motion::Rotation { centre, axis: glam::Vec3::Y, radians_per_second: 1.0 };
        scene.lights.push(Light { motion, ..lamp });
        let number = scene.lights.len() - 1;
        let mut view = ViewState::new(&scene, Settings::default(), None);
        (view.hour, view.seconds) = (Some(9.0), std::f32::consts::PI);
        let lights = view.numbered_lights(&scene);
        let sun = lights.iter().find(|(_, light)| is_sun(light)).expect("a sun");
        assert!(sun.1.direction().abs_diff_eq(sky::sunlight(9.0).normalize_or_zero(), 1e-5), "{:?}", sun.1);
        let (_, lamp) = lights.iter().find(|(i, _)| *i == number).expect("a point light");
        assert!(lamp.position().abs_diff_eq(centre - glam::Vec3::X, 1e-4), "{}", lamp.position());
    }
}
