//! What may change without changing the picture: storage, selection, backend, and a stable camera's motion.

use crate::common::{Drawn, Query, camera, device, draw, hits, queries, world};
use glam::Vec3;
use umbrage::{
    DepthFormat, ExponentialVariance, Filter, Fit, MapTexels, Select, Settings, Storage, SummedVariance,
    Variance,
};

const LIGHT: Vec3 = Vec3::new(0.5, -1.0, 0.3);

fn eye() -> umbrage::Camera {
    camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::new(4.0, 0.0, -6.0))
}

fn settings() -> Settings {
    Settings { filter: Filter::Hard {}, resolution: 512, ..Settings::default() }
}

/// Whether visibility changes within a texel of a receiver, in the view that its depth selects, or whether it lies
/// within a texel of a split plane: there, two ways to look up may differ.
fn is_near_a_boundary(drawn: &Drawn, maps: &MapTexels, query: &Query) -> bool {
    let camera = drawn.plan.camera();
    let depth = camera.forward().dot(query.position - camera.eye());
    let inner = &drawn.plan.splits()[1..];
    let split = inner.iter().filter(|c| depth >= **c as f32).count().min(inner.len() - 1);
    let cosine = query.normal.dot(-LIGHT.normalize_or_zero()).abs().max(0.05);
    let reach = 1.5 * drawn.plan.views()[split].texel_metres / cosine;
    if inner.iter().any(|c| (depth - *c as f32).abs() < reach) {
        return true;
    }
    let lookup = drawn.lookup(maps);
    let here = lookup.visibility(0, query.position, query.normal);
    let (x, y) = query.normal.any_orthonormal_pair();
    (0..16).any(|i| {
        let (sine, cosine) = (i as f32 * std::f32::consts::TAU / 16.0).sin_cos();
        let radius = if i % 2 == 0 { reach } else { 0.5 * reach };
        lookup.visibility(0, query.position + (x * cosine + y * sine) * radius, query.normal) != here
    })
}

/// Counts what differs between two sets of answers, and demands that all of it lies at boundaries.
fn demand_agreement(
    what: &str,
    drawn: &Drawn,
    queries: &[Query],
    a: &[f32],
    b: &[f32],
    at_most_per_mille: usize,
) {
    let maps = drawn.maps();
    let differing: Vec<&Query> =
        queries.iter().zip(a.iter().zip(b)).filter(|(_, (a, b))| a != b).map(|(query, _)| query).collect();
    let elsewhere: Vec<_> =
        differing.iter().filter(|query| !is_near_a_boundary(drawn, &maps, query)).collect();
    println!(
        "{what}: {} of {} differ, {} of them away from boundaries",
        differing.len(),
        queries.len(),
        elsewhere.len()
    );
    assert!(elsewhere.is_empty(), "{what}: {elsewhere:?}");
    assert!(
        differing.len() * 1000 <= queries.len() * at_most_per_mille,
        "{what}: {} differ",
        differing.len()
    );
}

#[test]
fn array_and_atlas_give_the_same_visibility_everywhere() {
    let (world, camera) = (world(), eye());
    let queries = queries(&world, &camera, 300);
    let filters = [
        Filter::Hard {},
        Filter::Bilinear {},
        Filter::Pcf { size: 5 },
        // A blur or a sum that went over the side of a tile would bring in a neighbour.
        Filter::Vsm(Variance { min_standard_deviation: 0.1, ..Variance::default() }),
        Filter::Evsm4(ExponentialVariance::default()),
        Filter::Savsm(SummedVariance { min_standard_deviation: 0.1, ..SummedVariance::default() }),
    ];
    for filter in filters {
        let answers = [Storage::Array, Storage::Atlas].map(|storage| {
            let settings = Settings { storage, filter, ..settings() };
            draw(device(wgpu::Backends::VULKAN), settings, &camera, &[LIGHT], &world).visibility(&queries)
        });
        let differ_by = |least: f32| {
            answers[0].iter().zip(&answers[1]).filter(|(a, b)| (**a - **b).abs() > least).count()
        };
        let differ = differ_by(1.0 / 256.0);
        println!("{filter:?}: {differ} of {} differ between array and atlas", queries.len());
        // A tile that does not start at 0 rounds positions differently: the sampler's weights may differ by that, and
        // now and then a texel on an edge of the map. Moments make more of such rounding.
        let in_thousands = if !filter.compares_depths() { 1 } else { 10 };
        assert!(
            differ * in_thousands * 1000 <= queries.len(),
            "{filter:?}: {differ} of {} differ",
            queries.len()
        );
        assert!(differ_by(0.25) * 10_000 <= queries.len(), "{filter:?}: a neighbouring tile shows");
    }
}

