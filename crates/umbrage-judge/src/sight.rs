//! What a ray of the eye sees first, and what else it may see where it depends on how that is drawn.
//!
//! The eye takes for a surface what covers at least half of its place, and looks through what covers less: so does whoever
//! draws visibility, one answer a pixel.

use crate::coverage::{SEEN, Seen};
use crate::shadow_ray::loss_of_sight;
use crate::truth::{Receiver, centre};
use crate::{Eye, Hit, Ray, World};

/// What a ray of the eye sees.
#[derive(Debug, Default)]
pub(crate) struct Sight {
    /// The first surface; `None` for sky.
    pub receiver: Option<Receiver>,
    /// What it sees instead, if drawing makes what is before it cover a little more or less; mostly nothing.
    pub doubts: Vec<Option<Receiver>>,
    /// Whether depth is discontinuous so near to the pixel's centre that drawing decides which side of the gap it shows.
    pub is_at_gap: bool,
}

/// How far a rasteriser may draw an edge off its place, pixels: it rounds each coordinate of a corner to 1/256.
const SNAP: f64 = std::f64::consts::SQRT_2 / 512.0;

/// Three places around the centre of a pixel, in units of [`SNAP`]: a straight edge within one such unit of the centre has one of
/// them on its other side.
const AROUND: [[f64; 2]; 3] = [[0.0, 2.0], [1.732_050_807_568_877_3, -1.0], [-1.732_050_807_568_877_3, -1.0]];

impl Sight {
    /// What the centre of a pixel sees, and what is drawn there instead if a rasteriser moves an edge that lies so near to it.
    pub fn of_pixel(world: &World, eye: &Eye, pixel: usize) -> Self {
        let [x, y] = centre(eye, pixel);
        let mut sight = Self::new(world, eye, &eye.ray(x, y));
        for [right, down] in AROUND {
            let ray = eye.ray(x + SNAP * right, y + SNAP * down);
            let beside = receiver(world, eye, &ray);
            if beside.map(|beside| beside.triangle) != sight.receiver.map(|seen| seen.triangle) {
                sight.is_at_gap |= is_at_gap(eye, &ray, sight.receiver.as_ref(), beside.as_ref());
                sight.doubts.push(beside);
            }
        }
        sight
    }

    /// What a ray of the eye sees.
    pub fn new(world: &World, eye: &Eye, ray: &Ray) -> Self {
        let mut sight = Self::default();
        let (mut from, mut is_found) = (eye.near, false);
        while let Some(hit) = world.first_seen(ray, from, eye.far) {
            let Seen { coverage, drawn } = world.seen(ray, hit.triangle);
            let receiver = Some(surface(world, ray, hit));
            if coverage >= SEEN && !is_found {
                sight.receiver = receiver;
                is_found = true;
            } else {
                sight.doubts.push(receiver);
            }
            if drawn[0] >= SEEN {
                return sight;
            }
            from = hit.distance.next_up();
        }
        // The sky is behind them all.
        if is_found {
            sight.doubts.push(None);
        }
        sight
    }
}

/// Whether depth is discontinuous between what is seen and what a ray sees beside it, or one of them is sky.
fn is_at_gap(eye: &Eye, ray: &Ray, seen: Option<&Receiver>, beside: Option<&Receiver>) -> bool {
    let (Some(seen), Some(beside)) = (seen, beside) else { return seen.is_some() != beside.is_some() };
    let plane = (seen.position - ray.origin).dot(seen.normal) / ray.direction.dot(seen.normal);
    // An edge at which both meet is no gap. Neither is a plane that the ray runs along, which is NaN.
    (beside.depth - plane).abs() > 0.25 * eye.pixel_metres(seen.depth)
}

/// The first surface along a ray of the eye.
pub(crate) fn receiver(world: &World, eye: &Eye, ray: &Ray) -> Option<Receiver> {
    Sight::new(world, eye, ray).receiver
}

/// The surface that a ray of the eye meets.
pub(crate) fn surface(world: &World, ray: &Ray, Hit { distance, triangle }: Hit) -> Receiver {
    let normal = world.normal(triangle);
    let normal = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
    let position = ray.at(distance);
    let lost = loss_of_sight(world, position, distance * ray.direction.length());
    let (lift, tilt) = (world.triangles.lift(triangle) + lost, world.triangles.tilt(triangle));
    Receiver { position, normal, depth: distance, triangle, lift, tilt }
}
