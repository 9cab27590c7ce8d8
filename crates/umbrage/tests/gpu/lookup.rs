//! Two roads to one answer: the shaders' lookup on the GPU, and the same lookup in Rust on read-back maps.

use crate::common::{camera, device, draw, queries, world};
use glam::{Vec2, Vec3};
use umbrage::{Bias, DepthFormat, Filter, Fit, Place, Query, Select, Settings, Storage};

const LIGHT: Vec3 = Vec3::new(0.5, -1.0, 0.3);

fn eye() -> umbrage::Camera {
    camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::new(4.0, 0.0, -6.0))
}

/// Places all over a tile, its edges and beyond, at depths before, at and behind what is stored there.
fn places(size: f32) -> Vec<(Vec2, f32)> {
    (0..60_000u32)
        .map(|i| {
            let share = |step: f64| (f64::from(i) * step).fract() as f32;
            let texel = Vec2::new(share(0.754_877_666), share(0.569_840_29)) * (size + 6.0) - 3.0;
            (texel, share(0.437_598_1) * 1.2 - 0.1)
        })
        .collect()
}

/// How much the depth to compare with grows a texel, at the i-th place. Where depths are to be equal, along one axis and
/// of few bits: then the product with a place on the grid of [`on_grid`] is exact, and the sum is rounded once.
fn gradient(i: usize) -> Vec2 {
    let step = |n: usize| (i * n % 63) as f32 - 31.0;
    let axes = [Vec2::X, Vec2::ONE, Vec2::Y, Vec2::ONE];
    Vec2::new(step(37), step(53)) / 4096.0 * axes[i % 4]
}

/// The nearest place on a grid of sixteenths of a texel.
fn on_grid(texel: Vec2) -> Vec2 {
    (texel * 16.0).round() / 16.0
}

/// For each storage and depth format, the largest difference between the GPU's filter and Rust's but for one place in ten
/// thousand, where rounding may decide a comparison, and how many differ.
fn compare_filters(filter: Filter, receiver_plane: bool) -> Vec<(f32, usize)> {
    let mut found = Vec::new();
    for (storage, depth) in [
        (Storage::Array, DepthFormat::F32),
        (Storage::Atlas, DepthFormat::F32),
        (Storage::Atlas, DepthFormat::U16),
    ] {
        let bias = Bias { receiver_plane, ..Bias::default() };
        let settings =
            Settings { filter, storage, depth, bias, splits: 3, resolution: 256, ..Settings::default() };
        let drawn = draw(device(wgpu::Backends::VULKAN), settings, &eye(), &[LIGHT], &world());
        let maps = drawn.maps();
        let lookup = drawn.lookup(&maps);
        for view in drawn.plan.views() {
            let places: Vec<Place> = (0..)
                .zip(places(256.0))
                .map(|(i, (texel, reference))| {
                    let gradient = if receiver_plane { gradient(i) } else { Vec2::ZERO };
                    // Half of the comparisons at exactly the stored depth: equal is lit.
                    let is_equal = i % 2 == 0;
                    let texel = if receiver_plane && is_equal { on_grid(texel) } else { texel };
                    let centre = texel.floor().clamp(Vec2::ZERO, Vec2::splat(255.0)) + 0.5;
                    let stored = maps.depth(view.tile, centre.x as i64, centre.y as i64);
                    let here = stored - gradient.dot(centre - texel);
                    let reference = match depth {
                        DepthFormat::F32 if is_equal => here,
                        DepthFormat::F32 => reference,
                        // Samplers may convert a 16-bit depth, or the reference, with rounding: keep apart from equal.
                        DepthFormat::U16 if is_equal => here - 0.25 / 65535.0,
                        DepthFormat::U16 => here + 0.25 / 65535.0,
                    };
                    // Receivers beyond 0 are lit without asking a filter.
                    let texel_metres = Vec2::new(0.1, 0.14);
                    Place { texel, compare_depth: reference.max(0.0), gradient, bend: 0.0, texel_metres }
                })
                .collect();
            let gpu = drawn.filter(view.index as u32, &places);
            let asker = Query { position: Vec3::ZERO, normal: Vec3::Y, pixel: Vec2::splat(0.5) };
            let cpu = places.iter().map(|place| lookup.filter(view, place, &asker));
            let mut differences: Vec<f32> = gpu.iter().zip(cpu).map(|(gpu, cpu)| (gpu - cpu).abs()).collect();
            differences.sort_by(f32::total_cmp);
            let lit = gpu.iter().filter(|v| **v > 0.5).count();
            assert!(lit > 1000 && lit < places.len() - 1000, "{lit} of {} are lit", places.len());
            found.push((
                differences[differences.len() - 1 - differences.len() / 10_000],
                differences.iter().filter(|d| **d > 0.0).count(),
            ));
        }
    }
    found
}

