//! Maps of more than the first surface: they need no other bias, and lose no shadow.

use glam::Vec3;
use umbrage::{Bias, DepthLayer, Filter, Settings, Warp};

use crate::common::{Query, camera, device, draw, hits, queries, world};

const LIGHT: Vec3 = Vec3::new(0.5, -1.0, 0.3);

/// Shares of receivers that are falsely shadowed and falsely lit, by rays.
fn wrong(settings: Settings, queries: &[Query], lit: &[bool]) -> [f64; 2] {
    let camera = eye();
    let answers =
        draw(device(wgpu::Backends::VULKAN), settings, &camera, &[LIGHT], &world()).visibility(queries);
    let share = |of: fn(bool, f32) -> bool| {
        let wrong = lit.iter().zip(&answers).filter(|(lit, answer)| of(**lit, **answer)).count();
        wrong as f64 / lit.len() as f64
    };
    [share(|lit, answer| lit && answer < 0.5), share(|lit, answer| !lit && answer >= 0.5)]
}

fn eye() -> umbrage::Camera {
    camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::new(4.0, 0.0, -6.0))
}

#[test]
fn surfaces_do_not_shadow_themselves_in_a_map_of_what_lies_behind_them() {
    let world = world();
    let to_light = -LIGHT.normalize_or_zero();
    let faces_light = |query: &Query| query.normal.dot(to_light) > 0.1;
    let queries: Vec<Query> = queries(&world, &eye(), 60).into_iter().filter(faces_light).collect();
    let reaches = |query: &Query| {
        let origin = query.position + query.normal * 1e-3;
        !world.iter().any(|triangle| hits(origin, to_light, triangle))
    };
    let lit: Vec<bool> = queries.iter().map(reaches).collect();
    for warp in [Warp::None, Warp::Lispsm] {
        let of = |layer| {
            let bias = Bias { depth_layer: layer, depth_layer_limit: 0.3, ..Bias::NONE };
            let settings =
                Settings { bias, warp, filter: Filter::Hard {}, resolution: 512, ..Settings::default() };
            wrong(settings, &queries, &lit)
        };
        let [acne, _] = of(DepthLayer::First);
        println!("{warp:?}: {acne:.4} falsely shadowed by the first surface");
        assert!(acne > 0.05, "without a bias there is acne: {acne}");
        // A second surface that is the floor which a thing stands on lets light in around its foot.
        for (layer, most_light) in
            [(DepthLayer::Second, 0.03), (DepthLayer::Midpoint, 0.015), (DepthLayer::Dual, 0.015)]
        {
            let [shadow, light] = of(layer);
            println!(
                "{warp:?} {layer:?}: {shadow:.4} falsely shadowed, {light:.4} falsely lit, of {}",
                lit.len()
            );
            // What is left are edges, which a map of this size displaces both ways.
            assert!(
                shadow < 0.02 && light < most_light,
                "{warp:?} {layer:?}: {shadow} falsely shadowed, {light} lit"
            );
        }
    }
}

#[test]
fn a_caster_before_the_near_plane_shadows_whatever_is_stored() {
    // A roof of two sheets, far above all that is seen: both are flattened onto the near planes.
    let quad = |height: f32, half: f32| {
        let at = |x: f32, z: f32| Vec3::new(x * half, height, z * half);
        let [a, b, c, d] = [at(-1.0, -1.0), at(-1.0, 1.0), at(1.0, 1.0), at(1.0, -1.0)];
        [[a, b, c], [a, c, d]]
    };
    let floor = quad(0.0, 60.0);
    let world = [floor, quad(32.0, 5.0), quad(30.0, 5.0)].concat();
    let eye = camera(Vec3::new(15.0, 6.0, 21.0), Vec3::new(15.0, 0.0, 9.0)); // at the roof's shadow
    let to_light = -LIGHT.normalize_or_zero();
    let is_below = |query: &Query| {
        let roof = query.position + to_light * (30.0 / to_light.y);
        roof.x.abs().max(roof.z.abs()) < 4.8
    };
    let below: Vec<Query> = queries(&floor, &eye, 60_000).into_iter().filter(is_below).collect();
    assert!(below.len() > 100, "{} receivers below the roof", below.len());
    for layer in [DepthLayer::First, DepthLayer::Second, DepthLayer::Midpoint, DepthLayer::Dual] {
        let settings = Settings { bias: Bias { depth_layer: layer, ..Bias::NONE }, ..Settings::default() };
        let drawn = draw(device(wgpu::Backends::VULKAN), settings, &eye, &[LIGHT], &world);
        assert!(drawn.shadows.settings().unclipped_depth, "the test adapter has unclipped depth");
        let lit = drawn.visibility(&below).iter().filter(|answer| **answer > 0.0).count();
        assert_eq!(lit, 0, "{layer:?}: lit below the roof, of {}", below.len());
    }
}
