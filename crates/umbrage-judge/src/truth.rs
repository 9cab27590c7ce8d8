//! What a camera sees, and whether the sun reaches it: exactly, pixel by pixel.
//!
//! A pixel is judged by the ray through its centre: the first triangle it meets, and from there a ray to the sun, lifted
//! off the surface by ε. Where twice the ε changes the answer, the pixel is ambiguous, and not judged. Nor are pixels
//! whose surface is turned away from the sun: shading leaves them dark, whatever their shadow.

use glam::DVec3;
use rayon::prelude::*;

use crate::{Eye, Ray, Sun, World};

/// Surfaces whose cosine to the light is at most this are unlit by shading.
const LEAST_COSINE: f64 = 0.02;

/// The first surface that a pixel's ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Receiver {
    /// In world space.
    pub position: DVec3,
    /// Unit, geometric, turned to the eye.
    pub normal: DVec3,
    /// View depth, metres.
    pub depth: f64,
    /// Index into [`World::triangles`].
    pub triangle: usize,
}

/// What the truth says of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pixel {
    /// Nothing is there.
    Sky,
    /// Its surface does not face the sun.
    TurnedAway,
    /// Its surface is farther away than shadows are asked for.
    Beyond,
    /// Whether the sun reaches it depends on rounding.
    Ambiguous,
    /// The sun reaches it.
    Lit,
    /// Something is in the way.
    Shadowed,
}

impl Pixel {
    /// Whether claims about it are judged.
    pub fn is_judged(self) -> bool {
        matches!(self, Self::Lit | Self::Shadowed)
    }
}

/// What a camera sees of a world, and what of it the sun reaches.
#[derive(Clone, Debug)]
pub struct Truth {
    /// From where.
    pub eye: Eye,
    /// By what light.
    pub sun: Sun,
    /// The surface of each pixel.
    pub receivers: Vec<Option<Receiver>>,
    /// What is true of it.
    pub pixels: Vec<Pixel>,
}

impl Truth {
    /// Traces every pixel, on all cores. Surfaces deeper than `distance` metres are not judged.
    pub fn new(world: &World, eye: &Eye, sun: &Sun, distance: f64) -> Self {
        let width = eye.width.max(1) as usize;
        let (receivers, pixels) = (0..width * eye.height as usize)
            .into_par_iter()
            .with_min_len(width)
            .map(|i| {
                let ray = eye.ray((i % width) as f64 + 0.5, (i / width) as f64 + 0.5);
                let receiver = receiver(world, eye, &ray);
                (receiver, receiver.map_or(Pixel::Sky, |receiver| pixel(world, sun, &receiver, distance)))
            })
            .unzip();
        Self { eye: *eye, sun: *sun, receivers, pixels }
    }

    /// How many pixels are so.
    pub fn count(&self, wanted: Pixel) -> usize {
        self.pixels.iter().filter(|pixel| **pixel == wanted).count()
    }

    /// How many pixels are judged.
    pub fn judged(&self) -> usize {
        self.pixels.iter().filter(|pixel| pixel.is_judged()).count()
    }
}

/// The first surface along a ray of the eye.
pub(crate) fn receiver(world: &World, eye: &Eye, ray: &Ray) -> Option<Receiver> {
    let hit = world.first_hit(ray, eye.near, eye.far)?;
    let normal = world.normal(hit.triangle);
    let normal = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
    Some(Receiver { position: ray.at(hit.distance), normal, depth: hit.distance, triangle: hit.triangle })
}

/// Whether a receiver's surface faces a light.
pub(crate) fn faces(receiver: &Receiver, to_light: DVec3) -> bool {
    receiver.normal.dot(to_light) > LEAST_COSINE
}

/// A ray from a receiver to a light, lifted off its surface by so many ε.
pub(crate) fn shadow_ray(receiver: &Receiver, to_light: DVec3, epsilons: f64) -> Ray {
    let epsilon = receiver.position.abs().max_element().max(1.0) * 2f64.powi(-18);
    Ray::new(receiver.position + receiver.normal * (epsilon * epsilons), to_light)
}

fn pixel(world: &World, sun: &Sun, receiver: &Receiver, distance: f64) -> Pixel {
    if !faces(receiver, sun.to_light) {
        return Pixel::TurnedAway;
    }
    if receiver.depth > distance {
        return Pixel::Beyond;
    }
    let blocked = |epsilons| world.is_blocked(&shadow_ray(receiver, sun.to_light, epsilons), 0.0);
    match (blocked(1.0), blocked(2.0)) {
        (true, true) => Pixel::Shadowed,
        (false, false) => Pixel::Lit,
        _ => Pixel::Ambiguous,
    }
}
