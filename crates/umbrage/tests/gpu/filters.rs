//! Two roads to one answer, for filters of points, of moments and of sums: the shaders, and the same in Rust on read-back
//! maps.

use glam::{Vec2, Vec3};
use umbrage::{
    Bias, Disc, Exponential, ExponentialVariance, Filter, Footprint, FourMoments, LightSize, MomentPrecision,
    NoiseSource, Pcss, Place, Precision, Prefilter, Query, Settings, Shadows, SoftMoments, Storage,
    SummedVariance, Variance, Warp,
};

use crate::common::{camera, device, device_without, draw, queries, world};

/// Who asks in `Drawn::filter`.
const ASKER: Query = Query { position: Vec3::ZERO, normal: Vec3::Y, pixel: Vec2::splat(0.5) };

const LIGHT: Vec3 = Vec3::new(0.5, -1.0, 0.3);

/// The share of places whose answers differ by more than `tolerance`, and the largest difference.
fn differences(settings: &Settings, tolerance: f32) -> (f64, f32) {
    let camera = camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::new(4.0, 0.0, -6.0));
    let drawn = draw(device(wgpu::Backends::VULKAN), settings.clone(), &camera, &[LIGHT], &world());
    let maps = drawn.maps();
    let lookup = drawn.lookup(&maps);
    let (mut differ, mut count, mut largest, mut partly) = (0, 0, 0f32, 0);
    for view in drawn.plan.views() {
        let size = view.tile.size as f32;
        let places: Vec<Place> = (0..1500)
            .map(|i| {
                let share = |step: f64| (f64::from(i) * step).fract() as f32;
                let texel = Vec2::new(share(0.754_877_666), share(0.569_840_29)) * size;
                let centre = texel.floor().as_i64vec2();
                // Around what is stored here, and behind it.
                let stored = maps.depth(view.tile, centre.x, centre.y);
                let reference = (stored - (share(0.437_598_1) - 0.3) * 0.1).clamp(0.0, 1.0);
                Place {
                    texel,
                    compare_depth: reference,
                    gradient: Vec2::ZERO,
                    bend: 0.0,
                    texel_metres: Vec2::new(0.1, 0.14),
                }
            })
            .collect();
        let gpu = drawn.filter(view.index as u32, &places);
        for (place, gpu) in places.iter().zip(&gpu) {
            let cpu = lookup.filter(view, place, &ASKER);
            assert!((0.0..=1.0).contains(gpu) && cpu.is_finite(), "{gpu}, {cpu} at {place:?}");
            let difference = (gpu - cpu).abs();
            largest = largest.max(difference);
            differ += usize::from(difference > tolerance);
            partly += usize::from(*gpu > 0.01 && *gpu < 0.99);
            count += 1;
        }
    }
    assert!(partly > count / 100, "{partly} of {count} are neither lit nor shadowed");
    (differ as f64 / count as f64, largest)
}

fn with(filter: Filter) -> Settings {
    Settings { filter, splits: 3, resolution: 256, ..Settings::default() }
}

#[test]
fn points_on_a_disc_are_where_rust_says() {
    let disc = Disc::default();
    let discs = [
        Disc { radius_texels: 3.0, noise: NoiseSource::World, ..disc },
        Disc { noise: NoiseSource::None, centred: false, taps: 4, ..disc },
        Disc { radius: Some(0.31), radius_texels: 8.0, noise: NoiseSource::World, early_out: true, ..disc },
    ];
    for disc in discs {
        for filter in [Filter::Poisson, Filter::Stratified, Filter::Rotated, Filter::Vogel].map(|of| of(disc))
        {
            for receiver_plane in [false, true] {
                let bias = Bias { receiver_plane, ..Bias::default() };
                let (share, largest) = differences(&Settings { bias, ..with(filter) }, 1.0 / 256.0);
                println!("{filter:?}, plane {receiver_plane}: {share:.4} differ, by {largest} at most");
                // A point a rounding error away from a texel's edge may fall on either side.
                assert!(share < 2e-3, "{filter:?}, plane {receiver_plane}: {share} differ");
            }
        }
    }
}

