//! Shadow volumes are exact: against traced shadows they are wrong at no more pixels than the rasteriser rounds.

mod common;

use common::{
    MOST, above, at, camera, court, flat, ground, judge, judge_on, point, scene, sides, small_gpu, spot, sun,
};
use glam::{Mat4, Vec3};
use umbrage_rivals::Family;
use umbrage_scene::{Alpha, Camera, Instance, Lens, Light, Material, Mesh, Motion, Primitive, Scene};

fn agrees(name: &str, scene: &Scene, camera: &Camera, lights: &[Light], seconds: f32) {
    judge(Family::Volumes {}, scene, camera, lights, seconds).agrees(&format!("volumes, {name}"), lights);
}

#[test]
fn suns_spots_and_points_cast_the_shadows_that_rays_find() {
    agrees("court", &court(), &above(), &[sun(), spot(), point()], 0.0);
}

#[test]
fn it_does_not_matter_where_the_camera_stands() {
    let lights = [sun(), point()];
    let inside_a_volume = camera(Vec3::new(-1.5, 0.25, 0.2), Vec3::new(6.0, 0.0, -3.0));
    agrees("inside a volume", &court(), &inside_a_volume, &lights, 0.0);
    // Within the hole of the leaning ring.
    let inside_a_box = camera(Vec3::new(2.0, 2.5, -1.0), Vec3::new(-1.0, 0.0, -1.0));
    agrees("inside a box", &court(), &inside_a_box, &lights, 0.0);
    let mut near_cuts = camera(Vec3::new(-1.5, 2.0, 2.0), Vec3::new(0.5, -0.5, -1.0));
    near_cuts.near = 1.2;
    agrees("the near plane cuts", &court(), &near_cuts, &lights, 0.0);
    let toward = camera(Vec3::new(-6.0, 1.0, 3.0), Vec3::new(-2.0, 2.2, 0.0));
    agrees("toward the light", &court(), &toward, &lights, 0.0);
}

fn parallel(camera: Camera, near: f32, far: f32) -> Camera {
    Camera { lens: Lens::Orthographic { half_height: 6.0 }, near, far, ..camera }
}

#[test]
fn parallel_rays_see_the_same_shadows() {
    let lights = [sun(), spot(), point()];
    agrees("parallel", &court(), &parallel(above(), 1.0, 30.0), &lights, 0.0);
    // Casters before what is nearest, and shadows that go on beyond what is farthest.
    let cut_off = parallel(camera(Vec3::new(0.3, 9.0, 0.2), Vec3::new(0.0, 0.0, 0.1)), 6.5, 9.4);
    agrees("parallel, cut off", &court(), &cut_off, &lights, 0.0);
}

#[test]
fn parallel_rays_may_look_the_way_the_sun_shines() {
    let down = Camera::looking("c", Vec3::new(0.0, 20.0, 0.0), Vec3::ZERO, 1.0, 0.1, 200.0);
    let noon = Light::sun(Vec3::NEG_Y, 1e5);
    let down = parallel(down, 1.0, 40.0);
    let judged = judge(Family::Volumes {}, &court(), &down, &[noon], 0.0);
    let (wrong, pixels, shadowed) = judged.wrong(0);
    assert!(pixels > 1000 && shadowed == 0.0 && wrong <= MOST, "{wrong} of {pixels}, {shadowed}");
    // Nearly so.
    let light = Light::sun(Vec3::new(0.01, -1.0, -0.007), 1e5);
    let judged = judge(Family::Volumes {}, &court(), &down, &[light], 0.0);
    let (wrong, pixels, shadowed) = judged.wrong(0);
    assert!(pixels > 1000 && shadowed > 0.0 && wrong <= MOST, "{wrong} of {pixels}, {shadowed}");
    let level = camera(Vec3::new(-30.0, 1.5, 0.0), Vec3::new(0.0, 1.5, 0.0));
    agrees("parallel, along the light", &court(), &parallel(level, 1.0, 60.0), &[point()], 0.0);
}

#[test]
fn a_place_behind_any_number_of_surfaces_is_in_shadow() {
    let nested = |i: u16| {
        let size = Mat4::from_scale(Vec3::splat(1.0 + f32::from(i) / 1024.0));
        Instance::still(0, Mat4::from_translation(Vec3::new(0.0, 2.5, 0.0)) * size)
    };
    // Eight bits count 256 as none.
    for boxes in [256, 300] {
        let scene = scene(std::iter::once(ground()).chain((0..boxes).map(nested)).collect());
        agrees(&format!("{boxes} nested boxes"), &scene, &above(), &[sun(), spot()], 0.0);
    }
}

