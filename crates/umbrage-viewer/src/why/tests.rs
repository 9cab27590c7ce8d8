//! A small scene for each cause, in which every wrong pixel has that cause.

use std::sync::Arc;

use glam::{Mat4, Vec3};
use umbrage::{Bias, Filter, Fit, LightBox, Settings};
use umbrage_judge::{Eye, Verdict, World};
use umbrage_lab::settings::asked;
use umbrage_render::{Frame, Gpu, Renderer, Show};
use umbrage_scene::{Camera, Instance, Lens, Light, Pose, Scene, plate_over_ground};

use super::*;

const PIXELS: u32 = 96;

/// The ground from straight above, 3 m of it around a point, seen from `height` metres; every pixel shows ground that is
/// nearer than what casts shadows.
fn from_above(x: f32, z: f32, height: f32) -> Camera {
    let eye = Vec3::new(x, height, z);
    let lens = Lens::Orthographic { half_height: 1.5 };
    Camera { lens, ..Camera::looking("down", eye, eye - Vec3::Y, 1.0, 0.1, height + 1.0) }
}

/// One map of 64 texels a side, five hundredths of a metre each, read without a filter.
fn coarse() -> Settings {
    Settings { splits: 1, resolution: 64, filter: Filter::Hard {}, ..Settings::default() }
}

/// What is said of every pixel under one light.
fn answers(scene: &Scene, light: &Light, settings: &Settings, camera: &Camera) -> Vec<Why> {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let mut renderer = Renderer::new(&gpu, &Arc::new(scene.clone()), settings.clone()).expect("a renderer");
    let lights = std::slice::from_ref(light);
    let frame = Frame::of(camera, lights, &Arc::default(), [PIXELS; 2], Show::Visibility(0));
    let drawn = renderer.render(&frame.expect("a good camera and light")).expect("a frame").drawn;
    let visibility = drawn.picture().expect("a picture").visibility();
    let maps = renderer.maps(&drawn).expect("maps");
    let world = World::new(scene, &Pose::default());
    let (eye, rays) = (Eye::new(camera, PIXELS, PIXELS), umbrage_judge::Light::of(light));
    let answer = |(i, shown): (usize, &f32)| {
        let pixel = [i as u32 % PIXELS, i as u32 / PIXELS];
        let inspected = world.inspect(&eye, &rays, pixel).expect("ground");
        let (plan, maps, world) = (drawn.plan(), Some(&maps), &world);
        Question { plan, settings, maps, world, light: 0, rays: &rays, inspected, shown: *shown }.answer()
    };
    visibility.iter().enumerate().map(answer).collect()
}

/// Checks that at least so many pixels are wrong, and that nine in ten of them have a cause.
#[track_caller]
fn check(answers: &[Why], least: usize, is_cause: impl Fn(&Why) -> bool) {
    let wrong: Vec<&Why> = answers.iter().filter(|why| why.verdict.is_wrong()).collect();
    let others: Vec<&&Why> = wrong.iter().filter(|why| !is_cause(why)).collect();
    println!("{} wrong, {} of another cause: {:#?}", wrong.len(), others.len(), others.first());
    let dark = answers.iter().filter(|why| why.truth == Pixel::Shadowed).count();
    let shown = answers.iter().filter(|why| why.shown < 0.5).count();
    assert!(
        wrong.len() >= least,
        "{} pixels are wrong; {dark} are in shadow, {shown} are shown so",
        wrong.len()
    );
    assert!(others.len() * 10 <= wrong.len(), "{} of {}: {:#?}", others.len(), wrong.len(), others[0]);
    for why in answers {
        let text = why.cause.to_string();
        assert!(text.ends_with('.') && !text.contains('\n'), "{text}");
        assert_eq!(why.verdict == Verdict::Right, why.cause == Cause::Right, "{why:?}");
    }
}

fn sun() -> Light {
    Light::sun(Vec3::new(0.3, -1.0, 0.2), 1.0)
}

#[test]
fn a_coarse_map_is_wrong_within_a_texel_of_an_edge() {
    let answers = answers(&plate_over_ground(60.0, 4.0), &sun(), &coarse(), &from_above(1.2, 0.8, 2.0));
    check(
        &answers,
        40,
        |why| matches!(why.cause, Cause::NearEdge { texels, texel_metres } if texels <= 1.5 && (0.02..0.12).contains(&texel_metres)),
    );
    let map = answers[0].map.as_ref().expect("a map");
    assert_eq!((map.side, map.view.as_str()), (64, "the light's one map"));
    // The plate lies before the map's near plane, and is flattened onto it: the map knows that it is at least so far away.
    let mut shadowed =
        answers.iter().filter(|why| why.shown == 0.0 && why.verdict == Verdict::Right).peekable();
    assert!(shadowed.peek().is_some(), "the plate has a shadow");
    for why in shadowed {
        let map = why.map.as_ref().expect("a map");
        let (known, blocker) = (map.blocker.expect("a blocker"), why.blocker.expect("the plate"));
        assert!(map.is_flattened && known > 0.0 && f64::from(known) < blocker + 0.01, "{why:?}");
    }
}