#[test]
fn hard_lookups_agree_bit_for_bit() {
    for receiver_plane in [false, true] {
        for (largest, differing) in compare_filters(Filter::Hard {}, receiver_plane) {
            assert_eq!((largest, differing), (0.0, 0), "receiver plane {receiver_plane}");
        }
    }
}

#[test]
fn bilinear_lookups_agree_within_a_256th() {
    for receiver_plane in [false, true] {
        for (largest, _) in compare_filters(Filter::Bilinear {}, receiver_plane) {
            assert!(largest <= 1.0 / 256.0 + 1e-6, "receiver plane {receiver_plane}: {largest}");
        }
    }
}

#[test]
fn optimised_lookups_are_the_bell_that_they_stand_for() {
    for receiver_plane in [false, true] {
        for size in [3, 5, 7] {
            for (largest, _) in compare_filters(Filter::Optimised { size }, receiver_plane) {
                assert!(largest <= 1.0 / 256.0 + 1e-5, "{size}, receiver plane {receiver_plane}: {largest}");
            }
        }
    }
}

#[test]
fn pcf_lookups_of_every_size_agree_within_a_256th() {
    for receiver_plane in [false, true] {
        for size in [1, 3, 5, 7, 9] {
            for (largest, _) in compare_filters(Filter::Pcf { size }, receiver_plane) {
                assert!(largest <= 1.0 / 256.0 + 1e-6, "{size}, receiver plane {receiver_plane}: {largest}");
            }
        }
    }
}

#[test]
fn whole_lookups_agree_but_where_rounding_decides_a_comparison() {
    for select in [Select::Depth, Select::ClipDepth, Select::Map] {
        for (fit, receiver_plane) in [Fit::Scene, Fit::View, Fit::Stable, Fit::World]
            .into_iter()
            .flat_map(|fit| [(fit, false), (fit, true)])
        {
            let bias = Bias { slope: 0.5, receiver_plane, ..Bias::default() };
            let settings = Settings {
                select,
                fit,
                bias,
                filter: Filter::Hard {},
                resolution: 512,
                ..Settings::default()
            };
            let (world, camera) = (world(), eye());
            let drawn = draw(device(wgpu::Backends::VULKAN), settings, &camera, &[LIGHT], &world);
            let queries = queries(&world, &camera, 400);
            let maps = drawn.maps();
            let lookup = drawn.lookup(&maps);
            let gpu = drawn.visibility(&queries);
            let differ =
                queries.iter().zip(&gpu).filter(|(q, v)| lookup.visibility(0, q.position, q.normal) != **v);
            let (differ, shadowed) = (differ.count(), gpu.iter().filter(|v| **v == 0.0).count());
            assert!(
                shadowed > queries.len() / 50,
                "{select:?} {fit:?}: only {shadowed} of {} in shadow",
                queries.len()
            );
            // A coordinate a rounding error away from a texel's edge may fall on either side.
            assert!(
                differ * 2000 <= queries.len(),
                "{select:?} {fit:?}: {differ} of {} differ",
                queries.len()
            );
        }
    }
}
