//! What a camera sees, and whether the light reaches it: exactly, pixel by pixel.
//!
//! A pixel is judged by the ray through its centre: the first surface it meets (`sight.rs`), and from there a ray to the
//! light, lifted off the surface by ε. What that meets may let a share of the light through (`passage.rs`). A light that stands in the world may stand on a surface too: what is within ε of it is not before
//! it. Where twice the ε changes the answer, the pixel is ambiguous, and not judged; nor where drawing decides which surface it shows,
//! and one is nearer than the other, or their truths differ: a rasteriser puts corners on a grid of 1/256 of a pixel, and edges
//! nearer to a pixel's centre than that may be drawn on either side of it. Nor are pixels whose surface is turned
//! away from the light, or where it does not shine: shading leaves them dark, whatever their shadow.
//!
//! ε, and the angle at which a surface begins to face a light, are what rounding of the world's f32 numbers may have done to
//! a triangle's place and tilt (`triangles.rs`), and to the light's (`shadow_ray.rs`). A surface whose angle to the light is
//! smaller may face it or not: it is ambiguous too. All other surfaces that face it are judged, however aslant.

use glam::DVec3;
use rayon::prelude::*;

use crate::shadow_ray::{reaching, turn};
use crate::sight::Sight;
use crate::{Eye, Light, Ray, Toward, World};

/// A receiver is the first surface that a pixel's ray meets: the first that covers at least half of its place there.
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
    /// Rounding may have moved the surface so far along its normal, in metres, 0 or more: a ray to the light begins as far off it.
    pub lift: f64,
    /// The sine of the angle by which rounding may have tilted the surface.
    pub tilt: f64,
}

/// The truth of a pixel: whether it is judged, and whether the light reaches it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pixel {
    /// The pixel shows no surface.
    Sky,
    /// The light does not shine at the surface, which is outside its cone or beyond its range.
    Unreached,
    /// The surface does not face the light.
    TurnedAway,
    /// The surface is farther away than shadows are asked for.
    Beyond,
    /// It depends on rounding whether the light reaches the surface, or whether the surface faces it, or which surface it is.
    Ambiguous,
    /// The light reaches the surface.
    Lit,
    /// Something blocks the light.
    Shadowed,
    /// What is in the way lets this share of the light through, above 0 and below 1: the product of what each surface does
    /// not cover.
    Partial(f32),
}

/// By how much the visibility of a pixel may change, where rounding decides, without its being ambiguous: half a step of the
/// 8 bits that pictures have.
const SAME: f64 = 0.5 / 255.0;

impl Pixel {
    /// The truth of a judged pixel that a share of the light reaches.
    fn reached(share: f64) -> Self {
        match share as f32 {
            share if share <= 0.0 => Self::Shadowed,
            share if share >= 1.0 => Self::Lit,
            share => Self::Partial(share),
        }
    }

    /// Whether two truths of a pixel are the same but for rounding.
    fn is_as(self, other: Self) -> bool {
        match (self.visibility(), other.visibility()) {
            (Some(a), Some(b)) => f64::from(a - b).abs() <= SAME,
            (Some(_) | None, None) | (None, Some(_)) => self == other,
        }
    }

    /// Whether results are judged at this pixel: it is known for sure how much of the light reaches it.
    pub fn is_judged(self) -> bool {
        self.visibility().is_some()
    }

    /// Returns the true visibility: 1 where lit, 0 where shadowed, the share of light between; `None` where results are not judged.
    pub fn visibility(self) -> Option<f32> {
        match self {
            Self::Lit => Some(1.0),
            Self::Shadowed => Some(0.0),
            Self::Partial(share) => Some(share),
            Self::Sky | Self::Unreached | Self::TurnedAway | Self::Beyond | Self::Ambiguous => None,
        }
    }

    /// Returns how far a visibility, 0 to 1, is from the true one; `None` where results are not judged. Its mean over all
    /// judged pixels is the mean absolute error: it sees what [`Verdict`](crate::Verdict) does not, a shade that stays on
    /// the right side of one half.
    pub fn miss(self, visibility: f32) -> Option<f64> {
        self.visibility().map(|truth| (f64::from(visibility) - f64::from(truth)).abs())
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
                let sight = Sight::of_pixel(world, eye, i);
                (sight.receiver, pixel(world, light, &sight, distance))
            })
            .unzip();
        Self { eye: *eye, light: *light, receivers, pixels }
    }

    /// Returns the number of pixels with that truth.
    pub fn count(&self, wanted: Pixel) -> usize {
        self.pixels.iter().filter(|pixel| **pixel == wanted).count()
    }

    /// Returns the number of pixels that a share of the light reaches.
    pub fn partial(&self) -> usize {
        self.pixels.iter().filter(|pixel| matches!(pixel, Pixel::Partial(_))).count()
    }

    /// Returns the number of judged pixels.
    pub fn judged(&self) -> usize {
        self.pixels.iter().filter(|pixel| pixel.is_judged()).count()
    }
}

/// The centre of one of the eye's pixels, in pixels from the picture's upper left corner.
pub(crate) fn centre(eye: &Eye, pixel: usize) -> [f64; 2] {
    let width = eye.width.max(1) as usize;
    [pixel % width, pixel / width].map(|place| place as f64 + 0.5)
}

/// The ray through the centre of one of the eye's pixels.
pub(crate) fn central_ray(eye: &Eye, pixel: usize) -> Ray {
    let [x, y] = centre(eye, pixel);
    eye.ray(x, y)
}

/// Whether a receiver's surface faces a light; `None` where rounding decides.
fn faces(light: &Light, receiver: &Receiver, toward: &Toward) -> Option<bool> {
    let cosine = receiver.normal.dot(toward.direction);
    // Neither for NaN nor for a surface without area.
    let is_sure = cosine.abs() > receiver.tilt + turn(light, toward.distance);
    is_sure.then_some(cosine > 0.0)
}

/// Whether a light shines at a receiver, and the receiver's surface faces it for sure.
pub(crate) fn can_be_lit(light: &Light, receiver: &Receiver) -> bool {
    light.toward(receiver.position).is_some_and(|toward| faces(light, receiver, &toward) == Some(true))
}

/// What is true of a pixel: of what it sees, where that is the same whatever rounding decides.
pub(crate) fn pixel(world: &World, light: &Light, sight: &Sight, distance: f64) -> Pixel {
    let of = |receiver: &Option<Receiver>| of_receiver(world, light, receiver.as_ref(), distance);
    let pixel = of(&sight.receiver);
    let is_sure = sight.doubts.iter().all(|other| pixel.is_as(of(other)));
    if is_sure && !(sight.is_at_gap && pixel.is_judged()) { pixel } else { Pixel::Ambiguous }
}

/// What is true of a pixel with this first surface, or none.
fn of_receiver(world: &World, light: &Light, receiver: Option<&Receiver>, distance: f64) -> Pixel {
    let Some(receiver) = receiver else {
        return Pixel::Sky;
    };
    let Some(toward) = light.toward(receiver.position) else {
        return Pixel::Unreached;
    };
    let faces = faces(light, receiver, &toward);
    if faces == Some(false) {
        return Pixel::TurnedAway;
    }
    if receiver.depth > distance {
        return Pixel::Beyond;
    }
    if faces.is_none() {
        return Pixel::Ambiguous;
    }
    let [share, farther] = [1.0, 2.0].map(|epsilons| reaching(world, light, receiver, epsilons));
    if (share - farther).abs() <= SAME { Pixel::reached(share) } else { Pixel::Ambiguous }
}
