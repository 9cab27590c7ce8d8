//! Planar shadows are exact where they know anything: on planes.

mod common;

use common::{above, at, camera, court, ground, judge, point, scene, spot, sun};
use glam::{Mat4, Vec3};
use umbrage_rivals::Family;
use umbrage_scene::{Camera, Instance, Lens, Light, Motion, Scene};

fn agrees(name: &str, scene: &Scene, camera: &Camera, lights: &[Light], seconds: f32) {
    judge(Family::Planar {}, scene, camera, lights, seconds).agrees(&format!("planar, {name}"), lights);
}

#[test]
fn suns_spots_and_points_cast_the_shadows_that_rays_find() {
    agrees("court", &court(), &above(), &[sun(), spot(), point()], 0.0);
}

#[test]
fn parallel_rays_see_the_same_shadows() {
    let camera = Camera { lens: Lens::Orthographic { half_height: 6.0 }, near: 1.0, far: 30.0, ..above() };
    agrees("parallel", &court(), &camera, &[sun(), spot(), point()], 0.0);
}

#[test]
fn open_mirrored_and_moving_instances_cast_as_they_stand() {
    let place = |x: f32| Mat4::from_translation(Vec3::new(x, 2.0, 0.0)) * Mat4::from_rotation_z(0.5);
    let motion = Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second: 0.9 };
    let scene = scene(vec![
        ground(),
        Instance::still(1, place(-3.0) * Mat4::from_scale(Vec3::new(-1.5, 0.7, 1.0))),
        Instance::still(2, place(0.0)),
        Instance { motion, ..Instance::still(1, place(3.5)) },
    ]);
    agrees("mirrored", &scene, &above(), &[sun(), spot(), point()], 2.5);
}

#[test]
fn a_world_far_from_its_origin_is_like_any_other() {
    const FAR: Vec3 = Vec3::new(200_000.0, 0.0, -131_072.0);
    let mut scene = court();
    for instance in &mut scene.instances {
        instance.world_from_mesh.w_axis += FAR.extend(0.0);
    }
    let mut camera = above();
    camera.world_from_camera.w_axis += FAR.extend(0.0);
    let mut lamp = point();
    lamp.world_from_light.w_axis += FAR.extend(0.0);
    agrees("far", &scene, &camera, &[sun(), lamp], 0.0);
}

#[test]
fn what_is_behind_a_plane_or_beyond_a_lamp_casts_nothing_on_it() {
    let under = Instance::still(
        2,
        Mat4::from_translation(Vec3::new(0.0, 1.0, 0.0)) * Mat4::from_scale(Vec3::splat(8.0)),
    );
    let scene = scene(vec![under, at(1, 0.0, 0.2, 0.0), at(0, 0.0, 7.0, 0.0)]);
    let lamp = Light::point("lamp", Vec3::new(0.0, 4.0, 0.0), 60.0, 1e4);
    let judged = judge(Family::Planar {}, &scene, &above(), &[lamp], 0.0);
    let (wrong, pixels, shadowed) = judged.wrong(0);
    assert!(pixels > 1000 && shadowed == 0.0 && wrong == 0.0, "{wrong} of {pixels}, {shadowed}");
}

#[test]
fn a_wall_that_cuts_a_caster_has_the_shadow_of_what_is_before_it() {
    let wall = Mat4::from_translation(Vec3::new(0.0, 0.0, -1.0)) * Mat4::from_rotation_x(1.570_796_4);
    let scene = scene(vec![
        ground(),
        Instance::still(2, wall * Mat4::from_scale(Vec3::splat(6.0))),
        at(0, 0.0, 1.5, -0.8),
    ]);
    let toward = camera(Vec3::new(1.0, 3.0, 8.0), Vec3::new(0.0, 1.0, -1.0));
    agrees("wall", &scene, &toward, &[Light::sun(Vec3::new(0.4, -0.5, -1.0), 1.0), point()], 0.0);
}

#[test]
fn of_what_is_round_nothing_is_said_and_the_sky_is_lit() {
    let scene = scene(vec![at(1, 0.0, 1.0, 0.0)]);
    let judged = judge(Family::Planar {}, &scene, &above(), &[sun()], 0.0);
    let known = judged.pixels[0].iter().zip(&judged.seen.visibility[0]);
    for (pixel, seen) in known {
        // Rounding may let a pixel of the rim be sky.
        let is_sky = matches!(pixel, umbrage_judge::Pixel::Sky | umbrage_judge::Pixel::Ambiguous);
        assert!(
            *seen == is_sky.then_some(1.0) || *pixel == umbrage_judge::Pixel::Ambiguous,
            "{pixel:?}: {seen:?}"
        );
    }
    assert!(judged.unknown(0) > 500, "{}", judged.unknown(0));
}
