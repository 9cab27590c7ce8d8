//! Warps: any of them, in any split, for suns and spots: right where the texels are fine, and continuous.

use crate::common::{Drawn, Query, bounds, camera, device, draw_lit, queries, world};
use glam::{DVec3, Vec3};
use umbrage::{
    Camera, DepthFormat, Exponential, Filter, FourMoments, Light, Select, Settings, Variance, Warp,
};

const WARPS: [Warp; 3] = [Warp::Psm, Warp::Lispsm, Warp::Tsm];

fn eye() -> Camera {
    camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::new(4.0, 0.0, -6.0))
}

fn sun(direction: Vec3) -> Light {
    Light::directional(direction).expect("a sun")
}

fn drawn(settings: &Settings, light: Light, camera: &Camera) -> Drawn {
    let world = world();
    draw_lit(device(wgpu::Backends::VULKAN), settings.clone(), camera, &[light], &world, &bounds(&world))
}

fn seen(camera: &Camera) -> Vec<Query> {
    queries(&world(), camera, 80)
}

/// Whether a sun's ray from a receiver meets a box of the world: exact, by slabs.
fn is_shadowed(boxes: &[(DVec3, DVec3)], query: &Query, to_light: DVec3) -> bool {
    let from = query.position.as_dvec3() + query.normal.as_dvec3() * 1e-4;
    boxes.iter().any(|(low, high)| {
        let (a, b) = ((*low - from) / to_light, (*high - from) / to_light);
        a.min(b).max_element().max(0.0) < a.max(b).min_element()
    })
}

/// The boxes that stand on the ground of the world: its triangles come ten to a box after those of the ground.
fn boxes() -> Vec<(DVec3, DVec3)> {
    let world = world();
    let corners = |part: &[[Vec3; 3]]| {
        let points = part.iter().flatten().map(|p| p.as_dvec3());
        points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)))
    };
    world[800..].chunks(10).map(corners).collect()
}

/// What share of the picture that a sun shines on is answered wrongly: points count as large as they look.
fn wrong(drawn: &Drawn, queries: &[Query], light: Light) -> f64 {
    let to_light = light.direction_from(Vec3::ZERO);
    let (boxes, eye) = (boxes(), drawn.plan.camera().eye());
    let answers = drawn.visibility(queries);
    let (mut wrong, mut all) = (0.0, 0.0);
    for (query, answer) in queries.iter().zip(answers).filter(|(q, _)| q.normal.dot(to_light) > 0.05) {
        let toward = eye - query.position;
        let size = f64::from(query.normal.dot(toward).max(0.0) / toward.length().powi(3));
        all += size;
        if (answer < 0.5) != is_shadowed(&boxes, query, to_light.as_dvec3()) {
            wrong += size;
        }
    }
    wrong / all
}

#[test]
fn every_warp_shadows_what_rays_say_alone_and_in_splits() {
    let camera = eye();
    let queries = seen(&camera);
    for direction in
        [Vec3::new(0.5, -1.0, 0.3), Vec3::new(-0.4, -0.6, 0.9), Vec3::NEG_Y, Vec3::new(0.9, -0.3, -0.9)]
    {
        for (splits, select) in [(1, Select::Depth), (3, Select::Depth), (3, Select::Map)] {
            for unclipped_depth in [true, false] {
                let settings = Settings { splits, select, unclipped_depth, ..Settings::default() };
                let even = wrong(&drawn(&settings, sun(direction), &camera), &queries, sun(direction));
                for warp in WARPS {
                    // The perspective map's depth is far finer near the eye than far away.
                    let depth = if warp == Warp::Psm { DepthFormat::F32 } else { settings.depth };
                    let settings = Settings { warp, depth, ..settings.clone() };
                    let warped = wrong(&drawn(&settings, sun(direction), &camera), &queries, sun(direction));
                    println!(
                        "{direction}, {splits}, {select:?}, {warp:?}: {warped:.4} wrong, {even:.4} without"
                    );
                    // A perspective map's texels are long far away, wherever its eye is close to something.
                    let most = if warp == Warp::Psm { even + 0.03 } else { 1.6 * even + 0.004 };
                    assert!(warped < most, "{direction}, {splits}, {warp:?}: {warped}, not {even}");
                }
            }
        }
    }
}

