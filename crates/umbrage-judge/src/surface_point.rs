//! Whether a light reaches a point of a surface, whoever looks at it: what is baked, and not what an eye sees.
//!
//! The ray begins as far off the surface as a pixel's does (`truth.rs`), on the side that faces the light.

use glam::DVec3;

use crate::shadow_ray::{ShadowRay, reaching};
use crate::triangles::normal;
use crate::{Light, Receiver, Triangles, World};

/// A surface point is a point of one triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The point in world space, in metres.
    pub position: DVec3,
    /// The unit normal of the triangle by its winding; zero for one without area.
    pub normal: DVec3,
    /// Rounding may have moved the surface so far along its normal, in metres, 0 or more: a ray to the light begins as far off it.
    pub lift: f64,
}

impl Triangles {
    /// Returns the corners of every triangle, in world space and metres: those of a scene's instances one after the other, each
    /// with its mesh's triangles in their order. Instances that are not seen in the pose have none.
    pub fn corners(&self) -> &[[DVec3; 3]] {
        &self.corners
    }

    /// Returns only the triangles that never move, in the same order.
    #[must_use]
    pub fn standing(&self) -> Self {
        self.only(|i| self.still[i])
    }

    /// Returns only the triangles with some indices, in the same order.
    #[must_use]
    pub fn only(&self, is_kept: impl Fn(usize) -> bool) -> Self {
        self.in_order((0..self.corners.len()).filter(|i| is_kept(*i)))
    }

    /// Returns the point of a triangle at which its corners count so much; the weights sum to 1.
    pub fn point(&self, triangle: usize, weights: [f64; 3]) -> SurfacePoint {
        let corners = &self.corners[triangle];
        let position = corners.iter().zip(weights).map(|(corner, weight)| *corner * weight).sum();
        SurfacePoint { position, normal: normal(corners), lift: self.lift(triangle) }
    }
}

impl World {
    /// Traces the share of a light, 0 to 1, that reaches the side of a surface that faces it; `None` where the light does not
    /// shine.
    pub fn visibility(&self, light: &Light, point: &SurfacePoint) -> Option<f64> {
        Some(reaching(self, light, &receiver(light, point)?, 1.0))
    }

    /// Whether the first triangle on the way from a point to a light turns its back: the point is inside a body, if all
    /// triangles of this world bound bodies and face outward.
    pub fn encloses(&self, light: &Light, point: &SurfacePoint) -> bool {
        let to_light = receiver(light, point).map(|receiver| ShadowRay::of(self, light, &receiver, 1.0));
        to_light.is_some_and(|ShadowRay { ray, end, .. }| {
            let first = self.first_hit(&ray, 0.0, end);
            first.is_some_and(|hit| self.normal(hit.triangle).dot(ray.direction) > 0.0)
        })
    }
}

/// The side of a point that faces a light, if the light shines there.
fn receiver(light: &Light, point: &SurfacePoint) -> Option<Receiver> {
    let SurfacePoint { position, normal, lift } = *point;
    let toward = light.toward(position)?;
    let normal = if normal.dot(toward.direction) < 0.0 { -normal } else { normal };
    Some(Receiver { position, normal, depth: 0.0, triangle: 0, lift, tilt: 0.0 })
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use umbrage_scene::{Pose, worlds};

    use super::*;
    use crate::{Eye, Truth};

    #[test]
    fn a_point_of_a_surface_is_lit_as_the_pixel_that_shows_it() {
        let scene = worlds::build("primitives", 0).expect("a world");
        let pose = Pose::at(0.0);
        let triangles = Triangles::of(&scene, &pose);
        assert_eq!(triangles.standing().corners().len(), triangles.corners().len(), "nothing moves there");
        let world = World::build(triangles);
        let (light, eye) = (Light::of(&scene.lights[0]), Eye::new(&scene.cameras[0], 64, 36));
        let truth = Truth::new(&world, &eye, &light, f64::INFINITY);
        let judged = truth.receivers.iter().zip(&truth.pixels).filter(|(_, pixel)| pixel.is_judged());
        let mut compared = 0;
        for (receiver, pixel) in judged {
            let Receiver { position, normal, lift, .. } = receiver.expect("judged pixels show something");
            let visibility = world.visibility(&light, &SurfacePoint { position, normal, lift });
            assert_eq!(visibility.map(|share| share as f32), pixel.visibility());
            compared += 1;
        }
        assert!(compared > 500, "{compared} pixels");
    }

    #[test]
    fn a_sheet_is_lit_from_both_sides_and_nothing_where_a_lamp_ends() {
        let triangles = Triangles::in_world(&[[Vec3::ZERO, Vec3::X, Vec3::Z]]);
        let point = triangles.point(0, [0.5, 0.25, 0.25]);
        assert_eq!(point.position, DVec3::new(0.25, 0.0, 0.25));
        let world = World::build(triangles);
        for direction in [Vec3::Y, Vec3::NEG_Y] {
            assert_eq!(world.visibility(&Light::sun(direction), &point), Some(1.0));
        }
        let lamp = Light::Point { position: DVec3::Y * 3.0, range: 2.0, near: 0.0 };
        assert_eq!(world.visibility(&lamp, &point), None);
    }

    #[test]
    fn a_point_is_inside_where_the_light_comes_through_a_back() {
        let [a, b, c] = [Vec3::new(-9.0, 1.0, -9.0), Vec3::new(0.0, 1.0, 9.0), Vec3::new(9.0, 1.0, -9.0)];
        let point = SurfacePoint { position: DVec3::ZERO, normal: DVec3::Y, lift: 0.0 };
        for (roof, is_inside) in [([a, b, c], true), ([a, c, b], false)] {
            let world = World::of_triangles(vec![roof]);
            assert_eq!(
                world.encloses(&Light::sun(Vec3::NEG_Y), &point),
                is_inside,
                "a face that faces up first"
            );
            assert!(!world.encloses(&Light::sun(Vec3::Y), &point), "nothing below");
        }
    }
}