#[test]
fn a_bail_misses_only_what_lies_within_an_agreeing_rim() {
    let camera = camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::new(4.0, 0.0, -6.0));
    let world = world();
    let queries = queries(&world, &camera, 100);
    for radius_texels in [1.5, 2.5, 6.0] {
        let ask = |early_out| {
            let disc = Disc { radius_texels, noise: NoiseSource::None, early_out, ..Disc::default() };
            draw(device(wgpu::Backends::VULKAN), with(Filter::Vogel(disc)), &camera, &[LIGHT], &world)
                .visibility(&queries)
        };
        let (all, bailed) = (ask(false), ask(true));
        let missed = all.iter().zip(&bailed).filter(|(all, bailed)| all != bailed);
        // Where the rim disagrees, all points are asked, and the answer is the same.
        assert!(
            missed.clone().all(|(_, bailed)| *bailed == 0.0 || *bailed == 1.0),
            "only a early_out differs"
        );
        let rate = missed.count() as f64 / queries.len() as f64;
        let partly = all.iter().filter(|v| **v > 0.0 && **v < 1.0).count() as f64 / queries.len() as f64;
        println!(
            "{radius_texels} texels: {:.3} % missed, of {:.3} % in penumbrae",
            100.0 * rate,
            100.0 * partly
        );
        assert!(rate > 0.0 && rate < 0.3 * partly, "{radius_texels} texels: {rate} missed, of {partly}");
    }
}

#[test]
fn what_a_pixel_covers_is_what_rust_says() {
    for (receiver_plane, warp) in [(false, Warp::None), (true, Warp::None), (true, Warp::Lispsm)] {
        let bias = Bias { receiver_plane, ..Bias::default() };
        let filter = Filter::Footprint(Footprint { taps: 64, ..Footprint::default() });
        let (share, largest) = differences(&Settings { bias, warp, ..with(filter) }, 1.5 / 64.0);
        println!("footprint, plane {receiver_plane}, {warp:?}: {share:.4} differ, by {largest} at most");
        assert!(share < 5e-3, "plane {receiver_plane}, {warp:?}: {share} differ");
    }
}

#[test]
fn blockers_and_penumbrae_are_what_rust_says() {
    let light = LightSize { sun_degrees: 5.0, ..LightSize::default() };
    for receiver_plane in [false, true] {
        let bias = Bias { receiver_plane, ..Bias::default() };
        let pcss = Pcss { light, max_texels: 20.0, noise: NoiseSource::World, ..Pcss::default() };
        let (share, largest) = differences(&Settings { bias, ..with(Filter::Pcss(pcss)) }, 1.0 / 256.0);
        println!("pcss, plane {receiver_plane}: {share:.4} differ, by {largest} at most");
        // A blocker more or less moves every point of the disc.
        assert!(share < 5e-3, "plane {receiver_plane}: {share} differ");
    }
}

/// Every filter of blurred moments, with the largest difference that the way it is stored allows.
fn moments() -> Vec<(Filter, f32)> {
    let blurred = Prefilter { blur_texels: 3, ..Prefilter::default() };
    let evsm = ExponentialVariance { prefilter: blurred, ..ExponentialVariance::default() };
    let half = ExponentialVariance { precision: Precision::F16, min_standard_deviation: 0.3, ..evsm };
    let msm = FourMoments { prefilter: blurred, ..FourMoments::default() };
    vec![
        // A variance is what two squares differ by, which are near 1 in 32 bits: (1 cm)² of 100 m is a fifth of a step.
        (Filter::Vsm(Variance { prefilter: blurred, ..Variance::default() }), 0.02),
        (
            Filter::Vsm(Variance {
                prefilter: Prefilter { downsample: 2, ..blurred },
                ..Variance::default()
            }),
            0.02,
        ),
        (Filter::Esm(Exponential { prefilter: blurred, ..Exponential::default() }), 1e-4),
        (Filter::Evsm2(evsm), 1e-4),
        (Filter::Evsm4(evsm), 1e-4),
        // Four moments are told apart by a bias of 3e-7, a few roundings of a sum in 32 bits. Given the same moments, the two
        // roads agree within 1e-4: `moments.rs`.
        (Filter::Msm(msm), 0.02),
        // 16 bits round what is stored, which the Rust road does not: a float's 11, and 65,535 steps of a whole number.
        (Filter::Evsm2(half), 0.3),
        (Filter::Evsm4(half), 0.3),
        (Filter::Msm(FourMoments { precision: MomentPrecision::U16, ..msm }), 0.05),
    ]
}

