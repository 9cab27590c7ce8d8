//! Light maps, judged by rays: as fine as their bytes, and baked no more than once.

mod common;

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use common::site::{self, camera, lamp, sun};
use common::{SIZE, gpu, pixel_at, small_gpu, truth};
use glam::Vec3;
use umbrage_judge::Tally;
use umbrage_render::Gpu;
use umbrage_rivals::{
    BakeStep, Family, Left, LightMapOptions, LightMaps, Rival as _, RivalError, Seen, View,
};
use umbrage_scene::{Alpha, Camera, Light, Motion, Pose, Scene};

fn options(bytes: u64) -> LightMapOptions {
    LightMapOptions { bytes, ..LightMapOptions::default() }
}

fn baked(gpu: &Gpu, scene: &Scene, light: &Light, bytes: u64, folder: Option<&Path>) -> LightMaps {
    let lights = std::slice::from_ref(light);
    LightMaps::bake(gpu, scene, (lights, &Pose::default()), options(bytes), folder, &|_| true).expect("baked")
}

fn see(maps: &mut LightMaps, camera: &Camera, light: &Light) -> Seen {
    let view = View { camera, lights: std::slice::from_ref(light), pose: &Arc::default(), size: SIZE };
    maps.see(&view).expect("seen")
}

/// How wrong what was seen of a light is where it is known, in a world in which what is left casts nothing.
fn tally(scene: &Scene, left: &[Left], camera: &Camera, light: &Light, seen: &[Option<f32>]) -> Tally {
    common::tally(&truth(scene, left, camera, light, &Pose::default()).pixels, seen)
}

#[test]
fn error_falls_with_bytes_under_a_sun_and_under_a_lamp() {
    let (gpu, place) = (gpu(), Vec3::ZERO);
    let (scene, camera) = (site::scene(place), camera(place));
    for light in [sun(), lamp(place)] {
        let error = |bytes| {
            let mut maps = baked(&gpu, &scene, &light, bytes, None);
            assert!(maps.texels().len() as u64 <= bytes, "{} texels in {bytes} bytes", maps.texels().len());
            let seen = see(&mut maps, &camera, &light);
            let tally = tally(&scene, maps.left(), &camera, &light, &seen.visibility[0]);
            assert!(tally.judged > 15_000, "{} pixels judged", tally.judged);
            tally.mis_shadowed()
        };
        let errors = [16 << 10, 64 << 10, 256 << 10].map(error);
        assert!(errors[0] > 1.2 * errors[1] && errors[1] > 1.2 * errors[2], "{}: {errors:?}", light.name);
        assert!(errors[0] > 3.0 * errors[2], "texels of a quarter of the length, {}: {errors:?}", light.name);
        assert!(errors[2] < 0.003, "{}: {errors:?}", light.name);
    }
}

#[test]
fn shadows_are_the_same_200_km_from_the_origin() {
    let gpu = gpu();
    let errors = [Vec3::ZERO, Vec3::new(2e5, 0.0, -1.5e5)].map(|place| {
        let (scene, camera) = (site::scene(place), camera(place));
        let mut maps = baked(&gpu, &scene, &sun(), 1 << 20, None);
        let seen = see(&mut maps, &camera, &sun());
        tally(&scene, maps.left(), &camera, &sun(), &seen.visibility[0]).mis_shadowed()
    });
    assert!(errors[1] < 0.003 && (errors[0] - errors[1]).abs() < 0.001, "{errors:?}");
}

#[test]
fn the_dark_side_of_a_wall_does_not_bleed_to_the_lit_one() {
    let gpu = gpu();
    // 2 cm thin, and texels of some 10 cm.
    let ground = (Vec3::new(0.0, -0.5, 0.0), Vec3::new(20.0, 1.0, 20.0));
    let scene = site::boxes(Vec3::ZERO, &[ground, (Vec3::Y, Vec3::new(4.0, 2.0, 0.02))]);
    let light = Light::sun(Vec3::new(0.0, -1.0, -1.0), 1e5);
    let mut maps = baked(&gpu, &scene, &light, 64 << 10, None);
    assert!((5.0..20.0).contains(&maps.texels_per_metre()), "{} texels a metre", maps.texels_per_metre());
    let lit = Camera::looking("lit", Vec3::new(0.0, 2.0, 6.0), Vec3::Y, 0.9, 0.1, 60.0);
    let dark = Camera::looking("dark", Vec3::new(0.0, 4.0, -6.0), Vec3::Y, 0.9, 0.1, 60.0);
    let (from_light, from_behind) = (see(&mut maps, &lit, &light), see(&mut maps, &dark, &light));
    for x in [-1.95, -1.0, 0.0, 1.0, 1.95] {
        for y in [0.05, 1.0, 1.95] {
            assert_eq!(pixel_at(&lit, &from_light, Vec3::new(x, y, 0.01)), Some(1.0), "the wall at {x}, {y}");
        }
        let behind = pixel_at(&dark, &from_behind, Vec3::new(0.9 * x, 0.0, -0.3));
        assert_eq!(behind, Some(0.0), "the ground behind the wall at {x}");
    }
}

