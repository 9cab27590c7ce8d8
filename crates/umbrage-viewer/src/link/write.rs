//! What a link says as keys and values: only what is not as it is by default.

use std::borrow::Cow;

use glam::Vec3;
use umbrage_render::Exposure;

use super::{Link, SHOWS, shadows};
use crate::lines::PlanLines;
use crate::moved_lights::MovedLight;

/// Returns keys and values in the order in which people read them: where, when, how.
pub fn pairs(link: &Link) -> Vec<(Cow<'static, str>, String)> {
    let Exposure { stops, lux } = link.exposure;
    let [eye, target] = [0, 1].map(|i| link.place.map(|place| vec3(place[i])));
    let seconds = (link.seconds != 0.0).then(|| link.seconds.to_string());
    let show = SHOWS.iter().find(|(_, mode)| *mode == link.mode).map(|(name, _)| (*name).to_owned());
    let texts = [
        ("world", link.world.clone()),
        ("load", link.load.clone()),
        ("camera", link.camera.clone()),
        ("eye", eye),
        ("target", target),
        ("time", seconds),
        ("animation", link.animation.clone()),
        ("hour", link.hour.map(|hour| hour.to_string())),
        ("exposure", (stops != 0.0).then(|| stops.to_string())),
        ("exposed-for", lux.map(|lux| lux.to_string())),
    ];
    let mut pairs: Vec<(Cow<'static, str>, String)> =
        texts.into_iter().filter_map(|(key, value)| Some((key.into(), value?))).collect();
    pairs.extend(link.lights.iter().flat_map(lights));
    pairs.extend((!link.haze).then(|| ("no-haze".into(), String::new())));
    pairs.extend(sides(link));
    pairs.extend(show.filter(|_| link.mode != SHOWS[0].1).map(|name| ("show".into(), name)));
    pairs.extend(link.lines.any().then(|| ("lines".into(), lines(link.lines))));
    pairs.extend(link.truth.then(|| ("truth".into(), String::new())));
    pairs.extend(link.maps.then(|| ("maps".into(), String::new())));
    pairs
}

/// The settings of the sides that are shown, and where they part.
fn sides(link: &Link) -> Vec<(Cow<'static, str>, String)> {
    let left = shadows::Words::of(&link.settings[0]);
    let mut pairs: Vec<(Cow<'static, str>, String)> = left
        .preset
        .filter(|name| name != "default")
        .map(|name| ("preset".into(), name))
        .into_iter()
        .collect();
    pairs.extend(left.sets.into_iter().map(|set| ("set".into(), set)));
    if link.compare {
        let right = shadows::Words::of(&link.settings[1]);
        // It is what says that there are two sides.
        pairs.extend(right.preset.map(|name| ("right.preset".into(), name)));
        pairs.extend(right.sets.into_iter().map(|set| ("right.set".into(), set)));
        pairs.extend((link.divider != 0.5).then(|| ("divider".into(), link.divider.to_string())));
    }
    pairs
}

/// What was moved of a light.
fn lights((number, moved): (&usize, &MovedLight)) -> Vec<(Cow<'static, str>, String)> {
    let pair = |part: &str, value: Option<Vec3>| {
        value.map(|value| (format!("light.{number}.{part}").into(), vec3(value)))
    };
    pair("position", moved.position).into_iter().chain(pair("direction", moved.direction)).collect()
}

fn lines(PlanLines { slices, maps, casters }: PlanLines) -> String {
    let names = [(slices, "slices"), (maps, "maps"), (casters, "casters")];
    names.into_iter().filter_map(|(on, name)| on.then_some(name)).collect::<Vec<_>>().join(",")
}

/// A place as text; −0 is 0.
fn vec3(place: Vec3) -> String {
    let Vec3 { x, y, z } = place + Vec3::ZERO;
    format!("{x},{y},{z}")
}
