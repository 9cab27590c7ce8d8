//! A link's text as what it says, and messages about what could not be read.

use std::ops::RangeInclusive;

use glam::Vec3;
use umbrage_scene::worlds;

use super::{KEYS, Link, SHOWS, is_built_in, query, shadows};
use crate::lines::PlanLines;
use crate::moved_lights::MovedLights;
use crate::sky;

/// No place lies farther from the middle of the world than this along an axis, metres: squares of lengths stay numbers.
const FARTHEST: f32 = 1e12;

/// The camera looks at least so far, metres; nearer targets are its own place.
const NEAREST: f32 = 1e-6;

/// More messages about one link than this are only counted.
const MOST_MESSAGES: usize = 20;

/// A link that is being read.
#[derive(Default)]
struct Reader {
    link: Link,
    eye: Option<Vec3>,
    target: Option<Vec3>,
    /// Preset and settings of the left and of the right side.
    sides: [shadows::Words; 2],
    messages: Vec<String>,
}

/// Reads a link, and says what it has left out.
pub fn read(text: &str) -> (Link, Vec<String>) {
    let mut reader = Reader::default();
    for (key, value) in query::split(text) {
        if let Err(wanted) = reader.take(&key, &value) {
            let pair = if value.is_empty() { key } else { format!("{key}={value}") };
            reader.messages.push(one_line(&format!("`{pair}` is left out: {wanted}")));
        }
    }
    reader.end()
}

impl Reader {
    /// Takes a key and its value, or says what was wanted instead.
    fn take(&mut self, key: &str, value: &str) -> Result<(), String> {
        let link = &mut self.link;
        let text = || (!value.is_empty()).then(|| value.to_owned());
        match key {
            "world" => link.world = Some(world(value)?),
            "load" => link.load = text(),
            "camera" => link.camera = text(),
            "eye" => self.eye = Some(vec3(value)?),
            "target" => self.target = Some(vec3(value)?),
            "time" => {
                link.seconds = number(value, -1e6..=1e6).ok_or("wanted seconds, from -1000000 to 1000000")?;
            }
            "animation" => link.animation = text(),
            "hour" => link.hour = Some(hour(value)?),
            "exposure" => {
                link.exposure.stops =
                    number(value, -100.0..=100.0).ok_or("wanted stops, from -100 to 100")?;
            }
            "exposed-for" => {
                let lux = number(value, 1e-6..=1e9).ok_or("wanted lux, from 0.000001 to 1000000000")?;
                link.exposure.lux = Some(lux);
            }
            "no-haze" => link.haze = !switch(value)?,
            "preset" => self.sides[0].preset = text(),
            "set" => self.sides[0].sets.push(value.to_owned()),
            "right.preset" => self.right().preset = text(),
            "right.set" => self.right().sets.push(value.to_owned()),
            "divider" => {
                link.divider = number(value, 0.02..=0.98).ok_or("wanted a share from 0.02 to 0.98")?;
            }
            "show" => link.mode = show(value)?,
            "lines" => link.lines = lines(value)?,
            "truth" => link.truth = switch(value)?,
            "maps" => link.maps = switch(value)?,
            // It is the page's own: see `web.rs`.
            "probe" => {}
            _ if key.starts_with("light.") => move_light(&mut link.lights, key, value)?,
            _ => return Err(format!("a link has {KEYS}")),
        }
        Ok(())
    }

    /// Returns the right side's words, and has both sides compared, since the link names it.
    fn right(&mut self) -> &mut shadows::Words {
        self.link.compare = true;
        &mut self.sides[1]
    }

