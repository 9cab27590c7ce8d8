//! What the window shows as a link, and a link as what it shows.

use glam::Vec3;
use umbrage_scene::{Camera, Scene};

use super::{Link, is_built_in};
use crate::load::Source;
use crate::moved_lights::MovedLights;
use crate::view_state::{ViewState, is_sun};
use crate::world::World;

/// Places are written as exactly as this share of the distance from the eye to the target.
const EXACT: f32 = 1e-5;

impl Link {
    /// Returns the link of what is shown, and a message where it cannot hold all of it.
    pub fn of(world: &World, view: &ViewState) -> (Self, Option<String>) {
        let scene = &world.scene;
        let (name, load) = match &world.source {
            Source::Named(name) if is_built_in(name) => (Some(name.clone()), None),
            Source::Address(address) => (None, Some(address.clone())),
            Source::Named(_) | Source::Bytes { .. } => (None, None),
        };
        let is_own = name.is_none() && load.is_none();
        let (camera, place) = camera(view, scene);
        let settings =
            if view.compare { view.settings.clone() } else { [0, 0].map(|side| view.settings[side].clone()) };
        let link = Self {
            world: name,
            load,
            camera,
            place,
            seconds: view.seconds,
            animation: animation(view, scene),
            hour: view.hour,
            lights: view.moved_lights.clone(),
            exposure: view.exposure,
            haze: view.haze,
            settings,
            compare: view.compare,
            divider: if view.compare { view.divider } else { 0.5 },
            mode: view.mode,
            lines: view.lines,
            truth: view.truth,
            maps: view.maps,
        };
        let message = "the link was copied without its world, which is a file of yours: whoever follows the link must open that file first";
        (link, is_own.then(|| message.to_owned()))
    }

    /// Shows in a view of a scene what the link says. Returns a message for each part that the scene does not have.
    pub fn apply(&self, view: &mut ViewState, scene: &Scene) -> Vec<String> {
        let mut messages = self.go(view, scene);
        view.animation = self.animation_of(scene, &mut messages);
        (view.seconds, view.playing, view.path, view.frozen_camera) = (self.seconds, false, None, None);
        view.hour = self.hour.filter(|_| scene.lights.iter().any(is_sun));
        if view.hour != self.hour {
            messages.push("`hour` is left out: this world has no sun".to_owned());
        }
        let (known, unknown) = self.lights.iter().partition(|(number, _)| **number < scene.lights.len());
        view.moved_lights = known;
        let unknown: MovedLights = unknown;
        let there = match scene.lights.len() {
            0 => format!("{} has no lights", scene.name),
            lights => format!("the lights of {} are numbered from 0 to {}", scene.name, lights - 1),
        };
        messages.extend(unknown.keys().map(|number| format!("`light.{number}` is left out: {there}")));
        (view.exposure, view.haze) = (self.exposure, self.haze);
        view.settings = self.settings.clone();
        (view.compare, view.edited, view.divider) = (self.compare, 0, self.divider);
        (view.mode, view.lines, view.truth, view.maps) = (self.mode, self.lines, self.truth, self.maps);
        messages
    }

    /// Moves the camera where the link says. Returns a message where the scene does not have it.
    pub fn go(&self, view: &mut ViewState, scene: &Scene) -> Vec<String> {
        let mut messages = Vec::new();
        let chosen = self.camera_of(scene, &mut messages);
        let camera = match (chosen, self.place) {
            (Some(chosen), Some([eye, target])) => {
                let looking = Camera::looking(&chosen.name, eye, target, 1.0, chosen.near, chosen.far);
                Some(Camera { lens: chosen.lens, ..looking })
            }
            (chosen, _) => chosen.cloned(),
        };
        if let Some(camera) = &camera {
            view.go_to(scene, camera);
        }
        if let Some([eye, target]) = self.place {
            view.flight.distance = eye.distance(target);
        }
        messages
    }

    /// The world's camera that it names, or the first.
    fn camera_of<'s>(&self, scene: &'s Scene, messages: &mut Vec<String>) -> Option<&'s Camera> {
        let first = scene.cameras.first();
        let Some(wanted) = &self.camera else { return first };
        let found = scene.cameras.iter().find(|camera| camera.name == *wanted);
        let by_number = || wanted.parse::<usize>().ok().and_then(|number| scene.cameras.get(number));
        found.or_else(by_number).or_else(|| {
            let names: Vec<&str> = scene.cameras.iter().map(|camera| &camera.name[..]).collect();
            let there = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
            messages
                .push(format!("`camera={wanted}` is left out: the cameras of {} are {there}", scene.name));
            first
        })
    }

    fn animation_of(&self, scene: &Scene, messages: &mut Vec<String>) -> Option<usize> {
        let Some(wanted) = &self.animation else { return scene.rig.playing };
        let found = scene.rig.find(wanted);
        if found.is_none() && !wanted.eq_ignore_ascii_case("none") {
            messages.push(format!("`animation={wanted}` is left out: {} has no such animation", scene.name));
            return scene.rig.playing;
        }
        found
    }
}

