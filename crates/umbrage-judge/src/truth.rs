//! What a camera sees, and whether the light reaches it: exactly, pixel by pixel.
//!
//! A pixel is judged by the ray through its centre: the first triangle it meets, and from there a ray to the light, lifted
//! off the surface by ε. A light that stands in the world may stand on a surface too: the ray ends ε before it. Where
//! twice the ε changes the answer, the pixel is ambiguous, and not judged. Nor are pixels whose surface is turned away
//! from the light, or where it does not shine: shading leaves them dark, whatever their shadow.

use glam::DVec3;
use rayon::prelude::*;

use crate::{Eye, Hit, Light, Ray, World};

/// The minimum cosine between a surface's normal and the light: at this or less, shading leaves the surface unlit.
const MIN_COSINE: f64 = 0.02;

/// A receiver is the first surface that a pixel's ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Receiver {
    /// The point in world space, in metres.
    pub position: DVec3,
    /// The unit geometric normal, turned to the eye.
    pub normal: DVec3,
    /// The view depth, in metres.
    pub depth: f64,
    /// The index of the surface's triangle in [`World::triangles`].
    pub triangle: usize,
}

/// The truth of a pixel: whether it is judged, and whether the light reaches it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pixel {
    /// The pixel shows no surface.
    Sky,
    /// The light does not shine at the surface, which is outside its cone or beyond its range.
    Unreached,
    /// The surface does not face the light.
    TurnedAway,
    /// The surface is farther away than shadows are asked for.
    Beyond,
    /// It depends on rounding whether the light reaches the surface.
    Ambiguous,
    /// The light reaches the surface.
    Lit,
    /// Something blocks the light.
    Shadowed,
}

impl Pixel {
    /// Whether results are judged at this pixel: it is lit or shadowed for sure.
    pub fn is_judged(self) -> bool {
        matches!(self, Self::Lit | Self::Shadowed)
    }
}

/// The truth of a picture by one light: what the camera sees, and what of it the light reaches.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The camera and the size of the picture.
    pub eye: Eye,
    /// The light.
    pub light: Light,
    /// The first surface of each pixel, row by row; `None` for sky.
    pub receivers: Vec<Option<Receiver>>,
    /// The truth of each pixel, row by row.
    pub pixels: Vec<Pixel>,
}

impl Truth {
    /// Traces every pixel, on all cores. Surfaces deeper than `distance` metres are not judged.
    pub fn new(world: &World, eye: &Eye, light: &Light, distance: f64) -> Self {
        let width = eye.width.max(1) as usize;
        let (receivers, pixels) = (0..width * eye.height as usize)
            .into_par_iter()
            .with_min_len(width)
            .map(|i| {
                let receiver = receiver(world, eye, &central_ray(eye, i));
                (receiver, pixel(world, light, receiver.as_ref(), distance))
            })
            .unzip();
        Self { eye: *eye, light: *light, receivers, pixels }
    }

    /// Returns the number of pixels with that truth.
    pub fn count(&self, wanted: Pixel) -> usize {
        self.pixels.iter().filter(|pixel| **pixel == wanted).count()
    }

    /// Returns the number of judged pixels.
    pub fn judged(&self) -> usize {
        self.pixels.iter().filter(|pixel| pixel.is_judged()).count()
    }
}

/// The ray through the centre of one of the eye's pixels.
pub(crate) fn central_ray(eye: &Eye, pixel: usize) -> Ray {
    let width = eye.width.max(1) as usize;
    eye.ray((pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5)
}

/// The first surface along a ray of the eye.
pub(crate) fn receiver(world: &World, eye: &Eye, ray: &Ray) -> Option<Receiver> {
    world.first_hit(ray, eye.near, eye.far).map(|hit| surface(world, ray, hit))
}

/// The surface that a ray of the eye meets.
pub(crate) fn surface(world: &World, ray: &Ray, Hit { distance, triangle }: Hit) -> Receiver {
    let normal = world.normal(triangle);
    let normal = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
    Receiver { position: ray.at(distance), normal, depth: distance, triangle }
}

/// Whether a receiver's surface faces a light.
fn faces(receiver: &Receiver, to_light: DVec3) -> bool {
    receiver.normal.dot(to_light) > MIN_COSINE
}

/// Whether a light shines at a receiver, and the receiver's surface faces it.
pub(crate) fn can_be_lit(light: &Light, receiver: &Receiver) -> bool {
    light.toward(receiver.position).is_some_and(|toward| faces(receiver, toward.direction))
}

/// The ε at a point, metres: about what its f32 coordinates are worth.
pub(crate) fn epsilon(point: DVec3) -> f64 {
    point.abs().max_element().max(1.0) * 2f64.powi(-18)
}

/// A ray from a receiver to a light, and where it ends, metres: so many ε off the receiver's surface and before the light.
pub(crate) fn shadow_ray(light: &Light, receiver: &Receiver, epsilons: f64) -> (Ray, f64) {
    let lifted = receiver.position + receiver.normal * (epsilon(receiver.position) * epsilons);
    light.ray_from(lifted, epsilons)
}

/// Whether anything is between a receiver and a light, so many ε off both.
pub(crate) fn is_shadowed(world: &World, light: &Light, receiver: &Receiver, epsilons: f64) -> bool {
    let (ray, end) = shadow_ray(light, receiver, epsilons);
    world.is_blocked(&ray, 0.0, end)
}

/// What is true of a pixel with this first surface, or none.
pub(crate) fn pixel(world: &World, light: &Light, receiver: Option<&Receiver>, distance: f64) -> Pixel {
    let Some(receiver) = receiver else {
        return Pixel::Sky;
    };
    let Some(toward) = light.toward(receiver.position) else {
        return Pixel::Unreached;
    };
    if !faces(receiver, toward.direction) {
        return Pixel::TurnedAway;
    }
    if receiver.depth > distance {
        return Pixel::Beyond;
    }
    let shadowed = |epsilons| is_shadowed(world, light, receiver, epsilons);
    match (shadowed(1.0), shadowed(2.0)) {
        (true, true) => Pixel::Shadowed,
        (false, false) => Pixel::Lit,
        _ => Pixel::Ambiguous,
    }
}
