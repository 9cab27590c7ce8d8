//! One pixel looked at closely: what is seen there, how much of a light reaches it, what is in the way, and how much
//! reaches the places beside it.

use glam::DVec3;

use crate::shadow_ray::{ShadowRay, reaching};
use crate::sight::Sight;
use crate::truth::pixel;
use crate::{Eye, Light, Pixel, Receiver, World};

/// What is true of one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inspected {
    /// The surface that is seen.
    pub receiver: Receiver,
    /// How much of the light reaches it. No surface is too far away.
    pub truth: Pixel,
    /// The distance to the nearest caster on the way to the light, in metres; `None` where there is none.
    pub blocker: Option<f64>,
}

impl World {
    /// Inspects the centre of a pixel, counted from the picture's upper left corner; `None` where it shows the sky.
    pub fn inspect(&self, eye: &Eye, light: &Light, [x, y]: [u32; 2]) -> Option<Inspected> {
        let sight = Sight::of_pixel(self, eye, y as usize * eye.width as usize + x as usize);
        let receiver = sight.receiver?;
        let truth = pixel(self, light, &sight, f64::INFINITY);
        let blocker = self.first_caster(&ShadowRay::of(self, light, &receiver, 1.0)).map(|hit| hit.distance);
        Some(Inspected { receiver, truth, blocker })
    }

    /// Traces the share of a light, 0 to 1, that reaches a receiver's plane beside the receiver: where a step across the light,
    /// in metres, and then along the light, leads to. `None` where the light does not shine.
    pub fn reaching_beside(&self, light: &Light, receiver: &Receiver, step: DVec3) -> Option<f64> {
        let to_light = light.toward(receiver.position)?.direction;
        let cosine = receiver.normal.dot(to_light).max(1e-6);
        let along = -receiver.normal.dot(step) / cosine;
        let beside = Receiver { position: receiver.position + step + to_light * along, ..*receiver };
        light.toward(beside.position)?;
        Some(reaching(self, light, &beside, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use umbrage_scene::Camera;

    use super::*;

    /// A plate of 2 m, 1 m over a ground that is seen from above.
    fn world() -> World {
        let square = |y: f32, half: f32| {
            let corner = |x: f32, z: f32| Vec3::new(x * half, y, z * half);
            let [a, b, c, d] = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
            [[a, b, c], [a, c, d]]
        };
        World::of_triangles([square(0.0, 10.0), square(1.0, 1.0)].concat())
    }

    #[test]
    fn a_pixel_in_shadow_has_a_blocker_and_light_beside_it() {
        let camera = Camera::looking("c", Vec3::new(0.0, 0.5, 6.0), Vec3::ZERO, 0.5, 0.1, 100.0);
        let eye = Eye::new(&camera, 65, 65);
        let (world, sun) = (world(), Light::sun(Vec3::NEG_Y));
        let seen = world.inspect(&eye, &sun, [32, 32]).expect("the ground");
        assert!(seen.receiver.position.length() < 1e-6, "{seen:?}");
        assert_eq!(seen.truth, Pixel::Shadowed);
        assert!((seen.blocker.expect("the plate") - 1.0).abs() < 1e-6, "{seen:?}");
        let beside = |x: f64| world.reaching_beside(&sun, &seen.receiver, DVec3::X * x);
        assert_eq!([beside(0.9), beside(1.1)], [Some(0.0), Some(1.0)]);
        assert_eq!(world.inspect(&eye, &sun, [32, 0]), None, "the sky");
    }
}