#[test]
fn what_moves_is_left_and_neither_casts_nor_receives() {
    let (gpu, place) = (gpu(), Vec3::ZERO);
    let (mut scene, camera) = (site::scene(place), camera(place));
    scene.instances[2].motion =
        Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second: 1.0 };
    let mut maps = baked(&gpu, &scene, &sun(), 1 << 20, None);
    assert_eq!(maps.left().iter().map(|left| left.instance).collect::<Vec<_>>(), [2]);
    let seen = see(&mut maps, &camera, &sun());
    assert_eq!(pixel_at(&camera, &seen, Vec3::new(1.0, 1.0, 2.0)), None, "its upper side");
    assert_eq!(pixel_at(&camera, &seen, Vec3::new(1.7, 0.0, 2.4)), Some(1.0), "where its shadow would be");
    let tally = tally(&scene, maps.left(), &camera, &sun(), &seen.visibility[0]);
    assert!(tally.judged > 15_000 && tally.mis_shadowed() < 0.003, "{tally:?}");
}

#[test]
fn what_is_seen_through_hides_what_is_behind_it_and_is_not_known() {
    let (gpu, place) = (gpu(), Vec3::ZERO);
    let (mut scene, camera) = (site::scene(place), camera(place));
    scene.materials[0].alpha = Alpha::Blend;
    scene.materials[0].base_colour.w = 0.5;
    let mut maps = baked(&gpu, &scene, &sun(), 1 << 20, None);
    let seen = see(&mut maps, &camera, &sun());
    assert_eq!(pixel_at(&camera, &seen, Vec3::ZERO), None);
    assert!(maps.left().is_empty() && seen.visibility[0].iter().all(|share| share.is_none_or(|s| s == 1.0)));
}

#[test]
fn a_light_that_was_not_baked_is_not_known() {
    let (gpu, place) = (gpu(), Vec3::ZERO);
    let (mut scene, camera) = (site::scene(place), camera(place));
    scene.lights = vec![sun(), lamp(place)];
    let family = Family::LightMaps { bytes: 1 << 20, rays: 1 };
    let mut maps = family.ready(&gpu, &scene).expect("ready");
    let before = maps.bytes();
    let other = Light::sun(Vec3::NEG_Y, 1.0);
    let lights = [lamp(place), other, sun(), lamp(place), sun()];
    let view = View { camera: &camera, lights: &lights, pose: &Arc::default(), size: SIZE };
    let seen = maps.see(&view).expect("seen");
    assert_eq!(seen.visibility.len(), 5);
    assert!(seen.visibility[1].iter().all(Option::is_none));
    assert!(seen.visibility[0] == seen.visibility[3] && seen.visibility[2] == seen.visibility[4]);
    for (light, seen) in [(&lights[0], &seen.visibility[3]), (&lights[2], &seen.visibility[4])] {
        let error = tally(&scene, &[], &camera, light, seen).mis_shadowed();
        assert!(error < 0.005, "{}: {error}", light.name);
    }
    assert!(seen.milliseconds > 0.0 && before > 500_000);
    assert_eq!(maps.bytes() - before, 8 * u64::from(SIZE[0] * SIZE[1]), "the picture counts");
}

