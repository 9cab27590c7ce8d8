//! Lights that someone moved: where they stand and which way they shine instead, and how a pointer drags them.
//!
//! A point light is dragged in the plane through it that faces the camera. A sun, or the aim of a spot, is dragged on a sphere: its
//! handle lies where the light comes from, and the middle of the sphere is what it shines at.

use std::collections::BTreeMap;

use glam::{Mat4, Vec3};
use umbrage::Camera;
use umbrage_scene::{Light, LightKind, Motion, Pose};

/// The lights that were moved, by their numbers in the scene, from 0.
pub type MovedLights = BTreeMap<usize, MovedLight>;

/// What of a light is not as the scene has it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MovedLight {
    /// The light's position, world space, metres; `None` where the scene says it.
    pub position: Option<Vec3>,
    /// The direction in which its light travels, of any length but zero; `None` where the scene says it.
    pub direction: Option<Vec3>,
}

impl MovedLight {
    /// Returns a light of a scene as it is moved. It stands still from then on.
    pub fn of(&self, light: &Light, pose: &Pose) -> Light {
        let place = light.world_from_light_in(pose);
        let at = self.position.unwrap_or(place.w_axis.truncate());
        let rotation = self.direction.map_or(place, |direction| Light::sun(direction, 1.0).world_from_light);
        let world_from_light = Mat4 { w_axis: at.extend(1.0), ..rotation };
        Light { world_from_light, motion: Motion::Still, ..light.clone() }
    }
}

/// What of a light a handle moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Where it stands.
    At,
    /// Which way it shines.
    Way,
}

/// Returns the parts of a light that can be moved.
pub fn parts(light: &Light) -> &'static [Part] {
    match light.kind {
        LightKind::Directional => &[Part::Way],
        LightKind::Spot { .. } => &[Part::At, Part::Way],
        LightKind::Point { .. } => &[Part::At],
    }
}

/// Where a light's handles lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle {
    /// Where the handle is, world space.
    pub point: Vec3,
    /// The middle of the sphere that it is dragged on; absent where it is dragged in a plane.
    pub middle: Option<Vec3>,
}

impl Handle {
    /// Returns the handle of a part of a light. `target` is what the camera looks at, and `reach` the radius of spheres, metres.
    pub fn of(light: &Light, part: Part, target: Vec3, reach: f32) -> Self {
        let at = light.position();
        match (part, light.kind) {
            (Part::At, _) => Self { point: at, middle: None },
            // A sun comes from its handle, and a spot aims at it.
            (Part::Way, LightKind::Directional) => {
                Self { point: target - light.direction() * reach, middle: Some(target) }
            }
            (Part::Way, _) => Self { point: at + light.direction() * reach, middle: Some(at) },
        }
    }

    /// Returns where the handle is when the pointer is at a place of the picture, given in NDC; `None` where that cannot be.
    pub fn dragged(&self, camera: &Camera, x: f32, y: f32) -> Option<Vec3> {
        let (origin, direction) = ray(camera, x, y)?;
        let point = match self.middle {
            None => {
                let forward = camera.forward();
                let along = (self.point - origin).dot(forward) / direction.dot(forward);
                (along > 0.0).then(|| origin + direction * along)?
            }
            Some(middle) => on_sphere(origin, direction, middle, self.point),
        };
        point.is_finite().then_some(point)
    }

    /// Returns the move of a light whose handle for a part was dragged to a point.
    pub fn moved(&self, light: &Light, part: Part, before: MovedLight, point: Vec3) -> MovedLight {
        match (part, self.middle) {
            (Part::At, _) => MovedLight { position: Some(point), ..before },
            (Part::Way, middle) => {
                let outward = point - middle.unwrap_or(light.position());
                let way = if light.kind == LightKind::Directional { -outward } else { outward };
                MovedLight { direction: way.try_normalize().or(before.direction), ..before }
            }
        }
    }
}

/// The ray through a place of the picture: its origin and unit direction. Both come from the lens and the camera's axes, so
/// the direction is as exact far from the world's origin as there.
fn ray(camera: &Camera, x: f32, y: f32) -> Option<(Vec3, Vec3)> {
    let (lens, world_from_view) = (camera.clip_from_view(), camera.world_from_view());
    let is_parallel = lens.w_axis.w != 0.0;
    let middle = if is_parallel { lens.w_axis } else { -lens.z_axis };
    let across = Vec3::new((x - middle.x) / lens.x_axis.x, (y - middle.y) / lens.y_axis.y, 0.0);
    let (origin, direction) =
        if is_parallel { (across, Vec3::NEG_Z) } else { (Vec3::ZERO, across + Vec3::NEG_Z) };
    let direction = world_from_view.transform_vector3(direction).try_normalize()?;
    Some((world_from_view.transform_point3(origin), direction))
}