#[test]
fn a_lamps_faces_are_named_and_its_edges_are_found() {
    let lamp = Light::point("lamp", Vec3::new(0.2, 8.0, 0.1), 40.0, 100.0);
    let answers = answers(&plate_over_ground(60.0, 4.0), &lamp, &coarse(), &from_above(1.8, 1.8, 2.0));
    check(&answers, 20, |why| matches!(why.cause, Cause::NearEdge { .. }));
    assert_eq!(answers[0].map.as_ref().expect("a map").view, "face −Y of the point light's cube");
    // Along the face's axis the plate is 4 m above the ground.
    let shadowed = answers.iter().filter(|why| why.shown == 0.0 && why.verdict == Verdict::Right);
    let off: Vec<f32> = shadowed
        .map(|why| (why.map.as_ref().expect("a map").blocker.expect("a blocker") - 4.0).abs())
        .collect();
    assert!(!off.is_empty() && off.iter().all(|off| *off < 0.05), "{off:?}");
}

#[test]
fn without_a_bias_the_ground_shadows_itself() {
    let bias =
        Bias { constant: 0.0, slope: 0.0, normal: 0.0, bend: 0.0, receiver_plane: false, ..Bias::default() };
    let settings = Settings { bias, ..coarse() };
    let low = Light::sun(Vec3::new(1.0, -0.6, 0.4), 1.0);
    let answers = answers(&plate_over_ground(60.0, 4.0), &low, &settings, &from_above(-12.0, -9.0, 2.0));
    check(
        &answers,
        500,
        |why| matches!(why.cause, Cause::Acne { bias, stored } if bias < 0.01 && stored > bias && stored < 0.2),
    );
}

#[test]
fn a_bias_that_is_larger_than_the_contact_distance_leaks() {
    let bias = Bias { constant: 1.5, ..Bias::default() };
    let settings = Settings { bias, ..coarse() };
    let answers = answers(&plate_over_ground(60.0, 1.0), &sun(), &settings, &from_above(0.3, 0.2, 0.5));
    check(
        &answers,
        1000,
        |why| matches!(why.cause, Cause::BiasOverContact { bias, contact } if (1.5..2.0).contains(&bias) && (0.9..1.2).contains(&contact)),
    );
}

#[test]
fn beyond_the_shadow_distance_and_outside_of_the_maps_all_is_lit() {
    let scene = plate_over_ground(60.0, 4.0);
    let near = Settings { distance: Some(1.0), ..coarse() };
    let camera = from_above(1.2, 0.8, 2.0);
    check(
        &answers(&scene, &sun(), &near, &camera),
        1000,
        |why| matches!(why.cause, Cause::BeyondDistance { depth, end } if (depth - 2.0).abs() < 1e-6 && (end - 1.0).abs() < 1e-6),
    );
    let light_box = LightBox { x: 20.0, half_width: 2.0, half_height: 2.0, ..LightBox::default() };
    let elsewhere = Settings { fit: Fit::World, light_box: Some(light_box), ..coarse() };
    check(&answers(&scene, &sun(), &elsewhere, &camera), 1000, |why| why.cause == Cause::OutsideMaps);
}

#[test]
fn a_caster_before_the_box_of_a_map_that_flattens_nothing_is_not_held() {
    let light_box = LightBox { near: -2.0, ..LightBox::default() };
    let settings =
        Settings { fit: Fit::World, light_box: Some(light_box), unclipped_depth: false, ..coarse() };
    let answers = answers(&plate_over_ground(60.0, 4.0), &sun(), &settings, &from_above(1.2, 0.8, 2.0));
    check(
        &answers,
        1000,
        |why| matches!(why.cause, Cause::CasterOutside { blocker } if (4.0..4.5).contains(&blocker)),
    );
}

#[test]
fn a_strip_that_is_narrower_than_a_texel_is_missed() {
    let mut scene = plate_over_ground(60.0, 4.0);
    scene.instances[1] = Instance::still(1, Mat4::from_scale(Vec3::new(0.01, 1.0, 10.0)));
    // Of six places of the strip's shadow, texel centres hit some and miss some.
    let of_sun = |i: u8| {
        let sun = Light::sun(Vec3::new(0.02 + 0.002 * f32::from(i), -1.0, 0.1), 1.0);
        answers(&scene, &sun, &coarse(), &from_above(0.0, 0.0, 2.0))
    };
    let answers: Vec<Why> = (0..6).flat_map(of_sun).collect();
    check(&answers, 20, |why| match why.cause {
        Cause::Thin { texels, .. } => texels <= 1.0,
        // Where the map hits it, its shadow is a texel wide.
        Cause::NearEdge { .. } => why.verdict == Verdict::FalseShadow,
        _ => false,
    });
    assert!(answers.iter().any(|why| matches!(why.cause, Cause::Thin { .. })), "some of it is missed");
}

#[test]
fn a_map_of_variances_leaks_behind_an_edge_of_what_lies_higher() {
    let mut scene = plate_over_ground(60.0, 0.5);
    // Under the whole of it the ground is in shadow; half of it lies in the shadow of a plate far above.
    scene.instances[1] = Instance::still(1, Mat4::from_scale(Vec3::new(4.0, 1.0, 4.0)));
    let high = Mat4::from_translation(Vec3::new(4.0, 8.0, 0.0)) * Mat4::from_scale(Vec3::new(4.0, 1.0, 4.0));
    scene.instances.push(Instance::still(1, high));
    let settings = asked(
        "default",
        &[
            "splits=1",
            "resolution=64",
            "filter.kind=vsm",
            "filter.light_bleed_reduction=0",
            "unclipped_depth=false",
        ],
    );
    let down = Light::sun(Vec3::new(0.001, -1.0, 0.001), 1.0);
    let answers = answers(&scene, &down, &settings.expect("settings"), &from_above(0.0, 0.0, 0.3));
    check(
        &answers,
        20,
        |why| matches!(why.cause, Cause::FilterLeak { blocker, shown } if blocker > 0.3 && shown >= 0.5),
    );
}
