//! Suns that go around as days pass.
//!
//! No built-in world has one that does so of itself: what is measured over time of a world with a sun is of one that stands,
//! and light maps are baked for suns that stand.

use std::f32::consts::TAU;

use glam::Vec3;

use crate::{LightKind, Motion, Scene};

/// The latitude of the place, radians: 50° north. East is +X and south is +Z.
const LATITUDE: f32 = 50.0 * std::f32::consts::PI / 180.0;

impl Motion {
    /// Returns the motion of a sun that goes once around in `day_seconds`, which are not 0, as one does at 50° north: from the
    /// east, which is +X, over the south, which is +Z. Where it is at time 0 it stays at time 0.
    pub fn of_sun(day_seconds: f32) -> Self {
        let pole = Vec3::new(0.0, LATITUDE.sin(), -LATITUDE.cos());
        Self::Rotation { centre: Vec3::ZERO, axis: pole, radians_per_second: -TAU / day_seconds }
    }
}

impl Scene {
    /// Lets every sun that stands still go once around in `day_seconds` ([`Motion::of_sun`]).
    pub fn let_suns_go_around(&mut self, day_seconds: f32) {
        for light in &mut self.lights {
            if light.kind == LightKind::Directional && light.motion == Motion::Still {
                light.motion = Motion::of_sun(day_seconds);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Light, Pose, worlds};

    #[test]
    fn a_sun_in_the_south_is_in_the_west_after_a_quarter_of_a_day() {
        let motion = Motion::of_sun(86_400.0);
        // At an equinox, when it rises in the east and sets in the west.
        let noon = Vec3::new(0.0, LATITUDE.cos(), LATITUDE.sin());
        let sun = Light { motion, ..Light::sun(-noon, 3.0) };
        for (hours, want) in [(0.0, noon), (6.0, Vec3::NEG_X), (12.0, -noon), (18.0, Vec3::X), (24.0, noon)] {
            let at = sun.world_from_light_in(&Pose::at(hours * 3600.0));
            let toward_it = at.z_axis.truncate();
            assert!(toward_it.distance(want) < 1e-5, "{hours} h after noon: {toward_it}, not {want}");
        }
    }

    #[test]
    fn suns_of_the_papers_worlds_stand_unless_they_are_let_go_and_begin_where_they_stood() {
        for name in ["robot-war", "huge-chessboard", "knights", "mining-terrain", "night-chessboard"] {
            let mut scene = worlds::build(name, 0).unwrap();
            let still = scene.lights.clone();
            assert!(still.iter().all(|light| light.motion == Motion::Still), "{name}");
            scene.let_suns_go_around(600.0);
            for (light, was) in scene.lights.iter().zip(&still) {
                let [start, later] =
                    [0.0, 25.0].map(|seconds| light.world_from_light_in(&scene.pose(seconds)));
                assert_eq!(start, was.world_from_light, "{name}: {}, to the last bit", light.name);
                let is_sun = light.kind == LightKind::Directional;
                // 15° about the pole, which are fewer of the sun's own way.
                let moved = start.z_axis.truncate().angle_between(later.z_axis.truncate()).to_degrees();
                assert!(if is_sun { (5.0..15.1).contains(&moved) } else { moved == 0.0 }, "{name}: {moved}°");
            }
        }
    }
}