#[test]
fn nothing_jumps_where_light_and_view_become_parallel_or_perpendicular() {
    let camera = eye();
    let queries = seen(&camera);
    let forward = camera.forward();
    let across = forward.cross(Vec3::X).normalize_or_zero();
    for warp in WARPS {
        let settings = Settings { warp, splits: 1, filter: Filter::Hard {}, ..Settings::default() };
        for (what, around, toward) in [
            ("along the view", forward, across),
            ("against it", -forward, across),
            ("across it", across, forward),
        ] {
            for exponent in [-1.0f32, -2.0, -3.0, -4.0, -5.0, -6.0, f32::NEG_INFINITY] {
                for sign in [-1.0, 1.0] {
                    let direction = around + toward * (sign * 10f32.powf(exponent));
                    // Only lights from above have shadows to look at.
                    let light = sun(if direction.y > 0.0 { -direction } else { direction });
                    let drawn = drawn(&settings, light, &camera);
                    assert!(drawn.plan.views()[0].clip_from_world.is_finite(), "{what}, 1e{exponent}");
                    let share = wrong(&drawn, &queries, light);
                    println!("{warp:?} {what}, {sign} 1e{exponent}: {share:.4} wrong");
                    // A tenth aside, light skims the ground; from there on nothing may change but noise.
                    let most = if exponent > -2.0 { 0.1 } else { 0.015 };
                    assert!(share < most, "{warp:?} {what}, 1e{exponent}: {share} wrong");
                }
            }
        }
    }
}

/// A floor of 10 × 10 squares with nothing around it.
fn floor() -> Vec<[Vec3; 3]> {
    let corner = |i: u32, j: u32| Vec3::new(i as f32 * 4.0 - 20.0, 0.0, j as f32 * 4.0 - 20.0);
    let square = |i: u32, j: u32| {
        let [a, b, c, d] = [corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)];
        [[a, b, c], [a, c, d]]
    };
    (0..100).flat_map(|i| square(i / 10, i % 10)).collect()
}

#[test]
fn the_emptiness_around_a_floor_does_not_shadow_it() {
    let (world, eye) = (floor(), camera(Vec3::new(0.0, 6.0, 28.0), Vec3::new(0.0, 0.0, 0.0)));
    let seen = queries(&world, &eye, 40);
    let spot = Light::spot(Vec3::new(25.0, 30.0, 5.0), Vec3::new(-25.0, -30.0, -5.0), 0.7, 200.0);
    let filters = [
        Filter::Vsm(Variance::default()),
        Filter::Esm(Exponential::default()),
        Filter::Msm(FourMoments::default()),
    ];
    for light in [sun(Vec3::new(-0.5, -0.6, -0.1)), spot.expect("a spot")] {
        for warp in WARPS {
            for filter in filters {
                let settings = Settings {
                    warp,
                    filter,
                    splits: 1,
                    spot_splits: 1,
                    resolution: 512,
                    ..Settings::default()
                };
                let drawn = draw_lit(
                    device(wgpu::Backends::VULKAN),
                    settings,
                    &eye,
                    &[light],
                    &world,
                    &bounds(&world),
                );
                let dark = drawn.visibility(&seen).iter().filter(|visibility| **visibility < 0.9).count();
                // Four moments of a floor seen at a low angle are rounded to a shadow here and there.
                assert!(dark * 200 < seen.len(), "{warp:?}, {filter:?}: {dark} of {} are dark", seen.len());
            }
        }
    }
}

#[test]
fn warped_lookups_agree_with_the_gpu() {
    let camera = eye();
    let queries = seen(&camera);
    let spot =
        Light::spot(Vec3::new(-8.0, 22.0, 12.0), Vec3::new(0.4, -1.0, -0.5), 0.6, 60.0).expect("a spot");
    for warp in WARPS {
        for light in [sun(Vec3::new(0.5, -1.0, 0.3)), spot] {
            for (select, receiver_plane) in [(Select::Depth, false), (Select::Map, true)] {
                let bias = umbrage::Bias { slope: 0.5, receiver_plane, ..Default::default() };
                let settings =
                    Settings { warp, select, bias, splits: 2, spot_splits: 2, ..Settings::default() };
                let drawn = drawn(&settings, light, &camera);
                let maps = drawn.maps();
                let lookup = drawn.lookup(&maps);
                let gpu = drawn.visibility(&queries);
                let differ = queries
                    .iter()
                    .zip(&gpu)
                    .filter(|(q, v)| (lookup.visibility(0, q.position, q.normal) - **v).abs() > 1.0 / 64.0)
                    .count();
                println!("{warp:?}, {select:?}: {differ} of {} differ", queries.len());
                assert!(differ * 400 <= queries.len(), "{warp:?}, {select:?}: {differ} of {}", queries.len());
            }
        }
    }
}
