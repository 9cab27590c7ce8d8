//! Which of a world's lights shine: the brightest as seen from a camera, where there are more than can be drawn.
//!
//! A light counts for the illuminance, in lux, that it would give at the camera if nothing were in the way: a sun's own
//! intensity, a lamp's intensity over the square of its distance. The picture's area that a lamp lights above any given
//! illuminance is in proportion to it, so near lamps go before far ones that are as bright. A lamp whose range ends behind
//! the camera or begins beyond the farthest visible depth counts for nothing, and so does what gives no light at all.
//! Of lights that count for the same, those that the file lists first go first.

use glam::Vec3;

use crate::{Camera, Light, LightKind, Pose};

/// The lights that shine in a picture, and what is to be said about the others.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shining {
    /// The lights that shine, in the order in which they were given. Empty only where none was given.
    pub lights: Vec<Light>,
    /// The warnings about lights that were left out: one line for each reason, with the first few names and a count.
    pub warnings: Vec<String>,
}

impl Shining {
    /// Chooses at most `most` of some lights, as they are in a pose, for a picture of `camera`.
    ///
    /// Lights that are hidden in the pose are left out first, and lights that give no light: an intensity that is not above 0
    /// or above [`Self::MAX_INTENSITY`], a black colour, a range that is not above 0, or a place that is not finite. Where no
    /// other is given, the first of them stands for all, with an intensity of 0.
    pub fn choose<'a>(
        lights: impl IntoIterator<Item = &'a Light>,
        camera: &Camera,
        pose: &Pose,
        most: usize,
    ) -> Self {
        let (mut useful, mut dark, mut hidden) = (Vec::new(), Vec::new(), Vec::new());
        for (place, light) in lights.into_iter().enumerate() {
            match fault(light, pose) {
                None if light.is_visible_in(pose) => useful.push((place, light)),
                None => hidden.push(light),
                Some(fault) => dark.push((light, fault)),
            }
        }
        let given = useful.len() + dark.len() + hidden.len();
        let mut warnings = Vec::new();
        if !dark.is_empty() {
            let names = dark.iter().map(|(light, fault)| format!("{:?} ({fault})", light.name));
            let most = Self::MAX_INTENSITY;
            warnings.push(format!(
                "lights whose intensity is not above 0 and up to {most:e}, or that have no colour, range or place, are left out: {}",
                some(names)
            ));
        }
        if useful.is_empty() {
            let out = hidden.first().copied().or(dark.first().map(|(light, _)| *light));
            let lights = out.map(|light| unlit(light, pose)).into_iter().collect();
            return Self { lights, warnings };
        }
        if useful.len() > most {
            let mut order: Vec<(f64, usize, &Light)> = useful
                .into_iter()
                .map(|(place, light)| (illuminance(light, camera, pose), place, light))
                .collect();
            order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
            let names = order[most..].iter().map(|(_, _, light)| format!("{:?}", light.name));
            warnings.push(format!(
                "{most} of {given} lights shine, the brightest as seen from the camera; left out: {}",
                some(names)
            ));
            useful = order[..most].iter().map(|(_, place, light)| (*place, *light)).collect();
            useful.sort_by_key(|(place, _)| *place);
        }
        Self { lights: useful.into_iter().map(|(_, light)| light.clone()).collect(), warnings }
    }

    /// The maximum intensity of a light that shines, in lux or candela. At a millimetre from a lamp its square is
    /// still a number in f32.
    pub const MAX_INTENSITY: f32 = 1e15;
}

