//! What every imported scene has in the end: triangles, finite bounds, a camera, a light, and a camera path.
//!
//! Space: world space, metres.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_3};

use glam::{Quat, Vec3};

use super::extent::{self, Extent};
use super::settle::FARTHEST;
use super::warnings::Warnings;
use crate::error::Fault;
use crate::{Aabb, Camera, CameraPath, Instance, Light, PathKey, Scene};

/// A scene smaller than this, metres, is a mistake, and the areas of its triangles would vanish.
const SMALLEST: f32 = 1e-9;

/// From the middle of the scene to the camera that is added: across the light that is added, so shadows show.
const TOWARDS_CAMERA: Vec3 = Vec3::new(-0.6, 0.6, 1.0);

/// The way the light travels that is added.
const SUNLIGHT: Vec3 = Vec3::new(-0.4, -1.0, -0.3);

/// As bright as the sun of the built-in worlds, lux.
const SUN_LUX: f32 = 3.0;

/// Where the quarter orbit is fixed: every 22.5°.
const ORBIT_KEYS: u8 = 5;

/// Adds what the file left out. Cameras whose `far` is infinite get a far plane behind the scene's farthest point.
pub(super) fn finish(scene: &mut Scene, warnings: &mut Warnings) -> Result<(), Fault> {
    if scene.instances.is_empty() {
        return Err(Fault("no triangles in the scene".to_owned()));
    }
    let bounds = bounds(scene);
    let size = 2.0 * radius(bounds);
    if !size.is_finite() || size < SMALLEST {
        return Err(Fault(format!(
            "no triangles in the scene, it is {size:e} m across, need {SMALLEST:e} m"
        )));
    }
    let most = most(scene, bounds);
    if scene.cameras.is_empty() {
        if most != bounds {
            let apart = crate::error::short(f64::from(radius(bounds) / radius(most)));
            let subject = format!("everything is {apart} times as large as what it sees");
            warnings
                .note("the camera that is added looks past what stands far from most of the scene", &subject);
        }
        let mut camera = camera_that_sees(most);
        if most != bounds {
            // What lies far behind is not cut off, nor by rounding.
            camera.far = camera.far.max(1.001 * farthest(&camera, bounds));
        }
        scene.cameras.push(camera);
    }
    for camera in &mut scene.cameras {
        if camera.far.is_infinite() {
            camera.far = farthest(camera, bounds).max(10.0 * camera.near);
        }
    }
    if scene.lights.is_empty() {
        scene.lights.push(Light::sun(SUNLIGHT, SUN_LUX));
    }
    if scene.path.keys.is_empty() {
        scene.path = quarter_orbit(&scene.cameras[0], most.centre());
    }
    Ok(())
}

/// The box around everything at time 0; where all is hidden then, around all that will be seen.
fn bounds(scene: &Scene) -> Aabb {
    let seen = near(scene.boxes_in(&scene.pose(0.0))).fold(Aabb::EMPTY, |sum, (_, bounds)| sum.union(bounds));
    if !seen.is_empty() {
        return seen;
    }
    let of = |of: &Instance| scene.meshes[of.mesh].bounds.transformed(&of.world_from_mesh);
    near(scene.instances.iter().map(|instance| (instance, of(instance))))
        .fold(Aabb::EMPTY, |sum, (_, bounds)| sum.union(bounds))
}

/// What an animation throws farther out than anything may stand is nothing that a camera has to see.
fn near<'a>(boxes: impl Iterator<Item = (&'a Instance, Aabb)>) -> impl Iterator<Item = (&'a Instance, Aabb)> {
    boxes.filter(|(_, bounds)| Extent::of(*bounds).reach() <= FARTHEST)
}

/// The box around everything but what stands far from most, at time 0; `all` where nothing does.
fn most(scene: &Scene, all: Aabb) -> Aabb {
    let of = |(instance, whole): (&Instance, Aabb)| {
        let mesh = &scene.meshes[instance.mesh];
        if instance.is_deformed(mesh) {
            return vec![whole];
        }
        mesh.parts.iter().map(|part| part.bounds.transformed(&instance.world_from_mesh)).collect()
    };
    let pose = scene.pose(0.0);
    let boxes: Vec<Extent> = near(scene.boxes_in(&pose)).flat_map(of).map(Extent::of).collect();
    let most = extent::around_most(&boxes);
    let is_all = boxes.is_empty() || most == extent::around(&boxes);
    if is_all { all } else { Aabb { min: most.min.as_vec3(), max: most.max.as_vec3() } }
}

/// How far from a camera a box can reach.
fn farthest(camera: &Camera, bounds: Aabb) -> f32 {
    camera.eye().distance(bounds.centre()) + radius(bounds)
}

/// A camera that has the whole box in view wherever the picture is at least as wide as high.
fn camera_that_sees(bounds: Aabb) -> Camera {
    let radius = radius(bounds);
    // A sphere fits a cone of half angle 30° at twice its radius; a little air around it.
    let distance = 2.1 * radius;
    let eye = bounds.centre() + TOWARDS_CAMERA.normalize_or_zero() * distance;
    // Near enough to fly around in the scene.
    let (near, far) = (radius / 50.0, distance + 1.1 * radius);
    Camera::looking("overview", eye, bounds.centre(), FRAC_PI_3, near, far)
}

/// Half the diagonal.
fn radius(bounds: Aabb) -> f32 {
    // Squares of small sizes vanish in f32.
    (bounds.size().as_dvec3().length() * 0.5) as f32
}

/// A quarter turn about the vertical through `centre` that ends in the camera's own view.
fn quarter_orbit(camera: &Camera, centre: Vec3) -> CameraPath {
    let from_centre = camera.eye() - centre;
    let ahead = camera.forward() * from_centre.length().max(camera.near);
    let key = |i: u8| {
        let turn = Quat::from_rotation_y(-FRAC_PI_2 * (1.0 - f32::from(i) / f32::from(ORBIT_KEYS - 1)));
        let eye = centre + turn * from_centre;
        PathKey { eye, target: eye + turn * ahead }
    };
    CameraPath { keys: (0..ORBIT_KEYS).map(key).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: Aabb = Aabb { min: Vec3::new(-3.0, 0.0, 5.0), max: Vec3::new(7.0, 2.0, 9.0) };

    #[test]
    fn the_added_camera_has_every_corner_in_view() {
        let camera = camera_that_sees(BOX);
        let camera_from_world = camera.world_from_camera.inverse();
        for corner in 0..8 {
            let pick = |bit: u8, i: usize| if corner >> bit & 1 == 0 { BOX.min[i] } else { BOX.max[i] };
            let seen = camera_from_world.transform_point3(Vec3::new(pick(0, 0), pick(1, 1), pick(2, 2)));
            let depth = -seen.z;
            assert!(camera.near < depth && depth < camera.far, "corner {corner} at depth {depth}");
            assert!(
                seen.x.abs().max(seen.y.abs()) < depth * (FRAC_PI_3 / 2.0).tan(),
                "corner {corner} at {seen}"
            );
        }
    }

    #[test]
    fn the_orbit_ends_in_the_cameras_own_view() {
        let camera = camera_that_sees(BOX);
        let path = quarter_orbit(&camera, BOX.centre());
        let end = path.world_from_camera(1.0).unwrap();
        assert!(
            end.abs_diff_eq(camera.world_from_camera, 1e-4),
            "{end} against {}",
            camera.world_from_camera
        );
        let start = path.world_from_camera(0.0).unwrap();
        assert!(start.w_axis.distance(camera.world_from_camera.w_axis) > 10.0, "it moves: {start}");
    }
}