#[test]
fn blurred_moments_are_what_rust_makes_of_the_depths() {
    for (filter, tolerance) in moments() {
        for (storage, warp) in [(Storage::Array, Warp::None), (Storage::Atlas, Warp::Lispsm)] {
            let (share, largest) = differences(&Settings { storage, warp, ..with(filter) }, tolerance);
            println!("{filter:?}, {storage:?}: {share:.4} differ, by {largest} at most");
            assert!(
                share < 0.01,
                "{filter:?}, {storage:?}: {share} differ by more than {tolerance}, at most {largest}"
            );
        }
    }
}

/// The share of receivers whose visibility differs by more than a 50th between two devices, and the largest difference.
fn between_devices(filter: Filter, without: wgpu::Features) -> (f64, f32) {
    let camera = camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::new(4.0, 0.0, -6.0));
    let world = world();
    let queries = queries(&world, &camera, 20);
    let visibility = |device| draw(device, with(filter), &camera, &[LIGHT], &world).visibility(&queries);
    let backend = wgpu::Backends::VULKAN;
    let (all, fewer) = (visibility(device(backend)), visibility(device_without(backend, without)));
    assert!(all.iter().filter(|v| **v > 0.01 && **v < 0.99).count() > 100, "some are between");
    let differences: Vec<f32> = all.iter().zip(&fewer).map(|(a, b)| (a - b).abs()).collect();
    let differ = differences.iter().filter(|d| **d > 0.02).count();
    (differ as f64 / differences.len() as f64, differences.into_iter().fold(0.0, f32::max))
}

#[test]
fn a_device_with_fewer_formats_draws_the_same() {
    let msm = FourMoments { precision: MomentPrecision::U16, ..FourMoments::default() };
    let half = ExponentialVariance { precision: Precision::F16, ..ExponentialVariance::default() };
    let unorm = wgpu::Features::TEXTURE_FORMAT_16BIT_NORM;
    let special = wgpu::Features::TEXTURE_ADAPTER_SPECIFIC_FORMAT_FEATURES;
    let filterable = wgpu::Features::FLOAT32_FILTERABLE;
    for (filter, without) in [
        (Filter::Msm(msm), unorm),
        (Filter::Msm(FourMoments::default()), filterable),
        (Filter::Evsm2(half), special),
        (Filter::Vsm(Variance::default()), filterable),
        (Filter::Esm(Exponential::default()), filterable),
        (Filter::Msm(msm), unorm | filterable | special),
    ] {
        let (differ, largest) = between_devices(filter, without);
        println!("{filter:?} without {without:?}: {differ:.5} differ, by {largest} at most");
        // Samplers weigh in other sums than shaders, and what moments say of next to no variance is made of such rounding.
        assert!(differ < 1e-2, "{filter:?} without {without:?}: {differ} differ, by {largest} at most");
    }
}

