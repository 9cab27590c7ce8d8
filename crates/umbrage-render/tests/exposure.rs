//! How bright pictures are: light in lux and candela, exposure, tone map and haze, by values that can be worked out.

mod common;

use std::f32::consts::PI;
use std::sync::Arc;

use common::{PIXELS, from_above, gpu, plate};
use glam::{Mat4, Vec3};
use umbrage_render::umbrage::Settings;
use umbrage_render::{Exposure, Frame, Gpu, Renderer, Show, metered_lux};
use umbrage_scene::{Light, Material, Scene, worlds};

/// A scene whose ground and plate are of one material.
fn of(material: Material) -> Scene {
    Scene { materials: vec![material], ..plate() }
}

fn white() -> Scene {
    of(Material::plain("white", 1.0, 1.0, 1.0))
}

/// The ground in the middle of the picture, under these lights and without haze: sRGB.
fn pixel(gpu: &Gpu, scene: &Scene, lights: &[Light], exposure: Exposure) -> [u8; 3] {
    let rgba = picture(gpu, scene, &Frame { exposure, haze: false, ..seen(lights) });
    let at = 4 * (PIXELS * PIXELS / 2 + PIXELS / 2) as usize;
    [rgba[at], rgba[at + 1], rgba[at + 2]]
}

fn seen(lights: &[Light]) -> Frame {
    let frames: Vec<Frame> = lights.iter().map(|light| from_above(light, Show::Unshadowed)).collect();
    let lights = frames.iter().flat_map(|frame| frame.lights.clone()).collect();
    Frame { lights, ..frames[0].clone() }
}

fn picture(gpu: &Gpu, scene: &Scene, frame: &Frame) -> Vec<u8> {
    let mut renderer = Renderer::new(gpu, scene, Settings::default()).expect("a renderer");
    renderer.render(frame).expect("a frame").drawn.picture().expect("a picture").rgba
}

/// The Khronos PBR Neutral tone mapper, as its specification has it, and the sRGB of what comes of it.
fn shown(light: Vec3) -> [u8; 3] {
    let least = light.min_element();
    let offset = if least < 0.08 { least - 6.25 * least * least } else { 0.04 };
    let colour = light - offset;
    let peak = colour.max_element();
    let mapped = if peak < 0.76 {
        colour
    } else {
        let new_peak = 1.0 - 0.24 * 0.24 / (peak + 0.24 - 0.76);
        let white = 1.0 - 1.0 / (0.15 * (peak - new_peak) + 1.0);
        (colour * new_peak / peak).lerp(Vec3::splat(new_peak), white)
    };
    let srgb = |l: f32| if l <= 0.003_130_8 { l * 12.92 } else { 1.055 * l.powf(1.0 / 2.4) - 0.055 };
    mapped.to_array().map(|l| (srgb(l.clamp(0.0, 1.0)) * 255.0).round() as u8)
}

fn assert_close(got: [u8; 3], want: [u8; 3], what: &str) {
    let differs = got.iter().zip(want).any(|(a, b)| a.abs_diff(b) > 1);
    assert!(!differs, "{what}: {got:?} instead of {want:?}");
}

/// What a white surface sends back in the light that is exposed for.
const WHITE: f32 = 1.2;

/// What it sends back of the sky that belongs to such a sun, where it lies flat; and of the night.
const SKY: Vec3 = Vec3::new(0.30 * WHITE / 2.6, 0.38 * WHITE / 2.6, 0.52 * WHITE / 2.6);
const NIGHT: Vec3 = Vec3::new(0.30 * 0.04, 0.38 * 0.04, 0.52 * 0.04);

/// The exposure under which luminance is what the tone map gets.
const AS_IT_IS: Exposure = Exposure { stops: 0.0, lux: Some(WHITE * PI) };

