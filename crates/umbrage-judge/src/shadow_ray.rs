//! The way from a surface to a light, and what on it casts a shadow there.
//!
//! Nothing here is in metres. A ray begins as far off its surface as rounding may have moved that (see `triangles.rs`), and
//! what lies as near to a lamp is not before it, for a lamp may stand on a surface.

use glam::DVec3;

use crate::triangles::HALF_ULP;
use crate::{Light, Ray, Receiver, World};

/// What f64 loses of a place, as a share of all numbers that it is computed from: some sixty roundings.
const LOSS: f64 = 64.0 * f64::EPSILON;

/// How many roundings of its f32 coordinates a lamp's place is uncertain by: its own, and those of the surface that it was
/// meant to stand on.
const LAMP_ROUNDINGS: f64 = 4.0;

/// A ray from a point to a light.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowRay {
    pub ray: Ray,
    /// The distance along the ray at which nothing casts a shadow any more, metres.
    pub end: f64,
    /// `None` for a sun.
    lamp: Option<Lamp>,
    epsilons: f64,
}

/// Where a ray's lamp is.
#[derive(Clone, Copy, Debug)]
struct Lamp {
    /// The distance along the ray, metres.
    distance: f64,
    /// How far off its place it may be, metres.
    slack: f64,
}

impl ShadowRay {
    /// From a point, with so many times the ε at the lamp.
    pub fn new(light: &Light, origin: DVec3, epsilons: f64) -> Self {
        match *light {
            Light::Sun { to_light } => {
                Self { ray: Ray::new(origin, to_light), end: f64::INFINITY, lamp: None, epsilons }
            }
            Light::Spot { position, .. } | Light::Point { position, .. } => {
                let (direction, distance) = (position - origin).normalize_and_length();
                let lamp = Lamp { distance, slack: uncertainty(position) };
                let end = distance - light.near_along(direction);
                Self { ray: Ray::new(origin, direction), end, lamp: Some(lamp), epsilons }
            }
        }
    }

    /// From a receiver, so many times its ε off its surface.
    pub fn of(world: &World, light: &Light, receiver: &Receiver, epsilons: f64) -> Self {
        let lift = receiver.lift.max(loss(world, receiver.position));
        Self::new(light, receiver.position + receiver.normal * (lift * epsilons), epsilons)
    }

    /// Whether a triangle that the ray meets at a distance, metres, casts a shadow from there.
    pub fn is_cast_by(&self, world: &World, triangle: usize, distance: f64) -> bool {
        let is_before = |lamp: Lamp| {
            let off_surface =
                (lamp.distance - distance) * world.normal(triangle).dot(self.ray.direction).abs();
            off_surface > self.epsilons * (lamp.slack + world.triangles.lift(triangle))
        };
        world.triangles.casts[triangle] && self.lamp.is_none_or(is_before)
    }
}

/// How far off its place a lamp may be, metres.
fn uncertainty(position: DVec3) -> f64 {
    LAMP_ROUNDINGS * HALF_ULP * position.abs().max_element()
}

/// What f64 loses of a point of a world, metres.
pub(crate) fn loss(world: &World, point: DVec3) -> f64 {
    LOSS * (world.reach() + point.abs().max_element())
}

/// What f64 loses of a point that an eye sees so many metres away.
pub(crate) fn loss_of_sight(world: &World, point: DVec3, metres: f64) -> f64 {
    loss(world, point) + LOSS * metres
}

/// The sine of the angle by which rounding may have turned a light as it is seen from a point, at the most.
pub(crate) fn turn(light: &Light, distance: f64) -> f64 {
    match *light {
        // Each of the three numbers of its direction, and those that they were normalised by.
        Light::Sun { .. } => LAMP_ROUNDINGS * HALF_ULP,
        Light::Spot { position, .. } | Light::Point { position, .. } => uncertainty(position) / distance,
    }
}

/// The share of light, 0 to 1, that reaches a receiver from a light, so many ε off both.
pub(crate) fn reaching(world: &World, light: &Light, receiver: &Receiver, epsilons: f64) -> f64 {
    world.reaching(&ShadowRay::of(world, light, receiver, epsilons), 0.0)
}