#[test]
fn no_filter_reads_over_the_sides_of_its_tile() {
    // Whatever lies beside a tile of an atlas is another view. Along all four sides, places give what they give in an array,
    // where there is nothing beside.
    let camera = camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::new(4.0, 0.0, -6.0));
    let world = world();
    let blurred = Prefilter { blur_texels: 6, ..Prefilter::default() };
    // Without anisotropy: lavapipe's lookups along a footprint differ by the size of the texture, even where it is a point.
    let sizes = Prefilter { mip_levels: 3, ..blurred };
    let filters = [
        Filter::Pcf { size: 9 },
        Filter::Vogel(Disc { radius_texels: 6.0, ..Disc::default() }),
        Filter::Pcss(Pcss {
            light: LightSize { sun_degrees: 20.0, ..LightSize::default() },
            ..Pcss::default()
        }),
        Filter::Evsm4(ExponentialVariance { prefilter: blurred, ..ExponentialVariance::default() }),
        Filter::Esm(Exponential { prefilter: sizes, ..Exponential::default() }),
        Filter::Savsm(SummedVariance {
            radius_texels: 6.0,
            min_standard_deviation: 0.1,
            ..SummedVariance::default()
        }),
    ];
    for filter in filters {
        let answers = [Storage::Array, Storage::Atlas].map(|storage| {
            let settings = Settings { storage, splits: 4, ..with(filter) };
            let drawn = draw(device(wgpu::Backends::VULKAN), settings, &camera, &[LIGHT], &world);
            let maps = drawn.maps();
            let rim = |view: &umbrage::ShadowView| -> Vec<Place> {
                let size = view.tile.size as f32;
                (0..400)
                    .map(|i| {
                        let (along, across) = (size * (i / 4) as f32 / 100.0, 0.3 + (i % 7) as f32);
                        let texel = [
                            Vec2::new(along, across),
                            Vec2::new(across, along),
                            Vec2::new(along, size - across),
                            Vec2::new(size - across, along),
                        ][i % 4];
                        let centre = texel.as_i64vec2();
                        let reference =
                            (maps.depth(view.tile, centre.x, centre.y) - 0.01 * (i % 3) as f32).max(0.001);
                        Place {
                            texel,
                            compare_depth: reference,
                            gradient: Vec2::ZERO,
                            bend: 0.0,
                            texel_metres: Vec2::splat(0.1),
                        }
                    })
                    .collect()
            };
            let views = drawn.plan.views();
            views.iter().flat_map(|view| drawn.filter(view.index as u32, &rim(view))).collect::<Vec<f32>>()
        });
        let differ = answers[0].iter().zip(&answers[1]).filter(|(a, b)| (**a - **b).abs() > 0.02).count();
        println!("{filter:?}: {differ} of {} places along the sides differ", answers[0].len());
        assert!(differ * 200 <= answers[0].len(), "{filter:?}: {differ} of {} differ", answers[0].len());
    }
}

#[test]
fn gl_refuses_by_name_what_needs_depths_as_numbers() {
    let (device, _) = device(wgpu::Backends::GL);
    for filter in [Filter::Pcss(Pcss::default()), Filter::Msm(FourMoments::default())] {
        let refused =
            Shadows::new(&device, with(filter)).expect_err("GL compares depths, and cannot read them");
        assert!(refused.to_string().contains("read depths as numbers"), "{refused}");
    }
}

#[test]
fn a_change_of_filter_leaves_nothing_of_the_one_before() {
    // On one device, one filter after another and back: what was compiled or bound for one must not serve another.
    let camera = camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::new(4.0, 0.0, -6.0));
    let world = world();
    let queries = queries(&world, &camera, 10);
    let shared = device(wgpu::Backends::VULKAN);
    let filters: Vec<Filter> = moments().into_iter().map(|(filter, _)| filter).collect();
    let others = [
        Filter::Hard {},
        Filter::Pcss(Pcss::default()),
        Filter::Savsm(SummedVariance::default()),
        Filter::Mssm(SoftMoments { max_texels: 16.0, ..SoftMoments::default() }),
    ];
    let all: Vec<Filter> = others.into_iter().chain(filters).collect();
    let ask = |device, filter| draw(device, with(filter), &camera, &[LIGHT], &world).visibility(&queries);
    for filter in all.iter().chain(all.iter().rev()) {
        let (in_turn, alone) = (ask(shared.clone(), *filter), ask(device(wgpu::Backends::VULKAN), *filter));
        assert!(in_turn == alone, "{filter:?} depends on what was drawn before");
        assert!(
            alone.iter().any(|v| *v > 0.9) && alone.iter().any(|v| *v < 0.1),
            "{filter:?} is all of one kind"
        );
    }
}

#[test]
fn sums_over_boxes_are_what_rust_adds_up() {
    let light = LightSize { sun_degrees: 5.0, ..LightSize::default() };
    let savsm = SummedVariance { radius_texels: 4.3, ..SummedVariance::default() };
    let filters = [
        (Filter::Savsm(savsm), 0.02),
        (Filter::Savsm(SummedVariance { radius: Some(0.5), radius_texels: 8.0, ..savsm }), 0.02),
        (Filter::Mssm(SoftMoments { light, max_texels: 16.0, ..SoftMoments::default() }), 0.02),
    ];
    for (filter, tolerance) in filters {
        for storage in [Storage::Array, Storage::Atlas] {
            let (share, largest) = differences(&Settings { storage, ..with(filter) }, tolerance);
            println!("{filter:?}, {storage:?}: {share:.4} differ, by {largest} at most");
            assert!(
                share < 0.02,
                "{filter:?}, {storage:?}: {share} differ by more than {tolerance}, at most {largest}"
            );
        }
    }
}
