//! Two roads to one answer: the shaders' lookup on the GPU, and the same lookup in Rust on read-back maps.

use crate::common::{camera, device, draw, queries, world};
use glam::{Vec2, Vec3};
use umbrage::{Bias, DepthFormat, Filter, Fit, Select, Settings, Storage};

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

/// For each storage and depth format, the largest difference between the GPU's filter and Rust's, and how many differ.
fn compare_filters(filter: Filter) -> Vec<(f32, usize)> {
    let mut found = Vec::new();
    for (storage, depth) in [
        (Storage::Array, DepthFormat::F32),
        (Storage::Atlas, DepthFormat::F32),
        (Storage::Atlas, DepthFormat::U16),
    ] {
        let settings = Settings { filter, storage, depth, splits: 3, resolution: 256, ..Settings::default() };
        let drawn = draw(device(wgpu::Backends::VULKAN), settings, &eye(), &[LIGHT], &world());
        let maps = drawn.maps();
        let lookup = drawn.lookup(&maps);
        for view in drawn.plan.views() {
            let mut places = places(256.0);
            for (i, (texel, reference)) in places.iter_mut().enumerate() {
                let stored = maps.depth(view.tile, texel.x.floor() as i64, texel.y.floor() as i64);
                match depth {
                    // Half of the comparisons at exactly the stored depth: equal is lit.
                    DepthFormat::F32 if i % 2 == 0 => *reference = stored,
                    DepthFormat::F32 => {}
                    // Samplers may convert a 16-bit depth, or the reference, with rounding: keep apart from equal.
                    DepthFormat::U16 => {
                        let steps = if i % 2 == 0 { 0.25 } else { -0.25 };
                        *reference = (stored + steps / 65535.0).clamp(0.0, 1.0);
                    }
                }
            }
            let gpu = drawn.filter(view.index as u32, &places);
            let cpu = places.iter().map(|(texel, reference)| lookup.filter(view, *texel, *reference));
            let differences: Vec<f32> = gpu.iter().zip(cpu).map(|(gpu, cpu)| (gpu - cpu).abs()).collect();
            let lit = gpu.iter().filter(|v| **v > 0.5).count();
            assert!(lit > 1000 && lit < places.len() - 1000, "{lit} of {} are lit", places.len());
            found.push((
                differences.iter().copied().fold(0.0, f32::max),
                differences.iter().filter(|d| **d > 0.0).count(),
            ));
        }
    }
    found
}

#[test]
fn hard_lookups_agree_bit_for_bit() {
    for (largest, differing) in compare_filters(Filter::Hard {}) {
        assert_eq!((largest, differing), (0.0, 0));
    }
}

#[test]
fn bilinear_lookups_agree_within_a_256th() {
    for (largest, _) in compare_filters(Filter::Bilinear {}) {
        assert!(largest <= 1.0 / 256.0 + 1e-6, "{largest}");
    }
}

#[test]
fn pcf_lookups_of_every_size_agree_within_a_256th() {
    for size in [1, 3, 5, 7, 9] {
        for (largest, _) in compare_filters(Filter::Pcf { size }) {
            assert!(largest <= 1.0 / 256.0 + 1e-6, "{size}: {largest}");
        }
    }
}

#[test]
fn whole_lookups_agree_but_where_rounding_decides_a_comparison() {
    for select in [Select::Depth, Select::ClipDepth, Select::Map] {
        for fit in [Fit::Scene, Fit::View, Fit::Stable] {
            let bias = Bias { slope: 0.5, ..Bias::default() };
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
