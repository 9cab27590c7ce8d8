//! Why a pixel is wrong: what its surroundings say, and what a map's texel must have seen there.
//!
//! This is a leaf of [`crate::error`]: it classifies one pixel, and [`crate::Error`] adds up the shares.

use glam::DVec3;

use crate::shadow_ray::ShadowRay;
use crate::truth::Receiver;
use crate::{Truth, Verdict, World};

/// The shares of judged pixels that are wrong, each 0 to 1, by cause. Together they are [`crate::Error::mis_shadowed`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Causes {
    /// Share of wrong pixels near a true edge: within two texels of it, or two pixels where those are larger.
    pub edge: f64,
    /// Share of pixels that are falsely shadowed by their own surface.
    pub acne: f64,
    /// Share of pixels that are falsely lit close to what shadows them: the shadow begins too late.
    pub detach: f64,
    /// Share of pixels that are falsely lit in part, by light that a filter let through.
    pub leak: f64,
    /// Share of pixels that are falsely lit because no map serves them.
    pub range: f64,
    /// Share of wrong pixels with none of these causes.
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

/// Says why a result is wrong about a receiver; `None` where it is right, or not judged. `texel_metres` is 0 where no map
/// serves the receiver, `edge_distance` is that of its pixel to the nearest true edge, in pixels.
pub(crate) fn cause(
    world: &World,
    truth: &Truth,
    receiver: &Receiver,
    verdict: Verdict,
    visibility: f32,
    texel_metres: f32,
    edge_distance: f32,
) -> Option<Cause> {
    if !verdict.is_wrong() {
        return None;
    }
    let Some(toward) = truth.light.toward(receiver.position) else {
        return Some(Cause::Other);
    };
    let to_light = toward.direction;
    let texel = f64::from(texel_metres);
    let cosine = receiver.normal.dot(to_light).clamp(1e-6, 1.0);
    let tangent = (1.0 - cosine * cosine).sqrt() / cosine;
    let pixels_a_texel = texel / cosine / truth.eye.pixel_metres(receiver.depth);
    if texel == 0.0 && verdict == Verdict::FalseLight {
        return Some(Cause::Range);
    }
    if f64::from(edge_distance) <= 2.0 * pixels_a_texel.max(1.0) {
        return Some(Cause::Edge);
    }
    match verdict {
        Verdict::NotTraced | Verdict::NotJudged | Verdict::Right => None,
        Verdict::FalseShadow if is_own_surface(world, truth, receiver, to_light, texel, tangent) => {
            Some(Cause::Acne)
        }
        Verdict::FalseLight if blocker_distance(world, truth, receiver) < 4.0 * texel * tangent.max(1.0) => {
            Some(Cause::Detach)
        }
        Verdict::FalseLight if visibility < 0.95 => Some(Cause::Leak),
        Verdict::FalseShadow | Verdict::FalseLight => Some(Cause::Other),
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
            world.reaching(&ShadowRay::new(&truth.light, beside, 1.0), tolerance) >= 1.0
        })
    })
}

/// The distance from a receiver to the nearest blocker toward the light, metres; infinite where there is none.
fn blocker_distance(world: &World, truth: &Truth, receiver: &Receiver) -> f64 {
    let to_light = ShadowRay::of(world, &truth.light, receiver, 1.0);
    world.first_caster(&to_light).map_or(f64::INFINITY, |hit| hit.distance)
}
