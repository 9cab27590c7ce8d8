//! Why a pixel is wrong: what its surroundings say, and what a map's texel must have seen there.

use glam::DVec3;

use crate::error::Wrong;
use crate::truth::{Receiver, shadow_ray};
use crate::{Truth, World};

/// Shares of judged pixels that are wrong, by cause. They add up to all that is wrong.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Causes {
    /// Near a true edge: within two texels, or two pixels where those are larger.
    pub edge: f64,
    /// Falsely shadowed by the surface itself.
    pub acne: f64,
    /// Falsely lit close to what shadows it: the shadow begins too late.
    pub detach: f64,
    /// Falsely lit in part: light that a filter let through.
    pub leak: f64,
    /// Falsely lit where no map serves the pixel.
    pub range: f64,
    /// None of these.
    pub other: f64,
}

/// One of [`Causes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cause {
    Edge,
    Acne,
    Detach,
    Leak,
    Range,
    Other,
}

impl Causes {
    pub(crate) fn of_mut(&mut self, cause: Cause) -> &mut f64 {
        let Self { edge, acne, detach, leak, range, other } = self;
        match cause {
            Cause::Edge => edge,
            Cause::Acne => acne,
            Cause::Detach => detach,
            Cause::Leak => leak,
            Cause::Range => range,
            Cause::Other => other,
        }
    }
}

/// Why a claim about a receiver is wrong. `edge_distance` is that of its pixel to the nearest true edge, pixels.
pub(crate) fn cause(
    world: &World,
    truth: &Truth,
    receiver: &Receiver,
    wrong: Wrong,
    visibility: f32,
    texel_metres: f32,
    edge_distance: f32,
) -> Cause {
    let Some(toward) = truth.light.toward(receiver.position) else {
        return Cause::Other;
    };
    let to_light = toward.direction;
    let texel = f64::from(texel_metres);
    let cosine = receiver.normal.dot(to_light).clamp(1e-3, 1.0);
    let tangent = (1.0 - cosine * cosine).sqrt() / cosine;
    let pixels_a_texel = texel / cosine / truth.eye.pixel_metres(receiver.depth);
    if texel == 0.0 && wrong == Wrong::FalseLight {
        return Cause::Range;
    }
    if f64::from(edge_distance) <= 2.0 * pixels_a_texel.max(1.0) {
        return Cause::Edge;
    }
    match wrong {
        Wrong::FalseShadow if is_own_surface(world, truth, receiver, to_light, texel, tangent) => Cause::Acne,
        Wrong::FalseShadow => Cause::Other,
        Wrong::FalseLight if blocker_distance(world, truth, receiver) < 4.0 * texel * tangent.max(1.0) => {
            Cause::Detach
        }
        Wrong::FalseLight if visibility < 0.95 => Cause::Leak,
        Wrong::FalseLight => Cause::Other,
    }
}

/// Whether what the light sees within two texels of a receiver is everywhere about as far from it as the receiver: then
/// only its own surface can have shadowed it.
fn is_own_surface(
    world: &World,
    truth: &Truth,
    receiver: &Receiver,
    to_light: DVec3,
    texel: f64,
    tangent: f64,
) -> bool {
    let (right, up) = to_light.any_orthonormal_pair();
    // Twice the depth that a plane gains over the corner of such a square.
    let tolerance = 8.0 * texel * tangent.max(1.0) * std::f64::consts::SQRT_2;
    let steps = [-2.0, -1.0, 0.0, 1.0, 2.0];
    steps.iter().all(|x| {
        steps.iter().all(|y| {
            let beside = receiver.position + (right * *x + up * *y) * texel;
            let (ray, end) = truth.light.ray_from(beside, 1.0);
            !world.is_blocked(&ray, tolerance, end)
        })
    })
}

/// How far from a receiver the nearest thing on the way to the light is, metres; infinite where there is none.
fn blocker_distance(world: &World, truth: &Truth, receiver: &Receiver) -> f64 {
    let (ray, end) = shadow_ray(&truth.light, receiver, 1.0);
    world.first_hit(&ray, 0.0, end).map_or(f64::INFINITY, |hit| hit.distance)
}