#[test]
fn a_bake_that_was_cut_off_goes_on_and_comes_to_the_same() {
    let (gpu, folder) = (gpu(), tempfile::tempdir().expect("a folder"));
    let (scene, light) = (site::scene(Vec3::ZERO), lamp(Vec3::ZERO));
    let whole = baked(&gpu, &scene, &light, 256 << 10, None);
    let (bands, lights) = (AtomicUsize::new(0), std::slice::from_ref(&light));
    let cut_off = LightMaps::bake(
        &gpu,
        &scene,
        (lights, &Pose::default()),
        options(256 << 10),
        Some(folder.path()),
        &|p| p.step != BakeStep::Trace || bands.fetch_add(1, Ordering::Relaxed) < 7,
    );
    assert!(matches!(cut_off, Err(RivalError::Cancelled)), "{cut_off:?}");
    let again = baked(&gpu, &scene, &light, 256 << 10, Some(folder.path()));
    assert!(0 < again.rays() && again.rays() < whole.rays(), "{} of {} rays", again.rays(), whole.rays());
    assert!(again.texels() == whole.texels(), "the same texels");
    let kept = baked(&gpu, &scene, &light, 256 << 10, Some(folder.path()));
    assert_eq!(kept.rays(), 0);
    assert!(kept.texels() == whole.texels(), "the same texels");
    // Another light, and another world.
    assert!(baked(&gpu, &scene, &sun(), 256 << 10, Some(folder.path())).rays() > 0);
    let mut moved = scene;
    moved.instances[1].world_from_mesh.w_axis.x += 0.01;
    assert!(baked(&gpu, &moved, &light, 256 << 10, Some(folder.path())).rays() > 0);
}

#[test]
fn files_that_are_not_as_they_were_written_are_baked_again() {
    let (gpu, folder) = (gpu(), tempfile::tempdir().expect("a folder"));
    let scene = site::scene(Vec3::ZERO);
    let whole = baked(&gpu, &scene, &sun(), 64 << 10, Some(folder.path()));
    let mut paths: Vec<_> = std::fs::read_dir(folder.path())
        .expect("a folder")
        .map(|entry| entry.expect("a file").path())
        .collect();
    paths.sort();
    assert!(paths.len() >= 16, "{} files", paths.len());
    let read = |i: usize| std::fs::read(&paths[i]).expect("a file");
    let cut = read(0);
    std::fs::write(&paths[0], &cut[..cut.len() - 40]).expect("cut");
    let mut changed = read(1);
    changed[100] ^= 1;
    std::fs::write(&paths[1], changed).expect("changed");
    std::fs::write(&paths[2], read(3)).expect("confused");
    std::fs::write(&paths[4], b"").expect("emptied");
    let again = baked(&gpu, &scene, &sun(), 64 << 10, Some(folder.path()));
    assert!(0 < again.rays() && again.rays() < whole.rays() / 2, "{} of {} rays", again.rays(), whole.rays());
    assert!(again.texels() == whole.texels(), "the same texels");
    assert_eq!(
        std::fs::read_dir(folder.path()).expect("a folder").count(),
        paths.len(),
        "nothing is left over"
    );
}