/// Why a light gives no light, or `None` where it does.
fn fault(light: &Light, pose: &Pose) -> Option<String> {
    let Light { name: _, world_from_light: _, colour, intensity, kind, near: _, motion: _ } = light;
    let (unit, range) = match *kind {
        LightKind::Directional => ("lx", f32::INFINITY),
        LightKind::Spot { inner: _, outer: _, range } | LightKind::Point { range } => ("cd", range),
    };
    let at = light.world_from_light_in(pose);
    if !(*intensity > 0.0 && *intensity <= Shining::MAX_INTENSITY) {
        Some(format!("intensity {intensity:?} {unit}"))
    } else if !(colour.is_finite() && colour.min_element() >= 0.0 && *colour != Vec3::ZERO) {
        let [red, green, blue] = colour.to_array();
        Some(format!("colour {red} {green} {blue}"))
    } else if range.is_nan() || range <= 0.0 {
        Some(format!("range {range:?} m"))
    } else if !at.is_finite() || at.z_axis.truncate() == Vec3::ZERO {
        Some("a place that is not finite".to_owned())
    } else {
        None
    }
}

/// A light in the place of this one, as far as it has one, that gives no light.
fn unlit(light: &Light, pose: &Pose) -> Light {
    let dark = Light { intensity: 0.0, ..light.clone() };
    let would_shine = Light { intensity: 1.0, colour: Vec3::ONE, ..light.clone() };
    match fault(&would_shine, pose) {
        None => Light { colour: Vec3::ONE, ..dark },
        Some(_) => Light { name: dark.name, ..Light::sun(Vec3::NEG_Y, 0.0) },
    }
}

/// The illuminance at a camera, lux, as the head of this file says.
fn illuminance(light: &Light, camera: &Camera, pose: &Pose) -> f64 {
    // Rec. 709.
    let luminance = light.colour.as_dvec3().dot(glam::DVec3::new(0.2126, 0.7152, 0.0722));
    let intensity = f64::from(light.intensity) * luminance;
    match light.kind {
        LightKind::Directional => intensity,
        LightKind::Spot { inner: _, outer: _, range } | LightKind::Point { range } => {
            let position = light.world_from_light_in(pose).w_axis.truncate();
            let from_eye = position.as_dvec3() - camera.eye().as_dvec3();
            let (depth, range) = (from_eye.dot(camera.forward().as_dvec3()), f64::from(range));
            let is_behind = depth + range <= f64::from(camera.near);
            let is_beyond = depth - range >= f64::from(camera.far);
            if is_behind || is_beyond { 0.0 } else { intensity / from_eye.length_squared() }
        }
    }
}