    fn end(self) -> (Link, Vec<String>) {
        let Self { mut link, eye, target, sides, mut messages } = self;
        let alone = |one, other| format!("`{one}` is left out: it needs `{other}` beside it");
        match (eye, target) {
            (Some(eye), Some(target)) if eye.distance(target) < NEAREST => {
                messages.push("`eye` and `target` are left out: they are the same point".to_owned());
            }
            (Some(eye), Some(target)) => link.place = Some([eye, target]),
            (Some(_), None) => messages.push(alone("eye", "target")),
            (None, Some(_)) => messages.push(alone("target", "eye")),
            (None, None) => {}
        }
        let [left, right] = sides;
        link.settings[0] = left.settings("", &mut messages);
        link.settings[1] =
            if link.compare { right.settings("right.", &mut messages) } else { link.settings[0].clone() };
        let more = messages.len().saturating_sub(MOST_MESSAGES);
        if more > 0 {
            messages.truncate(MOST_MESSAGES);
            messages.push(format!("{more} more parts of the link are left out"));
        }
        (link, messages)
    }
}

fn world(value: &str) -> Result<String, String> {
    if is_built_in(value) {
        return Ok(value.to_owned());
    }
    let names: Vec<&str> = worlds::ALL.iter().map(|world| world.name).collect();
    Err(format!("there is no such world here; there are {}", names.join(", ")))
}

fn number(value: &str, range: RangeInclusive<f32>) -> Option<f32> {
    value.trim().parse().ok().filter(|number| range.contains(number))
}

fn hour(value: &str) -> Result<f32, String> {
    let [first, last] = sky::DAY;
    number(value, first..=last).ok_or_else(|| format!("wanted an hour from {first} to {last}"))
}

fn vec3(value: &str) -> Result<Vec3, String> {
    let numbers: Option<Vec<f32>> = value.split(',').map(|one| number(one, -FARTHEST..=FARTHEST)).collect();
    match numbers.as_deref() {
        Some(&[x, y, z]) => Ok(Vec3::new(x, y, z)),
        _ => Err("wanted three numbers in metres, as 1.5,2,-3, each from -1e12 to 1e12".to_owned()),
    }
}

/// Reads `light.N.position` or `light.N.direction`.
fn move_light(lights: &mut MovedLights, key: &str, value: &str) -> Result<(), String> {
    let wanted =
        || "wanted light.N.position or light.N.direction, with the number of a light from 0".to_owned();
    let (number, part) =
        key.strip_prefix("light.").and_then(|rest| rest.split_once('.')).ok_or_else(wanted)?;
    let number: usize = number.parse().map_err(|_| wanted())?;
    match part {
        "position" => lights.entry(number).or_default().position = Some(vec3(value)?),
        "direction" => {
            let way = vec3(value)?;
            let way = Some(way).filter(|way| way.try_normalize().is_some());
            lights.entry(number).or_default().direction =
                Some(way.ok_or("wanted a direction, as 0.3,-1,0.2")?);
        }
        _ => return Err(wanted()),
    }
    Ok(())
}

fn switch(value: &str) -> Result<bool, String> {
    match value {
        "" | "on" | "true" | "yes" | "1" => Ok(true),
        "off" | "false" | "no" | "0" => Ok(false),
        _ => Err("wanted on or off".to_owned()),
    }
}

fn show(value: &str) -> Result<crate::view_state::PictureMode, String> {
    let found = SHOWS.iter().find(|(name, _)| *name == value).map(|(_, mode)| *mode);
    found.ok_or_else(|| format!("wanted {}", SHOWS.map(|(name, _)| name).join(", ")))
}

fn lines(value: &str) -> Result<PlanLines, String> {
    let mut lines = PlanLines::default();
    for part in value.split(',') {
        match part.trim() {
            "slices" => lines.slices = true,
            "maps" => lines.maps = true,
            "casters" => lines.casters = true,
            _ => return Err("wanted slices, maps or casters, with commas between".to_owned()),
        }
    }
    Ok(lines)
}

/// A text without line breaks and other control characters, and not longer than people read.
pub fn one_line(text: &str) -> String {
    const LONGEST: usize = 600;
    text.chars().take(LONGEST).map(|c| if c.is_control() { ' ' } else { c }).collect()
}