#[test]
fn a_folder_that_cannot_be_written_is_an_error_by_name() {
    let (gpu, folder) = (gpu(), tempfile::tempdir().expect("a folder"));
    let file = folder.path().join("file");
    std::fs::write(&file, b"in the way").expect("a file");
    for path in [file.clone(), file.join("below")] {
        let (scene, light) = (site::scene(Vec3::ZERO), sun());
        let lights = std::slice::from_ref(&light);
        let error = LightMaps::bake(
            &gpu,
            &scene,
            (lights, &Pose::default()),
            options(64 << 10),
            Some(&path),
            &|_| true,
        )
        .expect_err("no folder");
        assert!(error.to_string().contains(path.to_str().expect("a path")), "{error}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 1);
    assert_eq!(std::fs::read(file).expect("a file"), b"in the way");
}

#[test]
fn options_out_of_range_and_too_little_room_are_errors() {
    // 256 boxes that touch nothing: 1536 charts with a gutter of two texels all around.
    let places =
        (0..=255u8).map(|i| (Vec3::new(f32::from(i % 16), 0.0, f32::from(i / 16)), Vec3::splat(0.5)));
    let (gpu, light) = (gpu(), sun());
    let scene = site::boxes(Vec3::ZERO, &places.collect::<Vec<_>>());
    let bake = |bytes, rays| {
        let options = LightMapOptions { bytes, rays };
        LightMaps::bake(
            &gpu,
            &scene,
            (std::slice::from_ref(&light), &Pose::default()),
            options,
            None,
            &|_| true,
        )
    };
    for (bytes, rays, name) in
        [(4095, 4, "bytes"), (u64::MAX, 4, "bytes"), (4096, 0, "rays"), (4096, 65, "rays")]
    {
        let error = bake(bytes, rays).expect_err("out of range").to_string();
        assert!(error.contains(name), "{error}");
    }
    let error = bake(4096, 4).expect_err("no room");
    assert!(matches!(error, RivalError::Room { bytes: 4096, .. }), "{error}");
}

#[test]
fn a_device_whose_buffers_are_too_small_is_an_error() {
    let gpu = small_gpu(|descriptor| {
        let limits = &mut descriptor.required_limits;
        (limits.max_buffer_size, limits.max_storage_buffer_binding_size) = (1 << 14, 1 << 14);
    });
    // Its triangles need 27 648 bytes.
    let mut scene = common::scene(vec![common::at(1, 0.0, 0.0, 0.0)]);
    scene.lights = vec![sun()];
    let refused = Family::LightMaps { bytes: 1 << 16, rays: 1 }.ready(&gpu, &scene).expect_err("no room");
    assert!(refused.to_string().contains("the light maps cannot be made"), "{refused}");
}

#[test]
fn a_device_without_timestamps_tells_the_time_too() {
    let gpu = small_gpu(|descriptor| descriptor.required_features.remove(wgpu::Features::TIMESTAMP_QUERY));
    let mut maps = baked(&gpu, &site::scene(Vec3::ZERO), &sun(), 64 << 10, None);
    assert!(see(&mut maps, &camera(Vec3::ZERO), &sun()).milliseconds > 0.0);
}

#[test]
fn too_many_lights_for_bytes_or_layers_are_errors_that_say_which() {
    let (gpu, scene) = (gpu(), site::scene(Vec3::ZERO));
    let bake = |lights, bytes| {
        let lights = vec![sun(); lights];
        let told = |_| panic!("nothing is begun");
        LightMaps::bake(&gpu, &scene, (&lights, &Pose::default()), options(bytes), None, &told)
            .expect_err("too many")
    };
    let error = bake(200, 4096);
    assert!(matches!(error, RivalError::Room { lights: 200, bytes: 4096 }), "{error}");
    let limit = gpu.device.limits().max_texture_array_layers;
    let error = bake(limit as usize + 1, 1 << 20);
    assert!(matches!(error, RivalError::Layers { most, .. } if most == limit), "{error}");
}

#[test]
fn a_vertex_that_is_nowhere_takes_its_triangles_and_nothing_else() {
    let (gpu, camera) = (gpu(), camera(Vec3::ZERO));
    let mut scene = site::scene(Vec3::ZERO);
    let mut torn = scene.meshes[0].clone();
    torn.positions[0].x = f32::NAN;
    scene.meshes.push(torn);
    scene.instances[2].mesh = 1;
    let mut maps = baked(&gpu, &scene, &sun(), 256 << 10, None);
    let seen = see(&mut maps, &camera, &sun());
    assert_eq!(pixel_at(&camera, &seen, Vec3::new(0.0, 0.0, 5.0)), Some(1.0), "the ground");
    let tally = tally(&scene, maps.left(), &camera, &sun(), &seen.visibility[0]);
    assert!(tally.judged > 15_000 && tally.mis_shadowed() < 0.01, "{tally:?}");
}

#[test]
fn an_empty_scene_is_lit_and_one_without_lights_is_not_known() {
    let gpu = gpu();
    let mut maps = baked(&gpu, &Scene::default(), &sun(), 64 << 10, None);
    assert_eq!((maps.charts(), maps.rays()), (0, 0));
    let seen = see(&mut maps, &camera(Vec3::ZERO), &sun());
    assert!(seen.visibility[0].iter().all(|share| *share == Some(1.0)));
    let mut unlit =
        Family::LightMaps { bytes: 4096, rays: 1 }.ready(&gpu, &site::scene(Vec3::ZERO)).expect("ready");
    let view = View { camera: &camera(Vec3::ZERO), lights: &[sun()], pose: &Arc::default(), size: SIZE };
    assert!(unlit.see(&view).expect("seen").visibility[0].iter().all(Option::is_none), "nothing was baked");
    let none = View { camera: &camera(Vec3::ZERO), lights: &[], pose: &Arc::default(), size: SIZE };
    assert!(maps.see(&none).expect("seen").visibility.is_empty());
}