/// The point of a sphere around `middle` through `was` that a ray meets on the side of `was`, or comes nearest to.
fn on_sphere(origin: Vec3, direction: Vec3, middle: Vec3, was: Vec3) -> Vec3 {
    let radius = was.distance(middle);
    let closest = origin + direction * (middle - origin).dot(direction);
    let aside = closest.distance(middle);
    if aside >= radius {
        return middle + (closest - middle).normalize_or_zero() * radius;
    }
    let half = direction * (radius * radius - aside * aside).sqrt();
    let [near, far] = [closest - half, closest + half];
    if (was - middle).dot(direction) > 0.0 { far } else { near }
}

/// Projects a point onto the picture, in shares of its size from the upper left corner; `None` behind the eye.
pub fn project(camera: &Camera, point: Vec3) -> Option<[f32; 2]> {
    let [x, y, _, w] = (camera.clip_from_world() * point.extend(1.0)).to_array();
    (w > 0.0).then(|| [0.5 + 0.5 * x / w, 0.5 - 0.5 * y / w])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        let camera =
            umbrage_scene::Camera::looking("c", Vec3::new(0.0, 5.0, 20.0), Vec3::ZERO, 1.0, 0.5, 100.0);
        umbrage_render::camera(&camera, 1.5).expect("a camera")
    }

    /// The place of a point in NDC.
    fn ndc(point: Vec3) -> [f32; 2] {
        let [x, y] = project(&camera(), point).expect("before the eye");
        [2.0 * x - 1.0, 1.0 - 2.0 * y]
    }

    #[test]
    fn a_handle_that_is_dragged_to_where_it_is_stays_and_one_that_is_dragged_follows_the_pointer() {
        let sun = Light::sun(Vec3::new(0.4, -1.0, -0.3), 1.0);
        let lamp = Light::point("lamp", Vec3::new(2.0, 3.0, -4.0), 50.0, 9.0);
        let spot = Light::spot("spot", Vec3::new(-2.0, 6.0, 1.0), Vec3::ZERO, 0.4, 0.8, 50.0, 100.0);
        for light in [&sun, &lamp, &spot] {
            for part in parts(light) {
                let handle = Handle::of(light, *part, Vec3::ZERO, 7.0);
                let [x, y] = ndc(handle.point);
                let same = handle.dragged(&camera(), x, y).expect("a point");
                assert!(same.distance(handle.point) < 1e-3, "{}, {part:?}: {same} {handle:?}", light.name);
                let there = handle.dragged(&camera(), x + 0.02, y - 0.03).expect("a point");
                let [u, v] = ndc(there);
                assert!((u - x - 0.02).abs() + (v - y + 0.03).abs() < 1e-3, "{}, {part:?}", light.name);
                let moved =
                    handle.moved(light, *part, MovedLight::default(), there).of(light, &Pose::default());
                let follows = Handle::of(&moved, *part, Vec3::ZERO, 7.0).point;
                assert!(follows.distance(there) < 1e-3, "{}, {part:?}: {follows} {there}", light.name);
            }
        }
    }

    #[test]
    fn a_ray_is_as_exact_5_km_from_the_origin_as_there() {
        let there = Vec3::new(5000.0, 0.0, 5000.0);
        let eye = there + Vec3::new(0.0, 5.0, 20.0);
        let scene = umbrage_scene::Camera::looking("c", eye, there, 1.0, 0.5, 100.0);
        let far = umbrage_render::camera(&scene, 1.5).expect("a camera");
        for (x, y) in [(0.0, 0.0), (0.3, -0.7), (-1.0, 1.0)] {
            let [near, far] = [&camera(), &far].map(|camera| ray(camera, x, y).expect("a ray"));
            assert!(near.1.distance(far.1) < 1e-6, "{x} {y}: {near:?} {far:?}");
            let share = project(&camera(), near.0 + near.1 * 10.0).expect("before the eye");
            let place = [2.0 * share[0] - 1.0, 1.0 - 2.0 * share[1]];
            assert!((place[0] - x).abs() + (place[1] - y).abs() < 1e-5, "{x} {y}: {place:?}");
        }
    }

    #[test]
    fn beside_its_sphere_a_sun_goes_to_the_rim() {
        let handle = Handle::of(&Light::sun(Vec3::NEG_Y, 1.0), Part::Way, Vec3::ZERO, 3.0);
        let rim = handle.dragged(&camera(), 1.0, 0.0).expect("a point");
        assert!((rim.length() - 3.0).abs() < 1e-4 && rim.x > 2.0, "{rim}");
    }

    #[test]
    fn what_is_not_moved_of_a_light_stays() {
        let spot = Light::spot("spot", Vec3::new(-2.0, 6.0, 1.0), Vec3::ZERO, 0.4, 0.8, 50.0, 100.0);
        let moved = MovedLight { position: Some(Vec3::ONE), direction: None }.of(&spot, &Pose::default());
        assert!(moved.position() == Vec3::ONE && moved.direction().abs_diff_eq(spot.direction(), 1e-6));
        assert_eq!((moved.intensity, moved.kind), (spot.intensity, spot.kind));
    }
}