#[test]
fn of_a_mesh_with_glass_the_solid_part_is_served_if_it_is_closed() {
    let glass = |height: f32| Primitive { material: 1, ..flat(height) };
    let mut scene = scene(vec![ground(), at(4, -2.0, 1.5, 0.0), at(5, 3.0, 1.5, 0.0)]);
    scene.meshes.push(Mesh::new("box under glass", &[sides(), glass(1.6)]));
    scene.meshes.push(Mesh::new("square under glass", &[flat(0.0), glass(1.6)]));
    let mut veil = Material::plain("glass", 0.5, 0.5, 0.5);
    (veil.alpha, veil.base_colour.w) = (Alpha::Blend, 0.5);
    scene.materials.push(veil);
    let lights = [sun(), point()];
    let judged = judge(Family::Volumes {}, &scene, &above(), &lights, 0.0);
    let left: Vec<_> = judged.left.iter().map(|left| (left.instance, left.parts.as_slice())).collect();
    assert_eq!(left, [(1, [1].as_slice()), (2, [0, 1].as_slice())]);
    judged.agrees("volumes, box under glass", &lights);
}

#[test]
fn a_device_without_timestamps_and_with_counts_of_16_bits_serves_too() {
    let none = wgpu::Features::FLOAT32_BLENDABLE | wgpu::Features::TIMESTAMP_QUERY;
    let gpu = small_gpu(|descriptor| descriptor.required_features.remove(none));
    let judged = judge_on(&gpu, Family::Volumes {}, &court(), &above(), &[sun(), point()], 0.0);
    assert!(judged.seen.milliseconds > 0.0);
    for light in 0..2 {
        let (wrong, pixels, shadowed) = judged.wrong(light);
        assert!(pixels > 1000 && shadowed > 0.01 && wrong <= MOST, "{wrong} of {pixels}, {shadowed}");
    }
}

#[test]
fn a_scene_that_the_device_cannot_hold_is_refused_with_what_it_needs() {
    // 16 bytes a triangle.
    let scene = scene((0..10).map(|i| at(1, i as f32, 0.0, 0.0)).collect());
    let gpu = small_gpu(|descriptor| descriptor.required_limits.max_storage_buffer_binding_size = 1 << 17);
    let refused = Family::Volumes {}.ready(&gpu, &scene).unwrap_err();
    let words = "the pieces of volumes needs 368640 bytes; this adapter's buffers hold 131072";
    assert_eq!(refused.to_string(), words);
}

#[test]
fn mirrored_scaled_and_moving_instances_cast_as_they_stand() {
    let place = |x: f32| Mat4::from_translation(Vec3::new(x, 2.0, 0.0)) * Mat4::from_rotation_z(0.5);
    let motion = Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second: 0.9 };
    let scene = scene(vec![
        ground(),
        Instance::still(1, place(-3.0) * Mat4::from_scale(Vec3::new(-1.5, 0.7, 1.0))),
        Instance::still(0, place(0.0) * Mat4::from_scale(Vec3::new(0.3, -0.9, 0.5))),
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
    let moved = |mut light: Light| {
        light.world_from_light.w_axis += FAR.extend(0.0);
        light
    };
    agrees("far", &scene, &camera, &[sun(), moved(spot()), moved(point())], 0.0);
}

#[test]
fn outside_of_a_caster_that_holds_the_light_all_is_in_shadow() {
    let scene = scene(vec![ground(), at(0, 0.0, 2.0, 0.0), at(1, 4.0, 1.0, 0.0)]);
    let inside = Light::point("inside", Vec3::new(0.2, 2.1, -0.3), 60.0, 1e4);
    let judged = judge(Family::Volumes {}, &scene, &above(), &[inside], 0.0);
    let (wrong, pixels, shadowed) = judged.wrong(0);
    assert!(pixels > 1000 && shadowed == 1.0 && wrong <= MOST, "{wrong} of {pixels}, {shadowed}");
}

#[test]
fn an_open_mesh_is_left_by_name_and_casts_nothing() {
    let scene = scene(vec![ground(), at(2, 0.0, 2.0, 0.0)]);
    let judged = judge(Family::Volumes {}, &scene, &above(), &[sun()], 0.0);
    let left: Vec<_> = judged.left.iter().map(|left| (left.instance, left.why.as_str())).collect();
    assert_eq!(left, [(1, "its mesh is open")]);
    let (wrong, pixels, shadowed) = judged.wrong(0);
    assert!(pixels > 1000 && shadowed == 0.0 && wrong == 0.0, "{wrong} of {pixels}, {shadowed}");
}

#[test]
fn what_casts_nothing_is_not_left() {
    let mut scene = scene(vec![ground(), at(2, 0.0, 2.0, 0.0)]);
    scene.instances[1].casts = false;
    assert_eq!(judge(Family::Volumes {}, &scene, &above(), &[sun()], 0.0).left, []);
}

#[test]
fn the_sky_is_lit_and_so_is_an_empty_world() {
    let upward = camera(Vec3::new(0.0, 1.0, 12.0), Vec3::new(0.0, 90.0, 14.0));
    for scene in [court(), scene(Vec::new())] {
        let judged = judge(Family::Volumes {}, &scene, &upward, &[sun(), point()], 0.0);
        assert!(judged.seen.visibility.iter().flatten().all(|seen| *seen == Some(1.0)));
    }
}