#[test]
fn the_three_selections_differ_only_at_boundaries() {
    let (world, camera) = (world(), eye());
    let queries = queries(&world, &camera, 300);
    for fit in [Fit::Scene, Fit::View, Fit::Stable, Fit::World] {
        let drawn = |select| {
            let settings = Settings { select, fit, ..settings() };
            draw(device(wgpu::Backends::VULKAN), settings, &camera, &[LIGHT], &world)
        };
        let by_depth = drawn(Select::Depth);
        let expected = by_depth.visibility(&queries);
        let clip = drawn(Select::ClipDepth).visibility(&queries);
        demand_agreement(&format!("{fit:?}, clip depth"), &by_depth, &queries, &expected, &clip, 1);
        let map = drawn(Select::Map).visibility(&queries);
        // A finer map than the slice's own displaces edges less: up to a texel of difference along every edge.
        demand_agreement(&format!("{fit:?}, map"), &by_depth, &queries, &expected, &map, 100);
    }
}

#[test]
fn vulkan_and_gl_differ_only_at_boundaries() {
    let (world, camera) = (world(), eye());
    let queries = queries(&world, &camera, 300);
    let vulkan = draw(device(wgpu::Backends::VULKAN), settings(), &camera, &[LIGHT], &world);
    let gl = draw(device(wgpu::Backends::GL), settings(), &camera, &[LIGHT], &world);
    let (a, b) = (vulkan.visibility(&queries), gl.visibility(&queries));
    demand_agreement("Vulkan and GL", &vulkan, &queries, &a, &b, 2);
}

#[test]
fn without_unclipped_depth_near_planes_move_and_shadows_stay() {
    let (world, camera) = (world(), eye());
    let queries = queries(&world, &camera, 300);
    let drawn = |unclipped_depth| {
        let settings = Settings { unclipped_depth, ..settings() };
        draw(device(wgpu::Backends::VULKAN), settings, &camera, &[LIGHT], &world)
    };
    let (with, without) = (drawn(true), drawn(false));
    assert!(with.shadows.settings().unclipped_depth, "the test adapter has unclipped depth");
    assert!(without.plan.views()[0].depth_metres > with.plan.views()[0].depth_metres, "the near plane moved");
    let (a, b) = (with.visibility(&queries), without.visibility(&queries));
    demand_agreement("unclipped or not", &with, &queries, &a, &b, 1);
}

#[test]
fn shadows_are_there_at_all() {
    let (world, camera) = (world(), eye());
    let queries = queries(&world, &camera, 300);
    let answers =
        draw(device(wgpu::Backends::VULKAN), settings(), &camera, &[LIGHT], &world).visibility(&queries);
    // Truth by brute force: a ray toward the light against every triangle.
    let mut wrong = 0;
    for (query, answer) in queries.iter().zip(&answers) {
        let to_light = -LIGHT.normalize_or_zero();
        if query.normal.dot(to_light) < 0.1 {
            continue;
        }
        let origin = query.position + query.normal * 1e-3;
        let blocked = world.iter().any(|triangle| hits(origin, to_light, triangle));
        wrong += usize::from(blocked == (*answer == 1.0));
    }
    println!("{wrong} of {} differ from a ray", queries.len());
    assert!(wrong * 50 < queries.len(), "{wrong} of {} differ from a ray", queries.len());
}