/// The world's camera that gives the view its lens, and where the view's camera is if that is not its place.
fn camera(view: &ViewState, scene: &Scene) -> (Option<String>, Option<[Vec3; 2]>) {
    let camera = view.camera();
    let is_there = |known: &Camera| known.world_from_camera.abs_diff_eq(camera.world_from_camera, 1e-4);
    let has_lens =
        |known: &Camera| (known.lens, known.near, known.far) == (camera.lens, camera.near, camera.far);
    let position = |is_meant: &dyn Fn(&Camera) -> bool| {
        scene.cameras.iter().position(|known| known.name == camera.name && is_meant(known))
    };
    let first = position(&|_| true);
    let own = position(&|known| has_lens(known) && is_there(known)).or_else(|| position(&has_lens));
    let number = own.or(first).unwrap_or(0);
    // Of several cameras of one name, the name means the first.
    let name = if first == Some(number) { camera.name.clone() } else { number.to_string() };
    let name = Some(name).filter(|_| number != 0);
    if scene.cameras.get(number).is_some_and(is_there) {
        return (name, None);
    }
    let step = 10f32.powf((view.flight.distance * EXACT).log10().floor());
    // Division by a power of ten of 1 or more is what leaves a short number.
    let short = |metres: f32| {
        if step < 1.0 {
            (metres * step.recip().round()).round() / step.recip().round()
        } else {
            metres.round()
        }
    };
    let place =
        [view.flight.eye, view.flight.target()].map(|point| Vec3::from_array(point.to_array().map(short)));
    (name, Some(place))
}

fn animation(view: &ViewState, scene: &Scene) -> Option<String> {
    if view.animation == scene.rig.playing {
        return None;
    }
    let Some(number) = view.animation else { return Some("none".to_owned()) };
    let name = scene.rig.animations.get(number).map_or("", |animation| &animation.name);
    let is_found = scene.rig.find(name) == Some(number);
    Some(if is_found { name.to_owned() } else { number.to_string() })
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use proptest::prelude::*;
    use umbrage::Settings;

    use super::*;

    /// Three numbers of any size, as a link may have them.
    fn numbers() -> impl Strategy<Value = String> {
        let number = || (-9.99..9.99f32, -45..39i32).prop_map(|(share, power)| format!("{share}e{power}"));
        [number(), number(), number()].prop_map(|numbers| numbers.join(","))
    }

    #[test]
    fn of_two_cameras_of_one_name_the_second_is_meant_by_its_number() {
        let mut scene = umbrage_scene::worlds::build("primitives", 0).expect("a built-in world");
        scene.cameras.truncate(2);
        scene.cameras[1].name = scene.cameras[0].name.clone();
        let mut view = ViewState::new(&scene, Settings::default(), None);
        view.go_to(&scene, &scene.cameras[1].clone());
        let world = World::new(Source::Named("primitives".to_owned()), Arc::new(scene));
        assert_eq!(Link::of(&world, &view).0.to_string(), "?world=primitives&camera=1");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]

        #[test]
        fn a_wild_link_that_is_shown_is_written_again_without_numbers_that_are_none(
            places in prop::array::uniform4(numbers()),
            time in (-9.99..9.99f32, -45..39i32).prop_map(|(share, power)| format!("{share}e{power}")),
            is_near in any::<bool>(),
        ) {
            let scene = umbrage_scene::worlds::build("primitives", 0).expect("a built-in world");
            let [eye, target, position, direction] = places;
            let eye = if is_near { "0,0,0".to_owned() } else { eye };
            let text = format!(
                "?eye={eye}&target={target}&light.0.position={position}&light.0.direction={direction}&time={time}"
            );
            let mut view = ViewState::new(&scene, Settings::default(), None);
            Link::parse(&text).0.apply(&mut view, &scene);
            let world = World::new(Source::Named("primitives".to_owned()), Arc::new(scene));
            let written = Link::of(&world, &view).0.to_string();
            prop_assert!(!written.contains("NaN") && !written.contains("inf"), "{} {}", text, written);
            prop_assert_eq!(Link::parse(&written).1, [""; 0], "{}", written);
        }
    }
}