#[test]
fn the_tone_map_is_khronos_pbr_neutral() {
    let gpu = gpu();
    let off = [Light::sun(Vec3::NEG_Y, 0.0)];
    // Greys, colours, and what is brighter than white. 0.5 − 0.04 = 0.46, whose sRGB is 181.
    assert_eq!(shown(Vec3::splat(0.5)), [181; 3]);
    // 1 − 0.04 = 0.96 is compressed to 1 − 0.0576 / 0.44 = 0.869, whose sRGB is 240.
    assert_eq!(shown(Vec3::splat(1.0)), [240; 3]);
    let lights = [
        Vec3::splat(0.02),
        Vec3::splat(0.5),
        Vec3::splat(1.0),
        Vec3::new(0.7, 0.3, 0.1),
        Vec3::new(4.0, 0.5, 0.05),
        Vec3::splat(1000.0),
        Vec3::new(1e20, 1.0, 0.0),
    ];
    for light in lights {
        let glow = Material { emission: light, ..Material::plain("glow", 0.0, 0.0, 0.0) };
        assert_close(pixel(&gpu, &of(glow), &off, AS_IT_IS), shown(light), &format!("{light}"));
    }
}

#[test]
fn a_white_plane_under_a_sun_of_any_strength_is_white_by_default() {
    let gpu = gpu();
    let want = shown(SKY + WHITE);
    for lux in [1e-20, 0.1, 1.0, 3.0, 683.0, 100_000.0, 1e30] {
        let got = pixel(&gpu, &white(), &[Light::sun(Vec3::NEG_Y, lux)], Exposure::default());
        assert_close(got, want, &format!("{lux} lux"));
    }
}

#[test]
fn a_stop_doubles_the_light_and_a_hundred_are_white_or_black() {
    let gpu = gpu();
    let scene = of(Material::plain("grey", 0.1, 0.1, 0.1));
    let sun = [Light::sun(Vec3::NEG_Y, 100_000.0)];
    for stops in [-3.0, -1.0, 0.0, 1.0, 2.0] {
        let want = shown((SKY + WHITE) * 0.1 * f32::exp2(stops));
        assert_close(pixel(&gpu, &scene, &sun, Exposure::of_stops(stops)), want, &format!("{stops} stops"));
    }
    for (stops, want) in [(100.0, [255; 3]), (1e30, [255; 3]), (-100.0, [0; 3]), (f32::NEG_INFINITY, [0; 3])]
    {
        assert_eq!(pixel(&gpu, &scene, &sun, Exposure::of_stops(stops)), want, "{stops} stops");
    }
    let none = pixel(&gpu, &scene, &sun, Exposure::of_stops(f32::NAN));
    assert_eq!(none, pixel(&gpu, &scene, &sun, Exposure::default()), "no number counts as 0");
}

#[test]
fn a_lamp_has_candela_and_its_light_falls_with_the_square() {
    let gpu = gpu();
    let scene = of(Material::plain("grey", 0.5, 0.5, 0.5));
    let exposure = Exposure { stops: 0.0, lux: Some(1.0) };
    // The pixel is half a texel aside of the point below the lamp, which is 0.05 m.
    let lamp =
        |height: f32, candela| [Light::point("lamp", Vec3::new(0.35, height, -0.15), f32::INFINITY, candela)];
    // Half of what a white surface sends back in 1 lux, and what the night adds.
    let dark = pixel(&gpu, &scene, &lamp(2.0, 0.0), exposure);
    for (height, candela) in [(2.0, 0.4), (4.0, 1.6), (8.0, 6.4), (20.0, 40.0)] {
        let lux = 0.1;
        let night = NIGHT * metered_of(&scene, &lamp(height, candela));
        let want = shown((Vec3::splat(WHITE * lux) + night) * 0.5);
        assert_close(
            pixel(&gpu, &scene, &lamp(height, candela), exposure),
            want,
            &format!("{candela} cd at {height} m"),
        );
    }
    assert!(dark[1] < 30, "{dark:?}");
    // A range ends the light; at half of it (1 − 1/16) is left.
    let ranged = [Light::point("lamp", Vec3::new(0.35, 2.0, -0.15), 4.0, 0.4)];
    let night = NIGHT * metered_of(&scene, &ranged);
    let want = shown((Vec3::splat(WHITE * 0.1 * 15.0 / 16.0) + night) * 0.5);
    assert_close(pixel(&gpu, &scene, &ranged, exposure), want, "a range of 4 m");
}

fn metered_of(scene: &Scene, lights: &[Light]) -> f32 {
    metered_lux(scene, &seen(lights).lights)
}

