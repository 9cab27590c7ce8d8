//! `cargo bench -p umbrage-core` says in less than a minute how long planning a frame takes, technique by technique.

use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use glam::Vec3;
use umbrage_core::{Aabb, Bounds, Camera, ConvexVolume, Fit, Light, Projection, Settings, Warp, plan};

/// What is planned, and whether the objects of the world matter to it.
struct Technique {
    name: &'static str,
    settings: Settings,
    lights: Vec<Light>,
    looks_at_objects: bool,
}

fn sun() -> Vec<Light> {
    vec![Light::directional(Vec3::new(0.5, -1.0, 0.3)).expect("a sun")]
}

fn spots(count: usize) -> Vec<Light> {
    let spot = |i: usize| {
        let apex = Vec3::new((i % 4) as f32 * 60.0 - 90.0, 30.0, 300.0 - (i / 4) as f32 * 80.0);
        Light::spot(apex, Vec3::new(0.2, -1.0, -0.4), 0.7, 120.0).expect("a spot")
    };
    (0..count).map(spot).collect()
}

fn techniques() -> Vec<Technique> {
    let of_sun = |name, splits, warp| Technique {
        name,
        settings: Settings { splits, warp, ..Settings::default() },
        lights: sun(),
        looks_at_objects: true,
    };
    let of_spots = |name, count, spot_splits, warp| Technique {
        name,
        settings: Settings { spot_splits, warp, ..Settings::default() },
        lights: spots(count),
        looks_at_objects: true,
    };
    let blind = |name, splits, fit| Technique {
        settings: Settings { fit, splits, ..Settings::default() },
        looks_at_objects: false,
        ..of_sun(name, splits, Warp::None)
    };
    vec![
        of_sun("SSM", 1, Warp::None),
        of_sun("PSM", 1, Warp::Psm),
        of_sun("LiSPSM", 1, Warp::Lispsm),
        of_sun("TSM", 1, Warp::Tsm),
        of_sun("PSSM(3)", 3, Warp::None),
        of_sun("PSSM(3) + PSM", 3, Warp::Psm),
        of_sun("PSSM(3) + LiSPSM", 3, Warp::Lispsm),
        of_sun("PSSM(3) + TSM", 3, Warp::Tsm),
        of_sun("PSSM(4)", 4, Warp::None),
        of_sun("PSSM(4) + PSM", 4, Warp::Psm),
        of_sun("PSSM(4) + LiSPSM", 4, Warp::Lispsm),
        of_sun("PSSM(4) + TSM", 4, Warp::Tsm),
        blind("PSSM(4), view fit", 4, Fit::View),
        blind("PSSM(4), stable fit", 4, Fit::Stable),
        of_spots("a spot", 1, 1, Warp::None),
        of_spots("a spot + LiSPSM", 1, 1, Warp::Lispsm),
        of_spots("a spot, 3 splits", 1, 3, Warp::None),
        of_spots("12 spots", 12, 1, Warp::None),
        Technique {
            name: "a point light",
            settings: Settings::default(),
            lights: vec![Light::point(Vec3::new(0.0, 15.0, 300.0), 120.0).expect("a point light")],
            looks_at_objects: false,
        },
    ]
}

/// Boxes of 10 × 20 × 10 m on a lattice, 37 m apart, in a world that is a little larger.
fn world(objects: usize) -> Bounds {
    let row = (objects as f32).sqrt().ceil() as usize;
    let half = (row as f32 * 37.0 * 0.5).max(600.0);
    let boxes = (0..objects).map(|i| {
        let min = Vec3::new((i % row) as f32 * 37.0 - half, 0.0, (i / row) as f32 * 37.0 - half);
        Aabb { min, max: min + Vec3::new(10.0, 20.0, 10.0) }
    });
    let world = Aabb { min: Vec3::new(-half, 0.0, -half), max: Vec3::new(half, 40.0, half) };
    Bounds::within(world, boxes.collect())
}

fn plans(criterion: &mut Criterion) {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.6 };
    let camera = Camera::looking(Vec3::new(0.0, 20.0, 400.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 800.0);
    let camera = camera.expect("a good camera");
    let worlds = [("box only", world(0)), ("1000 objects", world(1000)), ("50000 objects", world(50_000))];
    for Technique { name, settings, lights, looks_at_objects } in techniques() {
        for (contents, bounds) in worlds.iter().take(if looks_at_objects { 3 } else { 1 }) {
            let mut reused = plan(&camera, &lights, bounds, &settings).expect("a plan");
            criterion.bench_function(&format!("{name}, {contents}"), |bencher| {
                bencher.iter(|| reused.replan(&camera, &lights, bounds, &settings));
            });
        }
    }
}

/// Telling a world's bounds what moved, and finding what a camera sees of it.
fn moves(criterion: &mut Criterion) {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.6 };
    let camera = Camera::looking(Vec3::new(0.0, 20.0, 400.0), Vec3::ZERO, Vec3::Y, projection, 1.0, 800.0);
    let seen = ConvexVolume::of_clip(&camera.expect("a good camera").clip_from_world());
    let mut bounds = world(50_000);
    criterion.bench_function("what is seen of 50000 objects", |bencher| {
        bencher.iter(|| {
            let mut count = 0;
            bounds.touching(&seen, |_| count += 1);
            count
        });
    });
    let home = bounds.objects().to_vec();
    for (name, every) in [("1 in 100", 100), ("all", 1)] {
        let mut aside = 0.0;
        criterion.bench_function(&format!("{name} of 50000 objects move"), |bencher| {
            bencher.iter(|| {
                aside = 1.0 - aside;
                let moved = home.iter().enumerate().step_by(every).map(|(i, at)| {
                    let [min, max] = [at.min, at.max].map(|corner| corner + Vec3::X * aside);
                    (i, Aabb { min, max })
                });
                bounds.set(moved);
            });
        });
    }
}

/// A plan takes microseconds: half a second sees thousands.
fn short() -> Criterion {
    Criterion::default()
        .sample_size(30)
        .warm_up_time(Duration::from_millis(150))
        .measurement_time(Duration::from_millis(500))
}

criterion_group! { name = benches; config = short(); targets = plans, moves }
criterion_main!(benches);
