//! How much of a light of some size reaches each pixel: the mean of the hard shadows of many points on it.
//!
//! P. Heckbert, M. Herf, *Simulating Soft Shadows with Graphics Hardware*, CMU-CS-97-104, 1997: N shadow maps, one for
//! each sample of the light, and the mean of what they say. It is dear, and as right as its maps and N are: a yardstick
//! for filters that soften one map.
//!
//! A sun is a disc that is seen under an angle. A punctual light is a ball: samples of it, seen from anywhere, are spread evenly
//! over the disc that it looks like, for they are the 3-sphere's without their fourth coordinate (Archimedes).

use glam::Vec3;
use umbrage::{Light, LightError, LightKind};

use crate::error::RenderError;
use crate::light::WIDEST_HALF_ANGLE;

/// Says how large lights are, and how many points of each are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// The number of points, 1 to [`MOST_SAMPLES`]. One is the middle: the hard shadow.
    pub samples: u32,
    /// The whole angle that a sun is seen under, from 0 to below 180 degrees. Punctual lights have half of it, in radians,
    /// for a radius in metres.
    pub degrees: f32,
}

/// The most samples there may be: more than eight bits of visibility can tell apart.
pub const MOST_SAMPLES: u32 = 1024;

impl Area {
    /// Checks that there is such a light.
    ///
    /// # Errors
    /// The first number that is out of its range.
    pub fn validate(&self) -> Result<(), RenderError> {
        let Self { samples, degrees } = *self;
        if !(1..=MOST_SAMPLES).contains(&samples) {
            return Err(RenderError::AreaSamples { got: samples, most: MOST_SAMPLES });
        }
        if !(0.0..180.0).contains(&degrees) {
            return Err(RenderError::AreaDegrees(degrees));
        }
        Ok(())
    }

    /// A light moved to one of its samples.
    pub(crate) fn moved(&self, light: &Light, sample: u32) -> Result<Light, LightError> {
        let half_angle = 0.5 * self.degrees.to_radians();
        let place = place(sample, self.samples);
        let aside = place * half_angle;
        let moved = match light.kind() {
            LightKind::Directional { direction } => {
                let (right, up) = direction.any_orthonormal_pair();
                let aside = (right * place.x + up * place.y) * half_angle.tan();
                Light::directional(direction - aside)?
            }
            // A cone that is wider by as much as a metre off its apex, so that its map still holds what the middle shines at.
            LightKind::Spot { position, direction, half_angle, range } => {
                let wider = (half_angle + aside.length().atan()).min(half_angle.max(WIDEST_HALF_ANGLE));
                Light::spot(position + aside, direction, wider, range + aside.length())?
            }
            LightKind::Point { position, range } => Light::point(position + aside, range + aside.length())?,
        };
        // A sample is a point: the samples are the size.
        let moved = moved.with_size(0.0)?;
        Ok(light.resolution().map_or(moved, |texels| moved.with_resolution(texels)))
    }
}

/// A sample's place in the unit ball; x and y are its place on the unit disc. Shoemake's uniform unit quaternion
/// (*Graphics Gems III*, 1992), of coordinates that are in strata, and turned by the golden ratio and by √2.
fn place(sample: u32, samples: u32) -> Vec3 {
    if samples == 1 {
        return Vec3::ZERO;
    }
    let i = f64::from(sample);
    let u = (i + 0.5) / f64::from(samples);
    let turns = |step: f64| (step * i).fract() * std::f64::consts::TAU;
    let (sine, cosine) = turns(0.618_033_988_749_894_9).sin_cos();
    let across = (1.0 - u).sqrt();
    let deep = u.sqrt() * turns(std::f64::consts::SQRT_2).sin();
    Vec3::new((across * cosine) as f32, (across * sine) as f32, deep as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_look_like_an_even_disc_from_every_side() {
        let places: Vec<Vec3> = (0..1024).map(|i| place(i, 1024)).collect();
        assert!(places.iter().all(|place| place.length() <= 1.0), "in the unit ball");
        for from in [Vec3::Z, Vec3::X, Vec3::Y, Vec3::new(0.6, 0.0, 0.8), Vec3::new(0.0, -0.8, 0.6)] {
            let (right, up) = from.any_orthonormal_pair();
            let share = |is_there: &dyn Fn(f32, f32) -> bool| {
                places.iter().filter(|p| is_there(p.dot(right), p.dot(up))).count() as f32 / 1024.0
            };
            // A disc of half the radius has a quarter of the area.
            let (inner, left) = (share(&|x, y| x * x + y * y < 0.25), share(&|x, _| x < 0.0));
            assert!((inner - 0.25).abs() < 0.02 && (left - 0.5).abs() < 0.02, "{from}: {inner}, {left}");
        }
    }

    #[test]
    fn a_moved_sun_is_within_half_its_angle_and_a_moved_point_light_within_its_radius() {
        let area = Area { samples: 64, degrees: 10.0 };
        let sun = Light::directional(Vec3::new(0.3, -1.0, 0.2)).unwrap();
        let point = Light::point(Vec3::new(1.0, 2.0, 3.0), 9.0).unwrap();
        for sample in 0..64 {
            let turned = area.moved(&sun, sample).unwrap().direction_from(Vec3::ZERO);
            let angle = turned.angle_between(sun.direction_from(Vec3::ZERO)).to_degrees();
            assert!(angle <= 5.001, "{angle}°");
            let LightKind::Point { position, .. } = area.moved(&point, sample).unwrap().kind() else {
                panic!("a point")
            };
            assert!(position.distance(Vec3::new(1.0, 2.0, 3.0)) <= 5f32.to_radians() + 1e-6, "{position}");
        }
    }
}