#[test]
fn a_moving_camera_leaves_the_texels_of_a_stable_map_as_they_are() {
    let world = world();
    let settings = Settings { fit: Fit::Stable, depth: DepthFormat::F32, ..settings() };
    let frames: Vec<(Drawn, MapTexels)> = (0..8)
        .map(|i| {
            let turn = i as f32 * 0.13;
            let eye = Vec3::new(-30.0 + 1.7 * i as f32, 9.0 + 0.3 * i as f32, 38.0 - 2.3 * i as f32);
            let camera = camera(eye, eye + Vec3::new(turn.sin(), -0.25, -turn.cos()));
            let drawn = draw(device(wgpu::Backends::VULKAN), settings.clone(), &camera, &[LIGHT], &world);
            let maps = drawn.maps();
            (drawn, maps)
        })
        .collect();
    // Depths between a triangle's corners are interpolated from where it lies in the map, and round with it.
    const ROUNDING: f32 = 4e-6;
    let (mut compared, mut differing, mut moved, mut largest) = (0u64, 0u64, 0, 0f32);
    for pair in frames.windows(2) {
        let [(before, texels_before), (after, texels_after)] = pair else { unreachable!("windows of two") };
        for (a, b) in before.plan.views().iter().zip(after.plan.views()) {
            let size = i64::from(a.tile.size);
            let half = size as f64 / 2.0;
            let shift = (b.clip_from_world.w_axis - a.clip_from_world.w_axis).truncate().truncate() * half;
            let (dx, dy) = (shift.x.round() as i64, -shift.y.round() as i64);
            moved += usize::from((dx, dy) != (0, 0));
            for y in 0.max(-dy)..size.min(size - dy) {
                for x in 0.max(-dx)..size.min(size - dx) {
                    let old = texels_before.depth(a.tile, x, y);
                    let new = texels_after.depth(b.tile, x + dx, y + dy);
                    compared += 1;
                    differing += u64::from((old - new).abs() > ROUNDING);
                    largest = largest.max((old - new).abs());
                }
            }
        }
    }
    println!(
        "{differing} of {compared} texels differ by more than rounding, the rest by at most {largest}; {moved} maps moved"
    );
    assert!(moved > 20 && compared > 1_000_000, "the maps move: {moved}, and overlap: {compared}");
    assert_eq!(differing, 0, "of {compared}; largest difference {largest}");
}

#[test]
fn each_of_several_lights_has_the_shadows_it_has_alone() {
    let (world, camera) = (world(), eye());
    let queries = queries(&world, &camera, 100);
    let other = Vec3::new(-0.7, -0.6, -0.2);
    let lone = |light| {
        draw(device(wgpu::Backends::VULKAN), settings(), &camera, &[light], &world).visibility(&queries)
    };
    let (first, second) = (lone(LIGHT), lone(other));
    assert!(first != second, "the lights differ");
    for storage in [Storage::Array, Storage::Atlas] {
        let settings = Settings { storage, ..settings() };
        for (lights, expected) in [([LIGHT, other], [&first, &second]), ([other, LIGHT], [&second, &first])] {
            let drawn = draw(device(wgpu::Backends::VULKAN), settings.clone(), &camera, &lights, &world);
            for (light, expected) in (0..).zip(expected) {
                let answers = drawn.light_visibility(light, &queries);
                let differ = answers.iter().zip(expected).filter(|(a, b)| a != b).count();
                assert!(differ * 10_000 <= queries.len(), "{storage:?}, light {light}: {differ} differ");
            }
            let unknown = drawn.light_visibility(2, &queries);
            assert!(
                unknown.iter().all(|visibility| *visibility == 1.0),
                "a light that is not there casts no shadow"
            );
        }
    }
}
