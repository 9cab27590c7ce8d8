//! Rays through casters on the GPU: against brute force over all triangles in f64, along edges and through corners, and through
//! what no importer would let pass.

mod bad;
mod edges;
mod oracle;
mod soup;

use std::sync::Arc;

use glam::Vec3;
use proptest::prelude::*;
use umbrage_render::umbrage::{Exact, Settings};
use umbrage_render::{Frame, Gpu, Point, Renderer, Show};
use umbrage_scene::{Camera, Light, Scene};

/// What rays alone answer.
fn traced() -> Settings {
    Settings { exact: Exact::Always, resolution: 64, ..Settings::default() }
}

fn gpu() -> Gpu {
    Gpu::new(Some("vulkan")).expect("run scripts/setup")
}

/// How much of each light reaches each point by rays alone, a list for each light. The camera looks at `centre`.
fn asked(gpu: &Gpu, scene: &Scene, centre: Vec3, points: &[Vec<Point>]) -> Vec<Vec<f32>> {
    let mut renderer = Renderer::new(gpu, scene, traced()).expect("a renderer");
    let camera = Camera::looking("front", centre + 30.0 * Vec3::Z, centre, 1.0, 0.5, 1000.0);
    let frame = Frame::of(&camera, &scene.lights, &Arc::default(), [16, 16], Show::Nothing);
    let drawn = renderer.render(&frame.expect("a good camera")).expect("a frame").drawn;
    assert!(renderer.shadows().occluder_bytes() > 0, "rays answer");
    let mut ask = |light: usize| renderer.query(&drawn, light, &points[light]).expect("answers");
    (0..scene.lights.len()).map(&mut ask).collect()
}

/// A point that faces a light.
fn facing(light: &Light, position: Vec3) -> Point {
    let to_light = oracle::to_light(light, position.as_dvec3()).0;
    Point { position, normal: to_light.as_vec3().normalize_or(Vec3::Y) }
}

/// How wrong a share of light may be, where rounding moves a place on a picture of alpha.
const TOLERANCE: f64 = 0.01;

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, max_shrink_iters: 0, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn rays_say_what_brute_force_says(seed: u64, is_far: bool) {
        let centre = if is_far { Vec3::new(100_000.0, -3000.0, 70_000.0) } else { Vec3::ZERO };
        let (scene, places) = soup::of(seed, centre);
        let points = scene.lights.iter().map(|light| {
            places.iter().map(|place| facing(light, *place)).collect()
        }).collect::<Vec<Vec<Point>>>();
        let answers = asked(&gpu(), &scene, centre, &points);
        let world = oracle::World::of(&scene);
        for (number, light) in scene.lights.iter().enumerate() {
            let (mut unsure, mut dark, mut lit, mut partial) = (0, 0, 0, 0);
            let asked = points[number].iter().zip(&answers[number]);
            for (point, answer) in asked.filter(|(point, _)| oracle::shines_on(light, point.position.as_dvec3())) {
                let Some(truth) = world.share(light, point.position.as_dvec3()) else {
                    unsure += 1;
                    continue;
                };
                let wrong = (f64::from(*answer) - truth).abs();
                prop_assert!(wrong <= TOLERANCE, "{}: {answer} for {truth} at {:?}", light.name, point.position);
                dark += usize::from(truth == 0.0);
                lit += usize::from(truth == 1.0);
                partial += usize::from(truth > 0.02 && truth < 0.98);
            }
            println!("{}: {unsure} unsure, {dark} dark, {lit} lit, {partial} between", light.name);
            prop_assert!(10 * unsure < places.len(), "{}: {unsure} of {} are unsure", light.name, places.len());
            prop_assert!(dark > 20 && lit > 20 && partial > 10, "{dark} dark, {lit} lit, {partial} between");
        }
    }
}