#[test]
fn a_sun_that_is_off_gives_no_light_and_makes_no_day() {
    let gpu = gpu();
    let lamp = Light::point("lamp", Vec3::new(0.0, 3.0, 0.0), f32::INFINITY, 30.0);
    let off = Light::sun(Vec3::new(0.3, -1.0, 0.2), 0.0);
    let alone = picture(&gpu, &white(), &seen(std::slice::from_ref(&lamp)));
    assert!(picture(&gpu, &white(), &seen(&[off.clone(), lamp.clone()])) == alone, "before a lamp");
    assert!(picture(&gpu, &white(), &seen(&[lamp, off])) == alone, "after a lamp");
}

#[test]
fn a_fill_a_thousand_times_as_weak_as_the_key_is_not_seen() {
    let gpu = gpu();
    let key = Light::sun(Vec3::new(-0.5, -1.0, 0.2), 100_000.0);
    let fill = Light::sun(Vec3::new(0.5, -1.0, 0.2), 100.0);
    let alone = picture(&gpu, &white(), &seen(std::slice::from_ref(&key)));
    for both in [[key.clone(), fill.clone()], [fill, key]] {
        let both = picture(&gpu, &white(), &seen(&both));
        let most = alone.iter().zip(&both).map(|(a, b)| a.abs_diff(*b)).max();
        assert!(most <= Some(1), "{most:?} levels");
    }
}

#[test]
fn a_world_looks_the_same_at_every_scale() {
    let gpu = gpu();
    let world = worlds::build("primitives", 0).expect("a built-in world");
    let draw = |scene: &Scene, haze| {
        let frame =
            Frame::of(&scene.cameras[0], &scene.lights, &Default::default(), [160, 90], Show::Unshadowed);
        picture(&gpu, scene, &Frame { haze, ..frame.expect("a good camera") })
    };
    let metres = draw(&world, true);
    assert!(metres != draw(&world, false), "there is haze");
    for scale in [0.001, 0.0254, 1000.0] {
        let mut scaled = world.clone();
        for instance in &mut scaled.instances {
            instance.world_from_mesh = Mat4::from_scale(Vec3::splat(scale)) * instance.world_from_mesh;
        }
        for camera in &mut scaled.cameras {
            camera.world_from_camera.w_axis =
                (camera.world_from_camera.w_axis.truncate() * scale).extend(1.0);
            (camera.near, camera.far) = (camera.near * scale, camera.far * scale);
        }
        let picture = draw(&scaled, true);
        let differing = metres.iter().zip(&picture).filter(|(a, b)| a.abs_diff(**b) > 3).count();
        assert!(differing < 60, "{scale}: {differing} of {} bytes differ", metres.len());
    }
}

#[test]
fn lamps_are_exposed_for_about_the_light_that_the_built_in_worlds_were_made_for() {
    for world in worlds::ALL {
        let own = world.build(0);
        let scene = Scene { exposed_for: None, ..own.clone() };
        let pose = Arc::new(scene.pose(0.0));
        let frame =
            Frame::of(&scene.cameras[0], &scene.lights, &pose, [16, 9], Show::World).expect("a frame");
        let lux = metered_lux(&scene, &frame.lights);
        println!("{}: {lux:.2} lux", world.name);
        // Suns of 3 lux, less where they are coloured, and lamps that give 2.6 lux where it matters, to a stop and a half.
        let is_sunny = scene.lights.iter().any(|light| light.kind == umbrage_scene::LightKind::Directional);
        let made_for = if is_sunny { 2.5..=3.0 } else { 0.9..=7.4 };
        assert!(made_for.contains(&lux), "{}: {lux} lux", world.name);
        assert_eq!(Some(metered_lux(&own, &frame.lights)), own.exposed_for, "{} says its own", world.name);
    }
}

#[test]
fn a_scene_that_says_what_it_is_exposed_for_is() {
    let gpu = gpu();
    let sun = [Light::sun(Vec3::NEG_Y, 3.0)];
    let own = Scene { exposed_for: Some(6.0), ..white() };
    let darker = pixel(&gpu, &white(), &sun, Exposure::of_stops(-1.0));
    assert_close(pixel(&gpu, &own, &sun, Exposure::default()), darker, "twice as much light is exposed for");
    let asked = Exposure { stops: 0.0, lux: Some(3.0) };
    assert_close(pixel(&gpu, &own, &sun, asked), shown(SKY + WHITE), "what is asked for goes first");
}