/// The first few of some names, and how many more there are.
fn some(names: impl ExactSizeIterator<Item = String>) -> String {
    /// How many are named.
    const NAMED: usize = 8;
    let more = names.len().saturating_sub(NAMED);
    let line = names.take(NAMED).map(crate::error::one_line).collect::<Vec<_>>().join(", ");
    if more > 0 { format!("{line} and {more} more") } else { line }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        Camera::looking("c", Vec3::ZERO, Vec3::NEG_Z, 1.0, 0.1, 100.0)
    }

    fn lamp(name: &str, depth: f32, candela: f32) -> Light {
        Light::point(name, Vec3::NEG_Z * depth, f32::INFINITY, candela)
    }

    fn names(of: &Shining) -> Vec<&str> {
        of.lights.iter().map(|light| light.name.as_str()).collect()
    }

    #[test]
    fn the_brightest_at_the_camera_stay_in_the_order_of_the_file() {
        // 0.1, 1, 0.25 and 2 lx at the camera.
        let sun = Light::sun(Vec3::NEG_Y, 2.0);
        let lights = [lamp("far", 10.0, 10.0), lamp("near", 2.0, 4.0), lamp("dim", 2.0, 1.0), sun];
        let choose = |most| Shining::choose(&lights, &camera(), &Pose::default(), most);
        assert_eq!(names(&choose(4)), ["far", "near", "dim", "sun"]);
        assert!(choose(4).warnings.is_empty(), "nothing is left out");
        assert_eq!(names(&choose(3)), ["near", "dim", "sun"]);
        let two = choose(2);
        assert_eq!(names(&two), ["near", "sun"]);
        assert_eq!(two.warnings.len(), 1);
        assert!(two.warnings[0].contains("2 of 4") && two.warnings[0].contains(r#""dim", "far""#), "{two:?}");
        assert_eq!(names(&choose(1)), ["sun"]);
    }

    #[test]
    fn what_ends_behind_the_camera_or_begins_beyond_its_sight_goes_first() {
        let of = |depth: f32, range| Light::point(&format!("{depth}"), Vec3::NEG_Z * depth, range, 100.0);
        let lights = [of(-5.0, 4.0), of(-5.0, 6.0), of(120.0, 10.0), of(120.0, 30.0), of(90.0, 1.0)];
        let mut lights = Shining::choose(&lights, &camera(), &Pose::default(), 3)
            .lights
            .into_iter()
            .map(|l| (l.name, l.kind));
        let ranges = [("-5", 6.0), ("120", 30.0), ("90", 1.0)];
        assert!(
            lights.by_ref().eq(ranges.map(|(name, range)| (name.to_owned(), LightKind::Point { range })))
        );
    }

    #[test]
    fn lights_that_count_the_same_stay_in_the_order_of_the_file() {
        let lights: Vec<Light> = (0..40).map(|i| lamp(&i.to_string(), 3.0, 1.0)).collect();
        let chosen = Shining::choose(&lights, &camera(), &Pose::default(), 16);
        assert_eq!(chosen.lights, lights[..16]);
        assert!(chosen.warnings[0].ends_with("and 16 more"), "{chosen:?}");
    }

    #[test]
    fn what_gives_no_light_is_named_with_its_number_and_the_others_shine() {
        let broken = |name: &str, intensity| Light { intensity, ..lamp(name, 1.0, 1.0) };
        let without_range = Light::point("short", Vec3::ONE, 0.0, 1.0);
        let nowhere = Light { world_from_light: glam::Mat4::NAN, ..lamp("nowhere", 1.0, 1.0) };
        let black = Light { colour: Vec3::ZERO, ..lamp("black", 1.0, 1.0) };
        let lights = [
            broken("odd", f32::NAN),
            broken("minus", -1.0),
            broken("huge", 1e30),
            broken("unbounded", f32::INFINITY),
            broken("off", 0.0),
            without_range,
            nowhere,
            black,
            lamp("good", 4.0, 1.0),
        ];
        let chosen = Shining::choose(&lights, &camera(), &Pose::default(), 16);
        assert_eq!(names(&chosen), ["good"]);
        let [line] = &chosen.warnings[..] else { panic!("one line, not {chosen:?}") };
        for said in [
            "\"odd\" (intensity NaN cd",
            "-1.0 cd",
            "1e30 cd",
            "inf cd",
            "0.0 cd",
            "range 0.0 m",
            "a place",
            "colour 0 0 0",
        ] {
            assert!(line.contains(said), "{said}: {line}");
        }
        for end in 1..8 {
            let dark = Shining::choose(&lights[..end], &camera(), &Pose::default(), 16);
            assert_eq!((dark.lights.len(), dark.lights[0].intensity), (1, 0.0), "{dark:?}");
            assert!(dark.lights[0].world_from_light.is_finite() && dark.lights[0].name == "odd", "{dark:?}");
        }
        let alone = Shining::choose(&lights[6..7], &camera(), &Pose::default(), 16);
        assert!(
            alone.lights[0].world_from_light.is_finite() && alone.lights[0].intensity == 0.0,
            "{alone:?}"
        );
        assert_eq!(Shining::choose(&[], &camera(), &Pose::default(), 16), Shining::default());
    }

    #[test]
    fn ten_thousand_lights_are_chosen_from_in_a_moment() {
        let lights: Vec<Light> = (0..10_000).map(|i| lamp(&i.to_string(), 1.0 + i as f32, 1.0)).collect();
        let start = std::time::Instant::now();
        let chosen = Shining::choose(lights.iter().rev(), &camera(), &Pose::default(), 16);
        assert!(start.elapsed().as_millis() < 1000, "{:?}", start.elapsed());
        let nearest: Vec<String> = (0..16).rev().map(|i| i.to_string()).collect();
        assert_eq!(names(&chosen), nearest);
        assert!(chosen.warnings[0].contains("16 of 10000") && chosen.warnings[0].ends_with("and 9976 more"));
    }
}
